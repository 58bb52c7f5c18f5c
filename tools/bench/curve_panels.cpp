#include "bench/curve_panels.h"

#include <fmt/format.h>

#include <algorithm>

namespace stridegraph::bench {
namespace {

using figures::PixelBox;
using figures::Svg;

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
              seriesOf(libraries),
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

/// Times over sizes, which a logarithmic axis wants above 0.
Panel growthPanel(std::vector<GrowthRow> rows, const std::string& what) {
  std::erase_if(rows, [&](const GrowthRow& row) { return row.what != what; });
  std::vector<std::string> times;
  for (const auto& [name, value] : rows.front().figures)
    if (isTime(name)) times.push_back(name);
  const std::vector<SeriesStyle> series = seriesOf(times);
  std::vector<SeriesStyle> legend = series;
  for (SeriesStyle& entry : legend) entry.name.resize(entry.name.rfind(' '));
  Panel panel{fmt::format("Growth with {}", what), "Times over how much there is.", legend, false, 210.0, {}};
  panel.draw = [rows, series, what](Svg& svg, const PixelBox& frame) {
    std::vector<std::vector<Vec2>> curves(series.size());
    double low = 1e9;
    double high = 0.0;
    for (const GrowthRow& row : rows) {
      for (const auto& [name, value] : row.figures) {
        const std::size_t of = indexIn(series, name);
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

}  // namespace

std::vector<Panel> randomPanels(const BenchDocument& document) {
  if (std::none_of(document.runs.begin(), document.runs.end(),
                   [](const BenchRun& run) { return run.set == kRandomSet; }))
    return {};
  return {randomPanel(document)};
}

std::vector<Panel> growthPanels(const BenchDocument& document) {
  std::vector<GrowthRow> rows = document.growth;
  std::erase_if(rows, [](const GrowthRow& row) { return row.size <= 0.0; });
  std::vector<Panel> panels;
  for (const std::string& what : distinct(rows, [](const GrowthRow& row) { return row.what; }))
    panels.push_back(growthPanel(rows, what));
  return panels;
}

}  // namespace stridegraph::bench
