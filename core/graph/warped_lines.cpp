#include "graph/warped_lines.h"

#include <algorithm>

namespace stridegraph {
namespace {

/// Nearest whole number to a / b, halves upwards.
std::size_t roundedRatio(std::size_t a, std::size_t b) {
  return (2 * a + b) / (2 * b);
}

WarpedLine lineOf(std::size_t rowSpan, std::size_t columnSpan) {
  const std::size_t steps = std::max(rowSpan, columnSpan);
  WarpedLine line{rowSpan, columnSpan, {}};
  const auto add = [&](std::size_t step) {
    line.cells.push_back(
        {rowSpan - roundedRatio(step * rowSpan, steps), columnSpan - roundedRatio(step * columnSpan, steps)});
  };
  add(steps);
  add(0);
  add(steps / 2);
  for (std::size_t step = 1; step < steps; ++step) {
    if (step != steps / 2) add(step);
  }
  return line;
}

}  // namespace

std::size_t WarpedLine::lean() const {
  return (std::max(rowSpan, columnSpan) - std::min(rowSpan, columnSpan)) / 2;
}

WarpedLine diagonalLine(std::size_t steps) {
  return lineOf(steps, steps);
}

std::vector<WarpedLine> warpedLines(std::size_t steps, double largestRatio) {
  std::vector<WarpedLine> lines;
  for (std::size_t lean = 1; lean < steps; ++lean) {
    const std::size_t shorter = steps - lean;
    const std::size_t longer = steps + lean;
    if (static_cast<double>(longer) > largestRatio * static_cast<double>(shorter)) break;
    lines.push_back(lineOf(shorter, longer));
    lines.push_back(lineOf(longer, shorter));
  }
  return lines;
}

}  // namespace stridegraph
