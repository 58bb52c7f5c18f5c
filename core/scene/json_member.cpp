#include "scene/json_member.h"

namespace stridegraph {

tl::unexpected<Error> unexpectedValue(const std::string& place, const Json* found,
                                      std::string_view expected) {
  return fail(ErrorCode::kSceneValue, fmt::format("{}: found {}, expected {}", place,
                                                  found == nullptr ? "nothing" : quoted(*found), expected));
}

std::string JsonMember::placeOf(std::string_view name) const {
  return place_.empty() ? std::string(name) : fmt::format("{}.{}", place_, name);
}

const Json* JsonMember::find(std::string_view name) const {
  const auto found = json_->find(std::string(name));
  return found == json_->end() ? nullptr : &*found;
}

Result<double> JsonMember::number(std::string_view name) const {
  const Json* const value = find(name);
  if (value == nullptr || !value->is_number()) return unexpectedValue(placeOf(name), value, "a number");
  return value->get<double>();
}

Result<double> JsonMember::numberOr(std::string_view name, double otherwise) const {
  return find(name) == nullptr ? Result<double>(otherwise) : number(name);
}

Result<Vec2> JsonMember::pair(std::string_view first, std::string_view second) const {
  Result<double> x = number(first);
  if (!x) return fail(std::move(x));
  Result<double> y = number(second);
  if (!y) return fail(std::move(y));
  return Vec2(*x, *y);
}

Result<JsonMember> JsonMember::object(std::string_view name) const {
  const Json* const value = find(name);
  if (value == nullptr || !value->is_object()) return unexpectedValue(placeOf(name), value, "an object");
  return JsonMember(*value, placeOf(name));
}

}  // namespace stridegraph
