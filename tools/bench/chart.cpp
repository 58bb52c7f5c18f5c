#include "bench/chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "figures/axes.h"
#include "figures/palette.h"

namespace stridegraph::bench {
namespace {

namespace palette = figures::palette;
using figures::Anchor;
using figures::TextStyle;

constexpr double kDotPixels = 3.6;
constexpr std::size_t kMostTicks = 6;

/// Longer logarithmic scales have powers of ten alone.
constexpr double kMostFineDecades = 2.6;

double legendEntryPixels(const SeriesStyle& entry) {
  return 3.0 * kDotPixels + figures::textWidth(entry.name, {12.0, Anchor::kStart, palette::kInk}) + 18.0;
}

}  // namespace

Scale Scale::linear(double low, double high) {
  Scale scale;
  const std::vector<double> ticks = figures::roundTicks(low, high, kMostTicks);
  const double step = ticks.size() > 1 ? ticks[1] - ticks[0] : 1.0;
  scale.low_ = low;
  scale.high_ = std::max(low + step, low + step * std::ceil((high - low) / step - 1e-9));
  for (const double value : figures::roundTicks(low, scale.high_, kMostTicks + 1))
    scale.ticks_.push_back({value, fmt::format("{:g}", value)});
  return scale;
}

Scale Scale::logarithmic(double low, double high) {
  Scale scale;
  scale.logarithmic_ = true;
  const std::vector<double> round = {1.0, 2.0, 5.0, 10.0};
  const double least = std::pow(10.0, std::floor(std::log10(low)));
  const double most = std::pow(10.0, std::floor(std::log10(high)));
  const double from = least * *(std::upper_bound(round.begin(), round.end() - 1, low / least + 1e-9) - 1);
  double to = most * *std::lower_bound(round.begin(), round.end() - 1, high / most - 1e-9);
  if (to <= from) to = 10.0 * from;
  scale.low_ = std::log10(from);
  scale.high_ = std::log10(to);
  const std::size_t steps = scale.high_ - scale.low_ > kMostFineDecades ? 1 : 3;
  for (double power = least; power < to * (1.0 + 1e-9); power *= 10.0) {
    for (std::size_t i = 0; i < steps; ++i) {
      const double value = power * round[i];
      if (value < from * (1.0 - 1e-9) || value > to * (1.0 + 1e-9)) continue;
      scale.ticks_.push_back({value, fmt::format("{:.6g}", value)});
    }
  }
  return scale;
}

double Scale::share(double value) const {
  if (logarithmic_) value = value > 0.0 ? std::log10(value) : low_;
  return std::clamp((value - low_) / (high_ - low_), 0.0, 1.0);
}

Chart::Chart(const figures::PixelBox& frame, Scale y, std::string yLabel)
    : frame_(frame), y_(std::move(y)), yLabel_(std::move(yLabel)) {}

void Chart::setX(Scale x, std::string label) {
  x_ = std::move(x);
  xLabel_ = std::move(label);
}

double Chart::y(double value) const {
  return frame_.bottom - y_.share(value) * frame_.height();
}

double Chart::x(double value) const {
  return frame_.left + x_.share(value) * frame_.width();
}

double Chart::stripePixels() const {
  return frame_.width() / static_cast<double>(names_.size());
}

double Chart::xOf(std::size_t name, double shift) const {
  return frame_.left + (static_cast<double>(name) + 0.5 + shift) * stripePixels();
}

void Chart::drawFrame(figures::Svg& svg) const {
  svg.rectangle(frame_, {.fill = "#ffffff"}, 3.0);
  for (const Scale::Tick& tick : y_.ticks()) {
    svg.line({frame_.left, y(tick.value)}, {frame_.right, y(tick.value)}, {.stroke = palette::kFaint});
    svg.text({frame_.left - 8.0, y(tick.value) + 4.0}, tick.label, {11.0, Anchor::kEnd, palette::kQuiet});
  }
  svg.text({frame_.left - 46.0, 0.5 * (frame_.top + frame_.bottom)}, yLabel_,
           {12.0, Anchor::kMiddle, palette::kInk, false, true});
  drawX(svg);
}

void Chart::drawX(figures::Svg& svg) const {
  for (std::size_t n = 0; n < names_.size(); ++n) {
    if (n % 2 == 1)
      svg.rectangle({xOf(n, -0.5), frame_.top, xOf(n, 0.5), frame_.bottom},
                    {.fill = palette::kFloor, .opacity = 0.55});
    svg.text({xOf(n), frame_.bottom + 17.0}, names_[n], {11.0, Anchor::kMiddle, palette::kQuiet});
  }
  for (const Scale::Tick& tick : x_.ticks()) {
    svg.line({x(tick.value), frame_.top}, {x(tick.value), frame_.bottom}, {.stroke = palette::kFaint});
    svg.text({x(tick.value), frame_.bottom + 17.0}, tick.label, {11.0, Anchor::kMiddle, palette::kQuiet});
  }
  if (!xLabel_.empty())
    svg.text({0.5 * (frame_.left + frame_.right), frame_.bottom + 35.0}, xLabel_,
             {12.0, Anchor::kMiddle, palette::kInk});
}

void drawSpread(figures::Svg& svg, const Chart& chart, double x, double median, double worst,
                const SeriesStyle& style) {
  const Vec2 dot(x, chart.y(median));
  const Vec2 top(x, chart.y(worst));
  svg.line(dot, top, {.stroke = style.colour, .strokePixels = 1.6, .opacity = 0.7});
  svg.line(top - Vec2(3.0, 0.0), top + Vec2(3.0, 0.0), {.stroke = style.colour, .strokePixels = 1.6});
  svg.circle(dot, kDotPixels,
             {.fill = style.hollow ? "#ffffff" : style.colour, .stroke = style.colour, .strokePixels = 1.6});
}

std::size_t legendLines(double widthPixels, const std::vector<SeriesStyle>& entries) {
  std::size_t lines = entries.empty() ? 0 : 1;
  double x = 0.0;
  for (const SeriesStyle& entry : entries) {
    const double width = legendEntryPixels(entry);
    if (x > 0.0 && x + width > widthPixels) {
      ++lines;
      x = 0.0;
    }
    x += width;
  }
  return lines;
}

void drawSeriesLegend(figures::Svg& svg, const Vec2& at, double widthPixels,
                      const std::vector<SeriesStyle>& entries) {
  const TextStyle text{12.0, Anchor::kStart, palette::kInk};
  Vec2 pen = at;
  for (const SeriesStyle& entry : entries) {
    const double width = legendEntryPixels(entry);
    if (pen.x() > at.x() && pen.x() + width > at.x() + widthPixels)
      pen = {at.x(), pen.y() + kLegendLinePixels};
    svg.circle(
        {pen.x() + kDotPixels, pen.y() - 4.0}, kDotPixels,
        {.fill = entry.hollow ? "#ffffff" : entry.colour, .stroke = entry.colour, .strokePixels = 1.6});
    svg.text({pen.x() + 3.0 * kDotPixels, pen.y()}, entry.name, text);
    pen.x() += width;
  }
}

}  // namespace stridegraph::bench
