#include "scene/scene_encoding.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string>

#include "base/utf8.h"
#include "scene/scene_limits.h"
#include "scene/text_place.h"

namespace stridegraph {
namespace {

using namespace std::string_view_literals;

/// The wide encoding that bytes are in, by their byte-order mark or by the zero bytes beside a first letter;
/// empty when there is no sign of one.
std::string_view wideEncodingOf(std::string_view bytes) {
  if (bytes.starts_with("\xff\xfe\0\0"sv) || bytes.starts_with("\0\0\xfe\xff"sv)) return "UTF-32";
  if (bytes.starts_with("\xff\xfe"sv) || bytes.starts_with("\xfe\xff"sv)) return "UTF-16";
  if (bytes.size() < 4) return {};
  if (bytes.starts_with("\0\0\0"sv) || bytes.substr(1).starts_with("\0\0\0"sv)) return "UTF-32";
  if ((bytes[0] == 0) != (bytes[1] == 0)) return "UTF-16";
  return {};
}

/// Offset of the first byte that belongs to no letter in UTF-8; the size where all do.
std::size_t firstBadByte(std::string_view text) {
  constexpr std::size_t kLongestLetter = 4;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t length = 1;
    while (length <= kLongestLetter && !isUtf8(text.substr(at, length))) ++length;
    if (length > kLongestLetter) return at;
    at += std::min(length, text.size() - at);
  }
  return text.size();
}

}  // namespace

Result<void> checkSceneEncoding(std::string_view bytes, std::string_view name) {
  if (bytes.size() > kMostSceneBytes) {
    return fail(ErrorCode::kSceneSyntax,
                fmt::format("found {} bytes, expected a scene of at most {}", bytes.size(), kMostSceneBytes),
                {std::string(name)});
  }
  if (const std::string_view wide = wideEncodingOf(bytes); !wide.empty()) {
    return fail(ErrorCode::kSceneSyntax, fmt::format("found text in {}, expected UTF-8", wide),
                {std::string(name)});
  }
  if (isUtf8(bytes)) return {};
  const std::size_t at = firstBadByte(bytes);
  return fail(
      ErrorCode::kSceneSyntax,
      fmt::format("found the byte 0x{:02X}, expected text in UTF-8", static_cast<unsigned char>(bytes[at])),
      placeInText(bytes, at, name));
}

}  // namespace stridegraph
