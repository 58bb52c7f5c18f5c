#include "motion/bvh_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace stridegraph {
namespace {

constexpr double kShortestFrameSeconds = 1e-6;
constexpr double kLongestFrameSeconds = 1e3;
/// A digit and what separates it from the next number; a minus sign may be that.
constexpr std::size_t kBytesOfShortestNumber = 2;

/// Half a unit in the last decimal place of a number's text.
double roundingOf(std::string_view number) {
  const std::size_t point = number.find('.');
  if (point == std::string_view::npos || number.find_first_of("eE") != std::string_view::npos) return 0.0;
  return 0.5 * std::pow(10.0, -static_cast<double>(number.size() - point - 1));
}

double framesPerSecondOf(double frameSeconds, double rounding) {
  const double exact = 1.0 / frameSeconds;
  if (frameSeconds <= rounding) return exact;
  const double lowest = 1.0 / (frameSeconds + rounding);
  const double highest = 1.0 / (frameSeconds - rounding);
  const double whole = std::ceil(lowest);
  return highest - lowest < 1.0 && whole <= highest ? whole : exact;
}

Result<std::size_t> parseFrameCount(BvhScanner& scanner, std::size_t columns) {
  if (!scanner.takeWord("FRAMES") || !scanner.takeSymbol(':')) return scanner.expected("\"Frames:\"");
  const std::size_t offset = scanner.offset();
  Result<std::size_t> declared = scanner.takeCount("the number of frames");
  if (!declared) return declared;
  if (*declared == 0)
    return fail(ErrorCode::kBvhValue, "found 0 frames, expected at least 1", scanner.placeOf(offset));
  // One row may be missing, so that one fewer has to fit. Divided, not multiplied: nothing can overflow.
  const std::size_t mostRows = (scanner.remainingBytes() + 1) / kBytesOfShortestNumber / columns + 1;
  if (*declared > mostRows) {
    return fail(
        ErrorCode::kBvhValue,
        fmt::format("found {} frames of {} numbers, expected no more than the {} bytes that follow can hold",
                    *declared, columns, scanner.remainingBytes()),
        scanner.placeOf(offset));
  }
  return declared;
}

Result<double> parseFrameTime(BvhScanner& scanner) {
  if (!scanner.takeWord("FRAME") || !scanner.takeWord("TIME") || !scanner.takeSymbol(':')) {
    return scanner.expected("\"Frame Time:\"");
  }
  const std::size_t offset = scanner.offset();
  const Result<double> seconds = scanner.takeNumber("the frame time in seconds");
  if (!seconds) return seconds;
  if (*seconds < kShortestFrameSeconds || *seconds > kLongestFrameSeconds) {
    return fail(
        ErrorCode::kBvhValue,
        fmt::format("found a frame time of {}, expected 0.000001 to 1000 seconds", scanner.lastNumber()),
        scanner.placeOf(offset));
  }
  return framesPerSecondOf(*seconds, roundingOf(scanner.lastNumber()));
}

}  // namespace

Result<BvhMotion> parseBvhMotion(BvhScanner& scanner, std::size_t columns) {
  if (!scanner.takeWord("MOTION")) return scanner.expected("MOTION");
  const Result<std::size_t> declared = parseFrameCount(scanner, columns);
  if (!declared) return tl::unexpected(declared.error());
  const Result<double> framesPerSecond = parseFrameTime(scanner);
  if (!framesPerSecond) return tl::unexpected(framesPerSecond.error());

  BvhMotion motion;
  motion.framesPerSecond = *framesPerSecond;
  motion.columns = columns;
  motion.values.reserve(*declared * columns);
  while (!scanner.atEnd()) {
    const Result<double> value = scanner.takeNumber("a channel's value");
    if (!value) return tl::unexpected(value.error());
    motion.values.push_back(*value);
  }
  motion.frameCount = motion.values.size() / columns;
  const std::size_t left = motion.values.size() % columns;
  if (motion.frameCount == 0) {
    return scanner.expected(fmt::format("a row of {} numbers, of which {} are there", columns, left));
  }
  motion.values.resize(motion.frameCount * columns);
  if (motion.frameCount != *declared || left > 0) {
    motion.warnings.push_back({fmt::format("{} frames are declared, {} complete rows of {} numbers{} were "
                                           "found; the complete rows are used",
                                           *declared, motion.frameCount, columns,
                                           left > 0 ? fmt::format(" and {} more", left) : ""),
                               scanner.placeOf(scanner.offset())});
  }
  return motion;
}

}  // namespace stridegraph
