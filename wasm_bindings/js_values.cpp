#include "js_values.h"

namespace stridegraph::bindings {
namespace {

using emscripten::val;

val describedPlace(const std::string& message, const Place& place) {
  val object = val::object();
  object.set("message", message);
  object.set("file", place.file);
  object.set("line", static_cast<double>(place.line));
  object.set("column", static_cast<double>(place.column));
  return object;
}

}  // namespace

val succeed(val value) {
  val answer = val::object();
  answer.set("value", value);
  return answer;
}

val refuse(const Error& error) {
  val reason = describedPlace(error.message, error.place);
  reason.set("code", std::string(errorCodeName(error.code)));
  val answer = val::object();
  answer.set("error", reason);
  return answer;
}

val floorPoints(std::span<const Vec2> points) {
  std::vector<float> numbers;
  numbers.reserve(points.size() * 2);
  for (const Vec2& point : points) {
    numbers.push_back(static_cast<float>(point.x()));
    numbers.push_back(static_cast<float>(point.y()));
  }
  return copyOut<float>(numbers);
}

val warningList(const Warnings& warnings) {
  val list = val::array();
  for (const Warning& warning : warnings) {
    val described = describedPlace(warning.message, warning.place);
    described.set("topic", std::string(warningTopicName(warning.topic)));
    list.call<void>("push", described);
  }
  return list;
}

}  // namespace stridegraph::bindings
