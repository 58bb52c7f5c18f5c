#include "scene/json_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "scene/scene_limits.h"
#include "scene/text_place.h"

namespace stridegraph {

namespace {

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
  bool key(string_t&) override { return ++members_.back() <= kMostJsonMembers; }
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
    if (members_.size() > kMostJsonLevels)
      return fmt::format("found more than {} levels of nesting, expected a scene", kMostJsonLevels);
    if (!members_.empty() && members_.back() > kMostJsonMembers)
      return fmt::format("found an object of more than {} members, expected a scene", kMostJsonMembers);
    if (outOfRange_)
      return fmt::format("found the number {}, expected one that a double can hold", shortToken());
    if (token_.empty() || token_ == "<U+0000>") return "the text ends early, expected more JSON";
    return fmt::format("found '{}', expected valid JSON", shortToken());
  }

 private:
  static constexpr int kNumberOutOfRange = 406;

  bool enter() {
    members_.push_back(0);
    return members_.size() <= kMostJsonLevels;
  }
  bool leave() {
    members_.pop_back();
    return true;
  }
  /// The end of the token, where the trouble is, in letters that any terminal shows.
  std::string shortToken() const {
    std::string shown = token_.size() > kLongestQuote ? token_.substr(token_.size() - kLongestQuote) : token_;
    std::replace_if(
        shown.begin(), shown.end(), [](char letter) { return letter < ' ' || letter > '~'; }, '?');
    return shown;
  }

  std::vector<std::size_t> members_;  ///< Of each object or list that is open: how many it has so far.
  std::size_t position_ = 0;
  std::string token_;
  bool outOfRange_ = false;
};

}  // namespace

Result<Json> parseJson(std::string_view text, std::string_view name) {
  SyntaxCheck check;
  if (!Json::sax_parse(text.begin(), text.end(), &check)) {
    return fail(
        ErrorCode::kSceneSyntax, check.message(),
        check.position() == 0 ? Place{std::string(name)} : placeInText(text, check.position() - 1, name));
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
