#pragma once

#include <string>
#include <vector>

#include "figures/svg.h"

namespace stridegraph::figures {

/// One axis of a diagram: what range it shows and what it is called, with its unit: "time (s)".
struct Axis {
  double low = 0.0;
  double high = 1.0;
  std::string label;
};

/// Round numbers within low..high: multiples of 1, 2 or 5 times a power of ten, at most `most` of them (>=
/// 1).
std::vector<double> roundTicks(double low, double high, std::size_t most);

/// A frame in a picture that shows a range of two quantities.
class Axes {
 public:
  /// x grows to the right, y upwards, or downwards where y.low > y.high.
  Axes(const PixelBox& frame, Axis x, Axis y) : frame_(frame), x_(std::move(x)), y_(std::move(y)) {}

  const PixelBox& frame() const { return frame_; }
  /// Where a pair of values lies in the picture.
  Vec2 at(double x, double y) const;
  double pixelsPerX() const { return frame_.width() / (x_.high - x_.low); }

  /// Faint lines at round numbers, under what is drawn later.
  void drawGrid(Svg& svg) const;
  /// Frame, numbers at round places and labels. An axis with an empty label has no numbers either.
  void drawFrame(Svg& svg) const;
  const Axis& x() const { return x_; }

 private:
  std::vector<double> ticksOfX() const;
  std::vector<double> ticksOfY() const;

  PixelBox frame_;
  Axis x_;
  Axis y_;
};

/// Numbers and label of seconds at a height below a diagram of time: the one scale of several diagrams.
void drawTimes(Svg& svg, const Axes& axes, double belowPixels);

/// Above a picture or one of its panels: a bold line and a quiet one below it.
void drawHeading(Svg& svg, const Vec2& at, std::string_view title, std::string_view subtitle = {});

/// One entry of a legend: a stroke of a colour and what it stands for.
struct LegendEntry {
  Style style;
  std::string text;
};

/// Entries side by side from `at` on; returns where the next would begin.
double drawLegend(Svg& svg, const Vec2& at, const std::vector<LegendEntry>& entries);

}  // namespace stridegraph::figures
