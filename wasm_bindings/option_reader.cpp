#include "option_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "js_values.h"

namespace stridegraph::bindings {
namespace {

using emscripten::val;

constexpr double kLargestWholeNumber = 9007199254740991.0;  // Number.MAX_SAFE_INTEGER

std::string typeName(const val& value) {
  return value.isNull() ? "null" : value.typeOf().as<std::string>();
}

}  // namespace

OptionReader::OptionReader(val options, std::string what)
    : options_(std::move(options)), what_(std::move(what)) {
  if (options_.isUndefined() || options_.isNull()) options_ = val::object();
  if (typeName(options_) != "object" || options_.isArray()) {
    refuse(fmt::format("{} are {}, expected an object", what_,
                       options_.isArray() ? "an array" : "a " + typeName(options_)));
    options_ = val::object();
  }
}

val OptionReader::member(const char* name, const char* expectedType) {
  known_.emplace_back(name);
  val value = options_[name];
  if (value.isUndefined() || value.isNull()) return val::undefined();
  const std::string found = typeName(value);
  if (found == expectedType) return value;
  refuse(fmt::format("{}: {} is a {}, expected a {}", what_, name, found, expectedType));
  return val::undefined();
}

std::optional<double> OptionReader::number(const char* name) {
  const val value = member(name, "number");
  if (value.isUndefined()) return {};
  const double number = value.as<double>();
  if (std::isfinite(number)) return number;
  refuse(fmt::format("{}: {} is {}, expected a finite number", what_, name, number));
  return {};
}

std::optional<double> OptionReader::wholeNumber(const char* name) {
  const std::optional<double> value = number(name);
  if (!value || (*value >= 0 && *value <= kLargestWholeNumber && *value == std::floor(*value))) return value;
  refuse(fmt::format("{}: {} is {}, expected a whole number from 0 to 2^53 - 1", what_, name, *value));
  return {};
}

std::optional<bool> OptionReader::flag(const char* name) {
  const val value = member(name, "boolean");
  if (value.isUndefined()) return {};
  return value.as<bool>();
}

std::optional<std::string> OptionReader::text(const char* name) {
  const val value = member(name, "string");
  if (value.isUndefined()) return {};
  return textFrom(value);
}

bool OptionReader::isText(const char* name) const {
  return options_[name].isString();
}

bool OptionReader::isGiven(const char* name) {
  known_.emplace_back(name);
  const val value = options_[name];
  return !value.isUndefined() && !value.isNull();
}

void OptionReader::refuse(std::string message) {
  if (fault_.empty()) fault_ = std::move(message);
}

Result<void> OptionReader::check() const {
  if (!fault_.empty()) return fail(ErrorCode::kInvalidArgument, fault_);
  const val names = val::global("Object").call<val>("keys", options_);
  const auto count = names["length"].as<std::size_t>();
  for (std::size_t i = 0; i < count; ++i) {
    const auto name = textFrom(names[i]);
    if (std::find(known_.begin(), known_.end(), name) != known_.end()) continue;
    return fail(ErrorCode::kInvalidArgument,
                fmt::format("{}: found \"{}\", expected one of {}", what_, name, fmt::join(known_, ", ")));
  }
  return {};
}

}  // namespace stridegraph::bindings
