#include "program/rounding.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace stridegraph::tools {

std::string rounded(double value) {
  if (!std::isfinite(value)) return fmt::format("{}", value);
  // With three digits 999.5 would become 1e+03.
  if (std::abs(value) >= 999.5) return fmt::format("{:.0f}", value);
  return fmt::format("{:.3g}", value == 0.0 ? 0.0 : value);
}

std::string roundedSeconds(double seconds) {
  constexpr double kMinute = 60.0;
  constexpr double kHour = 3600.0;
  if (!(seconds < 1e9)) return "very long";
  if (seconds < 9.95) return fmt::format("{:.1f} s", seconds);
  const auto whole = static_cast<std::uint64_t>(std::llround(seconds));
  if (static_cast<double>(whole) < kMinute) return fmt::format("{} s", whole);
  if (static_cast<double>(whole) < kHour) return fmt::format("{} min {} s", whole / 60, whole % 60);
  return fmt::format("{} h {} min", whole / 3600, whole / 60 % 60);
}

std::string roundedBytes(std::uint64_t bytes) {
  constexpr std::array<const char*, 5> kUnits = {"bytes", "KiB", "MiB", "GiB", "TiB"};
  auto value = static_cast<double>(bytes);
  std::size_t unit = 0;
  for (; value >= 1024.0 && unit + 1 < kUnits.size(); ++unit) value /= 1024.0;
  return fmt::format("{} {}", rounded(value), kUnits.at(unit));
}

}  // namespace stridegraph::tools
