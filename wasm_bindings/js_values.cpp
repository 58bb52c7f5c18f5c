#include "js_values.h"

#include "base/utf8.h"

namespace stridegraph::bindings {
namespace {

using emscripten::val;

val describedPlace(const std::string& message, const Place& place) {
  val object = val::object();
  object.set("message", textValue(message));
  object.set("file", textValue(place.file));
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

std::string textFrom(const val& text) {
  const auto units = text.as<std::u16string>();
  std::string utf8;
  utf8.reserve(units.size());
  for (std::size_t i = 0; i < units.size(); ++i) {
    const char32_t unit = units[i];
    const char32_t next = i + 1 < units.size() ? units[i + 1] : U'\0';
    const bool isPair = unit >= 0xD800 && unit < 0xDC00 && next >= 0xDC00 && next < 0xE000;
    appendUtf8(isPair ? 0x10000 + ((unit - 0xD800) << 10U) + (next - 0xDC00) : unit, utf8);
    if (isPair) ++i;
  }
  return utf8;
}

val textValue(std::string_view text) {
  return val(toUtf8(text));
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
