#include "bench/panel.h"

#include <array>

#include "figures/palette.h"

namespace stridegraph::bench {
namespace {

namespace palette = figures::palette;

constexpr std::array<std::string_view, 6> kColours = {palette::kCaptured, palette::kPath,  palette::kBlended,
                                                      palette::kStart,    palette::kRight, palette::kRoadmap};

}  // namespace

std::string_view colourOf(std::size_t series) {
  return kColours[series % kColours.size()];
}

std::size_t indexIn(const std::vector<std::string>& names, const std::string& name) {
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

std::size_t indexIn(const std::vector<SeriesStyle>& series, const std::string& name) {
  return indexIn(distinct(series, [](const SeriesStyle& style) { return style.name; }), name);
}

std::vector<SeriesStyle> seriesOf(const std::vector<std::string>& names) {
  std::vector<SeriesStyle> series;
  for (const std::string& name : names) series.push_back({name, colourOf(series.size()), false});
  return series;
}

}  // namespace stridegraph::bench
