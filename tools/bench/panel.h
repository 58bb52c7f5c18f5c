#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "bench/chart.h"
#include "figures/svg.h"

namespace stridegraph::bench {

/// A diagram of the picture with its heading, as wide as the picture or half of that.
struct Panel {
  std::string title;
  std::string about;
  std::vector<SeriesStyle> legend;
  bool isWide = false;
  double heightPixels = 210.0;  ///< Of the diagram's frame.
  std::function<void(figures::Svg&, const figures::PixelBox&)> draw;
};

/// The colour of a series by its number; they come round again.
std::string_view colourOf(std::size_t series);

/// Each of the names that `get` gives of the values once, in the order in which they come.
template <typename Values, typename Get>
std::vector<std::string> distinct(const Values& values, const Get& get) {
  std::vector<std::string> found;
  for (const auto& value : values) {
    const std::string name = get(value);
    if (std::find(found.begin(), found.end(), name) == found.end()) found.push_back(name);
  }
  return found;
}

/// Where a name is among others; their number where it is not.
std::size_t indexIn(const std::vector<std::string>& names, const std::string& name);
std::size_t indexIn(const std::vector<SeriesStyle>& series, const std::string& name);

/// A series for each name, in the colours' order.
std::vector<SeriesStyle> seriesOf(const std::vector<std::string>& names);

}  // namespace stridegraph::bench
