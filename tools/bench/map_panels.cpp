#include "bench/map_panels.h"

#include <fmt/format.h>

#include <algorithm>

#include "bench/summary.h"
#include "figures/palette.h"
#include "walk/plan.h"

namespace stridegraph::bench {
namespace {

using figures::PixelBox;
using figures::Svg;

namespace palette = figures::palette;

constexpr double kFrameMilliseconds = 1000.0 / 60.0;

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
      seriesOf(data.libraries),
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
  return seriesOf(distinct(rows, [](const Summary& row) { return row.method; }));
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
      const std::size_t method = indexIn(series, row.method);
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
      const std::size_t method = indexIn(series, row.method);
      const double x = chart.xOf(indexIn(data.maps, row.room), shiftOf(method, series.size()));
      drawSpread(svg, chart, x, row.pathMilliseconds.median, row.pathMilliseconds.worst, series[method]);
    }
  };
  return panel;
}

}  // namespace

std::vector<Panel> mapPanels(const BenchDocument& document) {
  std::vector<Panel> panels;
  const MapData data = mapData(document);
  if (!guidedRows(data).empty()) {
    panels.push_back(timePanel(data));
    panels.push_back(lengthPanel(data));
    panels.push_back(searchesPanel(data));
  }
  if (std::any_of(data.rows.begin(), data.rows.end(), [](const Summary& row) { return row.library.empty(); }))
    panels.push_back(pathsPanel(data));
  return panels;
}

}  // namespace stridegraph::bench
