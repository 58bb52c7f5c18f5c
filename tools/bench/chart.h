#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "figures/svg.h"

namespace stridegraph::bench {

/// How values lie along an axis.
class Scale {
 public:
  /// Round numbers from 0 or `low` up to what holds `high`.
  static Scale linear(double low, double high);
  /// From the 1, 2 or 5 times a power of ten below `low` to the one above `high`, both > 0.
  static Scale logarithmic(double low, double high);

  /// 0 at the beginning of the axis, 1 at its end; values beyond are put there.
  double share(double value) const;

  struct Tick {
    double value = 0.0;
    std::string label;
  };
  const std::vector<Tick>& ticks() const { return ticks_; }

 private:
  double low_ = 0.0;  ///< Of logarithms where logarithmic.
  double high_ = 1.0;
  bool logarithmic_ = false;
  std::vector<Tick> ticks_;
};

/// A diagram with a vertical scale; along x it has a scale or names.
class Chart {
 public:
  Chart(const figures::PixelBox& frame, Scale y, std::string yLabel);

  void setNames(std::vector<std::string> names) { names_ = std::move(names); }
  void setX(Scale x, std::string label);

  double y(double value) const;
  double x(double value) const;
  /// The middle of a name's stripe, moved by a share of its width.
  double xOf(std::size_t name, double shift = 0.0) const;
  double stripePixels() const;
  const figures::PixelBox& frame() const { return frame_; }

  /// Paper, grid, numbers, names and labels: to be drawn first.
  void drawFrame(figures::Svg& svg) const;

 private:
  void drawX(figures::Svg& svg) const;

  figures::PixelBox frame_;
  Scale y_;
  std::string yLabel_;
  Scale x_;
  std::string xLabel_;
  std::vector<std::string> names_;
};

/// How a series is shown: dots are filled, or hollow.
struct SeriesStyle {
  std::string name;
  std::string_view colour;
  bool hollow = false;
};

/// A median as a dot with a line up to the worst.
void drawSpread(figures::Svg& svg, const Chart& chart, double x, double median, double worst,
                const SeriesStyle& style);

/// From one line of a legend to the next.
inline constexpr double kLegendLinePixels = 18.0;

/// How many lines a legend takes.
std::size_t legendLines(double widthPixels, const std::vector<SeriesStyle>& entries);

/// Entries side by side in lines of that width; `at` is the beginning of the first line.
void drawSeriesLegend(figures::Svg& svg, const Vec2& at, double widthPixels,
                      const std::vector<SeriesStyle>& entries);

}  // namespace stridegraph::bench
