#include "bench/picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <span>

#include "bench/chart.h"
#include "bench/summary.h"
#include "figures/axes.h"
#include "figures/palette.h"
#include "walk/plan.h"

namespace stridegraph::bench {
namespace {

namespace palette = figures::palette;
using figures::PixelBox;
using figures::Svg;

constexpr double kWidthPixels = 1180.0;
constexpr double kMarginPixels = 28.0;
constexpr double kGutterPixels = 34.0;
constexpr double kScalePixels = 58.0;  ///< Left of a diagram: numbers and what they are.
constexpr double kTitlePixels = 46.0;  ///< Above it: title and explanation; a legend comes below.
constexpr double kNamesPixels = 58.0;  ///< Below it.
constexpr double kFrameMilliseconds = 1000.0 / 60.0;

constexpr std::array<std::string_view, 6> kColours = {palette::kCaptured, palette::kPath,  palette::kBlended,
                                                      palette::kStart,    palette::kRight, palette::kRoadmap};

std::string_view colourOf(std::size_t series) {
  return kColours[series % kColours.size()];
}

/// A diagram with its heading, as wide as the picture or half of that.
struct Panel {
  std::string title;
  std::string about;
  std::vector<SeriesStyle> legend;
  bool isWide = false;
  double heightPixels = 210.0;  ///< Of the diagram's frame.
  std::function<void(Svg&, const PixelBox&)> draw;
};

template <typename Values, typename Get>
std::vector<std::string> distinct(const Values& values, const Get& get) {
  std::vector<std::string> found;
  for (const auto& value : values) {
    const std::string name = get(value);
    if (std::find(found.begin(), found.end(), name) == found.end()) found.push_back(name);
  }
  return found;
}

std::size_t indexIn(const std::vector<std::string>& names, const std::string& name) {
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

/// What the panels about maps are drawn from: only maps where there is a way.
struct MapData {
  std::vector<Summary> rows;
  std::vector<std::string> maps;
  std::vector<std::string> libraries;

  /// "01" of "01_empty" where maps are numbered.
  std::vector<std::string> shortNames() const {
    std::vector<std::string> names;
    for (const std::string& map : maps) {
      const bool isNumbered = !map.empty() && map.front() >= '0' && map.front() <= '9';
      names.push_back(isNumbered ? map.substr(0, map.find('_')) : map);
    }
    return names;
  }
};

MapData mapData(const BenchDocument& document) {
  MapData data;
  for (Summary& row : summariesByRoom(document.runs, kMapsSet))
    if (row.shortestMetres) data.rows.push_back(std::move(row));
  data.maps = distinct(data.rows, [](const Summary& row) { return row.room; });
  data.libraries = distinct(data.rows, [](const Summary& row) { return row.library; });
  std::erase(data.libraries, std::string());
  return data;
}

std::vector<Summary> guidedRows(const MapData& data) {
  std::vector<Summary> rows;
  for (const Summary& row : data.rows)
    if (row.method == searchName(SearchKind::kGuided)) rows.push_back(row);
  return rows;
}

/// For each library one style, and another for Node.js where that was measured.
std::vector<SeriesStyle> librarySeries(const std::vector<std::string>& libraries) {
  std::vector<SeriesStyle> series;
  for (std::size_t l = 0; l < libraries.size(); ++l) series.push_back({libraries[l], colourOf(l), false});
  return series;
}

/// Where the marks of a series lie in the stripe of a name: -0.5..0.5.
double shiftOf(std::size_t series, std::size_t count) {
  return 0.84 * ((static_cast<double>(series) + 0.5) / static_cast<double>(count) - 0.5);
}

double largest(const std::vector<Summary>& rows, Spread Summary::*figure) {
  double value = 0.0;
  for (const Summary& row : rows) value = std::max(value, (row.*figure).worst);
  return value;
}

double smallest(const std::vector<Summary>& rows, Spread Summary::*figure) {
  double value = 1e9;
  for (const Summary& row : rows)
    if ((row.*figure).median > 0.0) value = std::min(value, (row.*figure).median);
  return value;
}

void drawFrameTime(Svg& svg, const Chart& chart) {
  const double y = chart.y(kFrameMilliseconds);
  svg.line({chart.frame().left, y}, {chart.frame().right, y}, {.stroke = palette::kGoal, .dashes = "5 4"});
  svg.text({chart.frame().left + 6.0, y - 5.0}, "one frame at 60 Hz",
           {11.0, figures::Anchor::kStart, palette::kGoal});
}

Panel timePanel(const MapData& data) {
  Panel panel{
      "Time to a walk",
      "Path, search and synthesis together: the median of all seeds as a dot, a line up to the worst. "
      "Hollow: in Node.js.",
      librarySeries(data.libraries),
      true,
      250.0,
      {}};
  panel.draw = [data](Svg& svg, const PixelBox& frame) {
    const std::vector<Summary> rows = guidedRows(data);
    Chart chart(frame,
                Scale::logarithmic(smallest(rows, &Summary::totalMilliseconds),
                                   largest(rows, &Summary::totalMilliseconds)),
                "milliseconds");
    chart.setNames(data.maps);
    chart.drawFrame(svg);
    drawFrameTime(svg, chart);
    for (const Summary& row : rows) {
      const std::size_t library = indexIn(data.libraries, row.library);
      const bool isNode = row.place != "native";
      const double x = chart.xOf(indexIn(data.maps, row.room),
                                 shiftOf(2 * library + (isNode ? 1 : 0), 2 * data.libraries.size()));
      drawSpread(svg, chart, x, row.totalMilliseconds.median, row.totalMilliseconds.worst,
                 {"", colourOf(library), isNode});
    }
  };
  return panel;
}

Panel lengthPanel(const MapData& data) {
  Panel panel{
      "Length over the shortest path",
      "How much farther the root goes than the body's disc would have to; 1 is the exact shortest path.",
      {},
      true,
      150.0,
      {}};
  panel.draw = [data](Svg& svg, const PixelBox& frame) {
    const std::vector<Summary> rows = guidedRows(data);
    Chart chart(frame, Scale::linear(1.0, std::max(1.1, largest(rows, &Summary::lengthRatio))), "ratio");
    chart.setNames(data.maps);
    chart.drawFrame(svg);
    for (const Summary& row : rows) {
      if (row.place != "native" || row.arrived == 0) continue;
      const std::size_t library = indexIn(data.libraries, row.library);
      const double x = chart.xOf(indexIn(data.maps, row.room), shiftOf(library, data.libraries.size()));
      drawSpread(svg, chart, x, row.lengthRatio.median, row.lengthRatio.worst,
                 {"", colourOf(library), false});
    }
  };
  return panel;
}

std::vector<SeriesStyle> methodSeries(const std::vector<Summary>& rows) {
  std::vector<SeriesStyle> series;
  for (const std::string& method : distinct(rows, [](const Summary& row) { return row.method; }))
    series.push_back({method, colourOf(series.size()), false});
  return series;
}

std::size_t seriesOf(const std::vector<SeriesStyle>& series, const std::string& name) {
  return static_cast<std::size_t>(std::find_if(series.begin(), series.end(),
                                               [&](const SeriesStyle& style) { return style.name == name; }) -
                                  series.begin());
}

/// Bars: for each map and method the share of runs that are sound.
Panel searchesPanel(const MapData& data) {
  std::vector<Summary> rows;
  for (const Summary& row : data.rows)
    if (row.library == data.libraries.front() && row.place == "native") rows.push_back(row);
  const std::vector<SeriesStyle> series = methodSeries(rows);
  Panel panel{"Three searches",
              fmt::format("Share of seeds that give a sound walk: there, and nothing touched ({}).",
                          data.libraries.front()),
              series,
              false,
              190.0,
              {}};
  panel.draw = [data, rows, series](Svg& svg, const PixelBox& frame) {
    Chart chart(frame, Scale::linear(0.0, 100.0), "sound, %");
    chart.setNames(data.shortNames());
    chart.drawFrame(svg);
    const double half = 0.36 * chart.stripePixels() / static_cast<double>(series.size());
    for (const Summary& row : rows) {
      const std::size_t method = seriesOf(series, row.method);
      const double x = chart.xOf(indexIn(data.maps, row.room), shiftOf(method, series.size()));
      const double share = 100.0 * static_cast<double>(row.sound) / static_cast<double>(row.runs);
      // Nothing sound shows as a line on the floor, so that it is seen to have been tried.
      const double top = std::min(chart.y(share), frame.bottom - 1.5);
      svg.rectangle({x - half, top, x + half, frame.bottom}, {.fill = series[method].colour}, 1.0);
    }
  };
  return panel;
}

Panel pathsPanel(const MapData& data) {
  std::vector<Summary> rows;
  for (const Summary& row : data.rows)
    if (row.library.empty()) rows.push_back(row);
  const std::vector<SeriesStyle> series = methodSeries(rows);
  Panel panel{"Paths of the disc",
              "Median and worst of all seeds; without making the room ready.",
              series,
              false,
              190.0,
              {}};
  panel.draw = [data, rows, series](Svg& svg, const PixelBox& frame) {
    Chart chart(frame, Scale::logarithmic(0.01, largest(rows, &Summary::pathMilliseconds)), "milliseconds");
    chart.setNames(data.shortNames());
    chart.drawFrame(svg);
    for (const Summary& row : rows) {
      const std::size_t method = seriesOf(series, row.method);
      const double x = chart.xOf(indexIn(data.maps, row.room), shiftOf(method, series.size()));
      drawSpread(svg, chart, x, row.pathMilliseconds.median, row.pathMilliseconds.worst, series[method]);
    }
  };
  return panel;
}

/// How large a share of the runs was done by which time: x, y of a curve that grows.
std::vector<Vec2> cumulated(std::vector<double> milliseconds, const Chart& chart) {
  std::sort(milliseconds.begin(), milliseconds.end());
  std::vector<Vec2> curve;
  for (std::size_t i = 0; i < milliseconds.size(); ++i) {
    const double share = 100.0 * static_cast<double>(i + 1) / static_cast<double>(milliseconds.size());
    curve.emplace_back(chart.x(milliseconds[i]), chart.y(share));
  }
  return curve;
}

Panel randomPanel(const BenchDocument& document) {
  std::vector<BenchRun> runs;
  for (const BenchRun& run : document.runs)
    if (run.set == kRandomSet) runs.push_back(run);
  const std::vector<std::string> libraries = distinct(runs, [](const BenchRun& run) { return run.library; });
  Panel panel{"Random rooms",
              "Share of rooms with a walk, or a refusal, by that time. Dashed: in Node.js.",
              librarySeries(libraries),
              false,
              210.0,
              {}};
  panel.draw = [runs, libraries](Svg& svg, const PixelBox& frame) {
    const auto times = [&](const std::string& library, bool isNode) {
      std::vector<double> milliseconds;
      for (const BenchRun& run : runs)
        if (run.library == library && (run.place != "native") == isNode)
          milliseconds.push_back(run.totalMilliseconds);
      return milliseconds;
    };
    double quickest = 10.0;
    double slowest = 10.0;
    for (const BenchRun& run : runs) {
      quickest = std::min(quickest, run.totalMilliseconds);
      slowest = std::max(slowest, run.totalMilliseconds);
    }
    Chart chart(frame, Scale::linear(0.0, 100.0), "rooms, %");
    chart.setX(Scale::logarithmic(std::max(0.01, quickest), slowest), "milliseconds");
    chart.drawFrame(svg);
    for (std::size_t l = 0; l < libraries.size(); ++l) {
      svg.polyline(cumulated(times(libraries[l], false), chart),
                   {.stroke = colourOf(l), .strokePixels = 2.0});
      svg.polyline(cumulated(times(libraries[l], true), chart),
                   {.stroke = colourOf(l), .strokePixels = 1.4, .dashes = "4 3"});
    }
  };
  return panel;
}

/// Every figure of a kind of growth that is a time, over the size.
Panel growthPanel(const BenchDocument& document, const std::string& what) {
  std::vector<GrowthRow> rows;
  for (const GrowthRow& row : document.growth)
    if (row.what == what && row.size > 0.0) rows.push_back(row);
  std::vector<SeriesStyle> series;
  for (const auto& [name, value] : rows.front().figures)
    if (name.ends_with(" ms") || name.ends_with(" s"))
      series.push_back({name, colourOf(series.size()), false});
  std::vector<SeriesStyle> legend = series;
  for (SeriesStyle& entry : legend) entry.name.resize(entry.name.rfind(' '));
  Panel panel{fmt::format("Growth with {}", what), "Times over how much there is.", legend, false, 210.0, {}};
  panel.draw = [rows, series, what](Svg& svg, const PixelBox& frame) {
    std::vector<std::vector<Vec2>> curves(series.size());
    double low = 1e9;
    double high = 0.0;
    for (const GrowthRow& row : rows) {
      for (const auto& [name, value] : row.figures) {
        const std::size_t of = seriesOf(series, name);
        if (of == series.size() || value <= 0.0) continue;
        const double milliseconds = name.ends_with(" ms") ? value : 1000.0 * value;
        curves[of].emplace_back(row.size, milliseconds);
        low = std::min(low, milliseconds);
        high = std::max(high, milliseconds);
      }
    }
    Chart chart(frame, Scale::logarithmic(low, high), "milliseconds");
    chart.setX(Scale::logarithmic(rows.front().size, rows.back().size), what);
    chart.drawFrame(svg);
    for (std::size_t s = 0; s < series.size(); ++s) {
      for (Vec2& point : curves[s]) point = {chart.x(point.x()), chart.y(point.y())};
      svg.polyline(curves[s], {.stroke = series[s].colour, .strokePixels = 2.0});
      for (const Vec2& point : curves[s]) svg.circle(point, 3.0, {.fill = series[s].colour});
    }
  };
  return panel;
}

std::vector<Panel> panelsOf(const BenchDocument& document) {
  std::vector<Panel> panels;
  const MapData data = mapData(document);
  if (!guidedRows(data).empty()) {
    panels.push_back(timePanel(data));
    panels.push_back(lengthPanel(data));
    panels.push_back(searchesPanel(data));
  }
  if (std::any_of(data.rows.begin(), data.rows.end(), [](const Summary& row) { return row.library.empty(); }))
    panels.push_back(pathsPanel(data));
  if (std::any_of(document.runs.begin(), document.runs.end(),
                  [](const BenchRun& run) { return run.set == kRandomSet; }))
    panels.push_back(randomPanel(document));
  for (const std::string& what : distinct(document.growth, [](const GrowthRow& row) { return row.what; }))
    panels.push_back(growthPanel(document, what));
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
