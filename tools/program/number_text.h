#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "base/result.h"

namespace stridegraph::tools {

/// What a number may be, and its unit as messages and help name it ("metres"); empty for none.
struct NumberRange {
  double low = 0.0;
  double high = 0.0;
  std::string_view unit;
  bool isAboveLow = false;  ///< `low` itself is out of range.
};

/// The same of a whole number.
struct WholeRange {
  std::uint64_t low = 0;
  std::uint64_t high = 0;
  std::string_view unit;
};

/// "0.05 to 5 metres", "above 0 to 10 metres".
std::string describe(const NumberRange& range);
std::string describe(const WholeRange& range);

/// A finite number in decimal digits, with or without sign, point and exponent, and nothing else around it.
/// kInvalidArgument with what was found and expected, also when it is out of range.
Result<double> parseNumber(std::string_view text, const NumberRange& range);

/// A whole number in decimal digits and nothing else; kInvalidArgument as above. Never wraps round.
Result<std::uint64_t> parseWhole(std::string_view text, const WholeRange& range);

/// A number as short as it reads back: "0.05", "1000000".
std::string plainNumber(double value);

}  // namespace stridegraph::tools
