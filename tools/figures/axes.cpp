#include "figures/axes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "figures/palette.h"

namespace stridegraph::figures {
namespace {

constexpr double kNumberPixels = 11.0;
constexpr double kPixelsPerTickX = 55.0;
constexpr double kPixelsPerTickY = 30.0;

std::size_t ticksIn(double pixelLength, double pixelsPerTick) {
  return static_cast<std::size_t>(std::max(2.0, pixelLength / pixelsPerTick));
}

std::string numberText(double value) {
  return fmt::format("{:g}", value);
}

}  // namespace

std::vector<double> roundTicks(double low, double high, std::size_t most) {
  if (low > high) std::swap(low, high);
  const double span = high - low;
  if (!(span > 0.0)) return {low};
  double step = std::pow(10.0, std::floor(std::log10(span / static_cast<double>(most))));
  for (const double factor : {1.0, 2.0, 5.0, 10.0, 20.0}) {
    const double candidate = factor * step;
    if (std::floor(span / candidate + 1e-9) + 1.0 > static_cast<double>(most)) continue;
    step = candidate;
    break;
  }
  std::vector<double> ticks;
  for (double i = std::ceil(low / step - 1e-9); i * step <= high + 1e-9 * span; i += 1.0)
    ticks.push_back(i * step + 0.0);  // + 0.0 turns -0 into 0.
  return ticks;
}

Vec2 Axes::at(double x, double y) const {
  return {frame_.left + frame_.width() * (x - x_.low) / (x_.high - x_.low),
          frame_.bottom - frame_.height() * (y - y_.low) / (y_.high - y_.low)};
}

std::vector<double> Axes::ticksOfX() const {
  return roundTicks(x_.low, x_.high, ticksIn(frame_.width(), kPixelsPerTickX));
}

std::vector<double> Axes::ticksOfY() const {
  return roundTicks(y_.low, y_.high, ticksIn(frame_.height(), kPixelsPerTickY));
}

void Axes::drawGrid(Svg& svg) const {
  const Style faint{.stroke = palette::kFaint};
  for (const double x : ticksOfX()) svg.line(at(x, y_.low), at(x, y_.high), faint);
  for (const double y : ticksOfY()) svg.line(at(x_.low, y), at(x_.high, y), faint);
}

void Axes::drawFrame(Svg& svg) const {
  svg.rectangle(frame_, {.stroke = palette::kFrame});
  if (!x_.label.empty()) {
    for (const double x : ticksOfX())
      svg.text({at(x, 0.0).x(), frame_.bottom + 15.0}, numberText(x),
               {kNumberPixels, Anchor::kMiddle, palette::kQuiet});
    svg.text({0.5 * (frame_.left + frame_.right), frame_.bottom + 32.0}, x_.label,
             {12.0, Anchor::kMiddle, palette::kInk});
  }
  if (!y_.label.empty()) {
    for (const double y : ticksOfY())
      svg.text({frame_.left - 6.0, at(0.0, y).y() + 4.0}, numberText(y),
               {kNumberPixels, Anchor::kEnd, palette::kQuiet});
    svg.text({frame_.left - 38.0, 0.5 * (frame_.top + frame_.bottom)}, y_.label,
             {12.0, Anchor::kMiddle, palette::kInk, false, true});
  }
}

void drawTimes(Svg& svg, const Axes& axes, double belowPixels) {
  const Axis& time = axes.x();
  for (const double t : roundTicks(time.low, time.high, ticksIn(axes.frame().width(), kPixelsPerTickX)))
    svg.text({axes.at(t, 0.0).x(), belowPixels + 15.0}, numberText(t),
             {kNumberPixels, Anchor::kMiddle, palette::kQuiet});
  svg.text({0.5 * (axes.frame().left + axes.frame().right), belowPixels + 32.0}, "time (s)",
           {12.0, Anchor::kMiddle, palette::kInk});
}

void drawHeading(Svg& svg, const Vec2& at, std::string_view title, std::string_view subtitle) {
  svg.text(at, title, {15.0, Anchor::kStart, palette::kInk, true});
  if (!subtitle.empty()) svg.text({at.x(), at.y() + 18.0}, subtitle, {12.0, Anchor::kStart, palette::kQuiet});
}

double drawLegend(Svg& svg, const Vec2& at, const std::vector<LegendEntry>& entries) {
  constexpr double kSwatchPixels = 18.0;
  double x = at.x();
  for (const LegendEntry& entry : entries) {
    const Vec2 from(x, at.y() - 4.0);
    if (entry.style.fill != "none") {
      svg.rectangle({x, at.y() - 10.0, x + kSwatchPixels, at.y() + 1.0}, entry.style, 2.0);
    } else {
      svg.line(from, from + Vec2(kSwatchPixels, 0.0), entry.style);
    }
    const TextStyle style{12.0, Anchor::kStart, palette::kInk};
    svg.text({x + kSwatchPixels + 6.0, at.y()}, entry.text, style);
    x += kSwatchPixels + 6.0 + textWidth(entry.text, style) + 18.0;
  }
  return x;
}

}  // namespace stridegraph::figures
