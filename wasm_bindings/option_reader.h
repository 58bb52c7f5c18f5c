#pragma once

#include <emscripten/val.h>

#include <optional>
#include <string>
#include <vector>

#include "base/result.h"

namespace stridegraph::bindings {

/// Reads the members of a JavaScript options object. The first wrong one is remembered and told by check();
/// a member that is missing, undefined or null is empty. Ranges are core's business.
class OptionReader {
 public:
  /// `what` names the object in messages: "plan options". Undefined and null stand for no options.
  OptionReader(emscripten::val options, std::string what);

  std::optional<double> number(const char* name);
  /// A whole number from 0 to 2^53 - 1.
  std::optional<double> wholeNumber(const char* name);
  std::optional<bool> flag(const char* name);
  std::optional<std::string> text(const char* name);
  /// Whether a member is given as a text; for those that may be a text or a number.
  bool isText(const char* name) const;

  /// Whether a member is there at all. It counts as asked for.
  bool isGiven(const char* name);

  void refuse(std::string message);
  /// The first fault, or a member that nobody asked for: a misspelt option must not pass unseen.
  Result<void> check() const;

 private:
  emscripten::val member(const char* name, const char* expectedType);

  emscripten::val options_;
  std::string what_;
  std::vector<std::string> known_;
  std::string fault_;
};

}  // namespace stridegraph::bindings
