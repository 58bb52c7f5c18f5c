#include "scene/json_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string>

namespace stridegraph {

namespace {

/// Deeper nesting is refused: writing such a value back would need as deep a stack.
constexpr int kMostLevels = 64;
constexpr std::size_t kLongestQuote = 40;

/// Walks over a text without keeping it, to find out where it goes wrong.
class SyntaxCheck : public nlohmann::json_sax<Json> {
 public:
  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool string(string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool key(string_t&) override { return true; }
  bool start_object(std::size_t) override { return enter(); }
  bool end_object() override { return leave(); }
  bool start_array(std::size_t) override { return enter(); }
  bool end_array() override { return leave(); }
  bool parse_error(std::size_t position, const std::string& token,
                   const nlohmann::detail::exception& exception) override {
    position_ = position;
    token_ = token;
    outOfRange_ = exception.id == kNumberOutOfRange;
    return false;
  }

  /// One past the offset of the byte at which reading stopped.
  std::size_t position() const { return position_; }
  std::string message() const {
    if (levels_ > kMostLevels) {
      return fmt::format("found more than {} levels of nesting, expected a scene", kMostLevels);
    }
    if (outOfRange_)
      return fmt::format("found the number {}, expected one that a double can hold", shortToken());
    if (token_.empty() || token_ == "<U+0000>") return "the text ends early, expected more JSON";
    return fmt::format("found '{}', expected valid JSON", shortToken());
  }

 private:
  static constexpr int kNumberOutOfRange = 406;

  bool enter() { return ++levels_ <= kMostLevels; }
  bool leave() {
    --levels_;
    return true;
  }
  /// The end of the token, where the trouble is, in letters that any terminal shows.
  std::string shortToken() const {
    std::string shown = token_.size() > kLongestQuote ? token_.substr(token_.size() - kLongestQuote) : token_;
    std::replace_if(
        shown.begin(), shown.end(), [](char letter) { return letter < ' ' || letter > '~'; }, '?');
    return shown;
  }

  int levels_ = 0;
  std::size_t position_ = 0;
  std::string token_;
  bool outOfRange_ = false;
};

Place placeOf(std::string_view text, std::size_t position, std::string_view name) {
  if (position == 0) return {std::string(name), 0, 0};
  const std::string_view before = text.substr(0, std::min(position - 1, text.size()));
  const auto line = static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n')) + 1;
  const std::size_t lineStart = before.rfind('\n');
  const std::size_t column =
      lineStart == std::string_view::npos ? before.size() : before.size() - lineStart - 1;
  return {std::string(name), line, column + 1};
}

}  // namespace

Result<Json> parseJson(std::string_view text, std::string_view name) {
  SyntaxCheck check;
  if (!Json::sax_parse(text.begin(), text.end(), &check)) {
    return fail(ErrorCode::kSceneSyntax, check.message(), placeOf(text, check.position(), name));
  }
  return Json::parse(text.begin(), text.end(), nullptr, false);
}

std::string quoted(const Json& value) {
  if (value.is_object()) return "an object";
  if (value.is_array()) return "a list";
  const std::string text = value.dump(-1, ' ', true, Json::error_handler_t::replace);
  if (text.size() <= kLongestQuote) return text;
  return value.is_string() ? "a long text" : "a long number";
}

}  // namespace stridegraph
