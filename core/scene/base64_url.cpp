#include "scene/base64_url.h"

namespace stridegraph {

namespace {

constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";

}  // namespace

std::string toBase64Url(std::span<const std::uint8_t> bytes) {
  std::string text;
  text.reserve((bytes.size() * 4 + 2) / 3);
  std::uint32_t pending = 0;
  int bits = 0;
  for (const std::uint8_t byte : bytes) {
    pending = (pending << 8U) | byte;
    for (bits += 8; bits >= 6; bits -= 6)
      text += kLetters[(pending >> static_cast<unsigned>(bits - 6)) & 63U];
  }
  if (bits > 0) text += kLetters[(pending << static_cast<unsigned>(6 - bits)) & 63U];
  return text;
}

std::optional<std::vector<std::uint8_t>> fromBase64Url(std::string_view text) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(text.size() * 3 / 4);
  std::uint32_t pending = 0;
  int bits = 0;
  for (const char letter : text) {
    const std::size_t value = kLetters.find(letter);
    if (value == std::string_view::npos) return std::nullopt;
    pending = (pending << 6U) | static_cast<std::uint32_t>(value);
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes.push_back(static_cast<std::uint8_t>((pending >> static_cast<unsigned>(bits)) & 255U));
  }
  // Six bits left are a letter too many, and bits after the last byte must be zero.
  if (bits >= 6 || (pending & ((1U << static_cast<unsigned>(bits)) - 1U)) != 0) return std::nullopt;
  return bytes;
}

}  // namespace stridegraph
