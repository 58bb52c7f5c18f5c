#include "scene/degrees.h"

#include <cmath>
#include <initializer_list>

namespace stridegraph {

double degreesThatGive(Angle angle) {
  const double degrees = angle.degrees();
  const auto gives = [&](double candidate) { return Angle::degrees(candidate) == angle; };
  // Most headings were typed or snapped: try few decimals first.
  for (const double unit : {1.0, 10.0, 100.0, 1e3, 1e4, 1e6, 1e9}) {
    const double rounded = std::round(degrees * unit) / unit;
    if (gives(rounded)) return rounded;
  }
  if (gives(degrees)) return degrees;
  for (const double towards : {-HUGE_VAL, HUGE_VAL}) {
    double neighbour = degrees;
    for (int i = 0; i < 3; ++i) {
      neighbour = std::nextafter(neighbour, towards);
      if (gives(neighbour)) return neighbour;
    }
  }
  return degrees;
}

}  // namespace stridegraph
