#include "motion/bvh_frame_time.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "motion/bvh_limits.h"

namespace stridegraph {
namespace {

/// Rates that cameras, capture systems and animation programs offer, frames a second.
constexpr std::array kWholeRates = {5.0,   6.0,   8.0,   10.0,  12.0,  15.0,  20.0,  24.0,  25.0,
                                    30.0,  40.0,  48.0,  50.0,  60.0,  72.0,  75.0,  80.0,  90.0,
                                    100.0, 120.0, 125.0, 144.0, 150.0, 180.0, 200.0, 240.0, 250.0,
                                    300.0, 360.0, 400.0, 480.0, 500.0, 600.0, 1000.0};
/// Those of NTSC, a thousand and first part slower than a whole one.
constexpr std::array kNtscRates = {24'000.0 / 1001.0, 30'000.0 / 1001.0, 60'000.0 / 1001.0,
                                   120'000.0 / 1001.0};
/// Numbers that differ by less are the same rate or time written with more or fewer digits.
constexpr double kSameShare = 1e-4;
constexpr double kLongestMilliseconds = 1000.0 * kLongestBvhFrameSeconds;

/// A unit in the last decimal place of a number's text; 0 where it has an exponent or no decimals.
double unitOfLastDecimal(std::string_view number) {
  const std::size_t point = number.find('.');
  if (point == std::string_view::npos || number.find_first_of("eE") != std::string_view::npos) return 0.0;
  return std::pow(10.0, -static_cast<double>(number.size() - point - 1));
}

double framesPerSecondOf(double frameSeconds, double rounding) {
  const double exact = 1.0 / frameSeconds;
  if (frameSeconds <= rounding) return exact;
  const double lowest = 1.0 / (frameSeconds + rounding);
  const double highest = 1.0 / (frameSeconds - rounding);
  const double whole = std::ceil(lowest);
  return highest - lowest < 1.0 && whole <= highest ? whole : exact;
}

bool isCustomaryRate(double value) {
  const auto isNear = [&](double rate) { return std::abs(value - rate) <= kSameShare * rate; };
  return std::any_of(kWholeRates.begin(), kWholeRates.end(), isNear) ||
         std::any_of(kNtscRates.begin(), kNtscRates.end(), isNear);
}

/// The customary rate of frames that last so many milliseconds, if there is exactly one. Digits that follow
/// may have been rounded or cut off.
std::optional<double> rateOfMilliseconds(double milliseconds, double unit) {
  const double tolerance = std::max(unit > 0.0 ? unit : 0.5, kSameShare * milliseconds);
  const auto fits = [&](double rate) { return std::abs(1000.0 / rate - milliseconds) <= tolerance; };
  if (std::count_if(kWholeRates.begin(), kWholeRates.end(), fits) == 1)
    return *std::find_if(kWholeRates.begin(), kWholeRates.end(), fits);
  if (std::any_of(kWholeRates.begin(), kWholeRates.end(), fits)) return {};
  if (std::count_if(kNtscRates.begin(), kNtscRates.end(), fits) == 1)
    return *std::find_if(kNtscRates.begin(), kNtscRates.end(), fits);
  return {};
}

std::string sentenceOf(std::string_view found, double value) {
  std::string sentence =
      fmt::format("found a frame time of {}, expected the seconds from one frame to the next, {} to {}",
                  found, kShortestBvhFrameSeconds, kLongestBvhFrameSeconds);
  if (value > kLongestBvhFrameSeconds && value <= kLongestMilliseconds) {
    sentence += fmt::format(": {:.7g} if it is frames a second, {:.7g} if it is milliseconds", 1.0 / value,
                            value / 1000.0);
  }
  return sentence;
}

}  // namespace

Result<BvhFrameTime> parseBvhFrameTime(BvhScanner& scanner) {
  const std::size_t offset = scanner.offset();
  const Result<double> value = scanner.takeNumber("the frame time in seconds");
  if (!value) return tl::unexpected(value.error());
  const double unit = unitOfLastDecimal(scanner.lastNumber());
  if (*value >= kShortestBvhFrameSeconds && *value <= kLongestBvhFrameSeconds)
    return BvhFrameTime{framesPerSecondOf(*value, 0.5 * unit), {}};
  const bool mayBeMilliseconds =
      *value > kLongestBvhFrameSeconds && *value <= kLongestMilliseconds && !isCustomaryRate(*value);
  const std::optional<double> rate =
      mayBeMilliseconds ? rateOfMilliseconds(*value, unit) : std::optional<double>();
  if (!rate)
    return fail(ErrorCode::kBvhValue, sentenceOf(scanner.lastNumber(), *value), scanner.placeOf(offset));
  return BvhFrameTime{
      *rate, Warning{fmt::format("found a frame time of {} and read it as milliseconds: {:.6g} frames "
                                 "a second",
                                 scanner.lastNumber(), *rate),
                     scanner.placeOf(offset), WarningTopic::kTime}};
}

}  // namespace stridegraph
