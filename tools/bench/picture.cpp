#include "bench/picture.h"

#include <algorithm>
#include <span>

#include "bench/curve_panels.h"
#include "bench/map_panels.h"
#include "figures/axes.h"

namespace stridegraph::bench {
namespace {

using figures::PixelBox;
using figures::Svg;

constexpr double kWidthPixels = 1180.0;
constexpr double kMarginPixels = 28.0;
constexpr double kGutterPixels = 34.0;
constexpr double kScalePixels = 58.0;  ///< Left of a diagram: numbers and what they are.
constexpr double kTitlePixels = 46.0;  ///< Above it: title and explanation; a legend comes below.
constexpr double kNamesPixels = 58.0;  ///< Below it.

std::vector<Panel> panelsOf(const BenchDocument& document) {
  std::vector<Panel> panels;
  for (const auto& part : {mapPanels(document), randomPanels(document), growthPanels(document)})
    panels.insert(panels.end(), part.begin(), part.end());
  return panels;
}

/// A panel and where its diagram goes.
struct Placed {
  const Panel* panel;
  double top;
  PixelBox frame;
};

double panelWidth(const Panel& panel) {
  const double whole = kWidthPixels - 2.0 * kMarginPixels;
  return panel.isWide ? whole : 0.5 * (whole - kGutterPixels);
}

/// Heading, explanation and legend.
double headingPixels(const Panel& panel) {
  return kTitlePixels + kLegendLinePixels * static_cast<double>(legendLines(panelWidth(panel), panel.legend));
}

/// Wide panels have a row of their own, the others share one by twos. Returns the height of all.
double place(const std::vector<Panel>& panels, std::vector<Placed>& placed) {
  double top = kMarginPixels;
  for (std::size_t p = 0; p < panels.size();) {
    const bool isPair = !panels[p].isWide && p + 1 < panels.size() && !panels[p + 1].isWide;
    const auto row = std::span(panels).subspan(p, isPair ? 2 : 1);
    double heading = 0.0;
    double height = 0.0;
    for (const Panel& panel : row) {
      heading = std::max(heading, headingPixels(panel));
      height = std::max(height, panel.heightPixels);
    }
    double left = kMarginPixels;
    for (const Panel& panel : row) {
      const double right = left + panelWidth(panel);
      placed.push_back({&panel, top, {left + kScalePixels, top + heading, right, top + heading + height}});
      left = right + kGutterPixels;
    }
    top += heading + height + kNamesPixels;
    p += row.size();
  }
  return top + 0.5 * kMarginPixels;
}

}  // namespace

Svg benchPicture(const BenchDocument& document) {
  const std::vector<Panel> panels = panelsOf(document);
  std::vector<Placed> placed;
  const double height = place(panels, placed);
  Svg svg(kWidthPixels, height, "Speed and quality of walks, measured");
  for (const Placed& at : placed) {
    const Vec2 corner(at.frame.left - kScalePixels, at.top + 12.0);
    figures::drawHeading(svg, corner, at.panel->title, at.panel->about);
    drawSeriesLegend(svg, corner + Vec2(0.0, 40.0), panelWidth(*at.panel), at.panel->legend);
    at.panel->draw(svg, at.frame);
  }
  return svg;
}

}  // namespace stridegraph::bench
