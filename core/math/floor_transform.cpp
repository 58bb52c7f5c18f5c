#include "math/floor_transform.h"

#include <cmath>
#include <numbers>

namespace stridegraph {
namespace {

/// Sine by its Taylor series to x^15, below 1e-15 for |x| <= pi / 4.
double sineSeries(double x) {
  const double xx = x * x;
  double sum = 0.0;
  for (int k = 15; k >= 3; k -= 2) sum = (1.0 + sum) * (-xx / static_cast<double>(k * (k - 1)));
  return x * (1.0 + sum);
}

/// Cosine by its Taylor series to x^16.
double cosineSeries(double x) {
  const double xx = x * x;
  double sum = 0.0;
  for (int k = 16; k >= 2; k -= 2) sum = (1.0 + sum) * (-xx / static_cast<double>(k * (k - 1)));
  return 1.0 + sum;
}

}  // namespace

Heading Heading::fromAngle(Angle angle) {
  constexpr double kQuarter = std::numbers::pi / 2.0;
  const double wrapped = angle.wrapped().radians();
  const double quarters = std::nearbyint(wrapped / kQuarter);
  const double rest = wrapped - quarters * kQuarter;
  const double s = sineSeries(rest);
  const double c = cosineSeries(rest);
  switch ((static_cast<int>(quarters) + 4) % 4) {
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    case 3:
      return {-c, s};
    default:
      return {s, c};
  }
}

Heading Heading::alongDirection(const Vec2& direction) {
  return Heading::normalised(direction.x(), direction.y());
}

Angle Heading::angle() const {
  return Angle::radians(std::atan2(sin, cos));
}

Quat Heading::rotation() const {
  // Half-angle formulas; the larger of the two is taken from the root, so that nothing cancels.
  if (cos >= 0.0) {
    const double w = std::sqrt((1.0 + cos) / 2.0);
    return {w, 0.0, sin / (2.0 * w), 0.0};
  }
  const double y = std::copysign(std::sqrt((1.0 - cos) / 2.0), sin);
  return {sin / (2.0 * y), 0.0, y, 0.0};
}

Heading blend(const Heading& from, const Heading& to, double fraction) {
  return Heading::normalised(from.sin + (to.sin - from.sin) * fraction,
                             from.cos + (to.cos - from.cos) * fraction);
}

Vec3 FloorTransform::apply(const Vec3& point) const {
  const Vec2 floor = *this * onFloor(point);
  return {floor.x(), point.y(), floor.y()};
}

}  // namespace stridegraph
