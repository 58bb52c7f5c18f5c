#include "program/progress_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "program/rounding.h"

namespace stridegraph::tools {
namespace {

constexpr double kTerminalFirst = 500.0;
constexpr double kTerminalEvery = 100.0;
constexpr double kLinesEvery = 10'000.0;
/// To the beginning of the line, then clear it (ECMA-48).
constexpr const char* kClearLine = "\r\x1b[K";

}  // namespace

std::string timeLeft(double share, double milliseconds) {
  constexpr double kLeastShare = 0.02;
  constexpr double kLeastMilliseconds = 2000.0;
  if (!(share >= kLeastShare) || milliseconds < kLeastMilliseconds || share >= 1.0) return {};
  const double seconds = 1e-3 * milliseconds * (1.0 - share) / share;
  constexpr double kFew = 10.0;
  if (seconds < kFew) return fmt::format("about {:.0f} s left", std::max(1.0, seconds));
  return fmt::format("about {} left", roundedSeconds(seconds));
}

ProgressText::ProgressText(std::string what, ProgressStyle style)
    : what_(std::move(what)),
      style_(style),
      nextMilliseconds_(style == ProgressStyle::kTerminal ? kTerminalFirst : kLinesEvery) {}

std::optional<std::string> ProgressText::at(double share, double milliseconds) {
  if (style_ == ProgressStyle::kNone || milliseconds < nextMilliseconds_) return std::nullopt;
  const double done = std::clamp(share, 0.0, 1.0);
  const std::string left = timeLeft(done, milliseconds);
  std::string text = fmt::format("{}: {:.0f} %", what_, std::floor(100.0 * done));
  if (style_ == ProgressStyle::kTerminal) {
    nextMilliseconds_ = milliseconds + kTerminalEvery;
    isShown_ = true;
    return kClearLine + text + (left.empty() ? "" : ", " + left);
  }
  nextMilliseconds_ = milliseconds + kLinesEvery;
  return fmt::format("{} after {}{}\n", text, roundedSeconds(1e-3 * milliseconds),
                     left.empty() ? "" : ", " + left);
}

std::string ProgressText::clearing() {
  return std::exchange(isShown_, false) ? kClearLine : "";
}

}  // namespace stridegraph::tools
