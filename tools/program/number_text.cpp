#include "program/number_text.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <system_error>

#include "program/shown_text.h"

namespace stridegraph::tools {
namespace {

std::string withUnit(std::string_view unit) {
  return unit.empty() ? std::string() : fmt::format(" {}", unit);
}

template <typename Number>
bool takesAll(std::string_view text, Number& value) {
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
  return failed == std::errc() && end == text.data() + text.size();
}

}  // namespace

std::string plainNumber(double value) {
  const std::string shortest = fmt::format("{}", value);
  return shortest.find('e') == std::string::npos ? shortest : fmt::format("{:.12g}", value);
}

std::string describe(const NumberRange& range) {
  return fmt::format("{}{} to {}{}", range.isAboveLow ? "above " : "", plainNumber(range.low),
                     plainNumber(range.high), withUnit(range.unit));
}

std::string describe(const WholeRange& range) {
  return fmt::format("{} to {}{}", range.low, range.high, withUnit(range.unit));
}

Result<double> parseNumber(std::string_view text, const NumberRange& range) {
  double value = 0.0;
  const std::string_view digits = text.starts_with('+') ? text.substr(1) : text;
  const bool isNumber = takesAll(digits, value) && std::isfinite(value);
  const bool isHighEnough = range.isAboveLow ? value > range.low : value >= range.low;
  if (isNumber && isHighEnough && value <= range.high) return value;
  return fail(ErrorCode::kInvalidArgument,
              fmt::format("found {}, expected {}{}", quotedText(text),
                          range.isAboveLow ? "a number " : "a number from ", describe(range)));
}

Result<std::uint64_t> parseWhole(std::string_view text, const WholeRange& range) {
  std::uint64_t value = 0;
  if (takesAll(text, value) && value >= range.low && value <= range.high) return value;
  return fail(ErrorCode::kInvalidArgument,
              fmt::format("found {}, expected a whole number from {}", quotedText(text), describe(range)));
}

}  // namespace stridegraph::tools
