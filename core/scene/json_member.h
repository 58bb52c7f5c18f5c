#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include "base/result.h"
#include "math/types.h"
#include "scene/json_text.h"

namespace stridegraph {

/// kSceneValue with place, found and expected; null: the member is missing.
tl::unexpected<Error> unexpectedValue(const std::string& place, const Json* found, std::string_view expected);

/// An object of the scene and its place in it, for messages. A view: the JSON outlives it. Readers fail with
/// unexpectedValue.
class JsonMember {
 public:
  JsonMember(const Json& json, std::string place) : json_(&json), place_(std::move(place)) {}

  const Json& json() const { return *json_; }
  const std::string& place() const { return place_; }
  std::string placeOf(std::string_view name) const;

  const Json* find(std::string_view name) const;  ///< Null when there is none.
  Result<double> number(std::string_view name) const;
  Result<double> numberOr(std::string_view name, double otherwise) const;
  Result<Vec2> pair(std::string_view first, std::string_view second) const;
  Result<JsonMember> object(std::string_view name) const;

  /// Calls read(element) for each object of a list; stops at the first error.
  template <typename Read>
  Result<void> each(std::string_view name, std::size_t most, const Read& read) const {
    const Json* const list = find(name);
    if (list == nullptr || !list->is_array()) return unexpectedValue(placeOf(name), list, "a list");
    if (list->size() > most) {
      return fail(ErrorCode::kSceneValue, fmt::format("{}: found {} elements, expected at most {}",
                                                      placeOf(name), list->size(), most));
    }
    for (std::size_t i = 0; i < list->size(); ++i) {
      const JsonMember element((*list)[i], fmt::format("{}[{}]", placeOf(name), i));
      if (!element.json().is_object()) return unexpectedValue(element.place(), &element.json(), "an object");
      if (Result<void> done = read(element); !done) return done;
    }
    return {};
  }

 private:
  const Json* json_;
  std::string place_;
};

}  // namespace stridegraph
