#include "base/utf8.h"

#include <array>
#include <cstddef>

namespace stridegraph {
namespace {

constexpr char32_t kReplacement = 0xFFFD;
constexpr char32_t kLargestCodePoint = 0x10FFFF;

/// Code points of the bytes 0x80 to 0x9F in Windows-1252; all other bytes are their own code points.
constexpr std::array<char32_t, 32> kWindows1252 = {
    0x20AC, 0x0081, 0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, 0x02C6, 0x2030, 0x0160,
    0x2039, 0x0152, 0x008D, 0x017D, 0x008F, 0x0090, 0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
    0x2013, 0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0x009D, 0x017E, 0x0178};

unsigned char byteAt(std::string_view bytes, std::size_t at) {
  return static_cast<unsigned char>(bytes[at]);
}

bool isBetween(unsigned char value, unsigned char low, unsigned char high) {
  return value >= low && value <= high;
}

/// Bytes of the well-formed sequence that begins at `at`; 0 when none does.
std::size_t sequenceLength(std::string_view bytes, std::size_t at) {
  const unsigned char lead = byteAt(bytes, at);
  if (lead < 0x80) return 1;
  const std::size_t length = isBetween(lead, 0xC2, 0xDF)   ? 2
                             : isBetween(lead, 0xE0, 0xEF) ? 3
                             : isBetween(lead, 0xF0, 0xF4) ? 4
                                                           : 0;
  if (length == 0 || bytes.size() - at < length) return 0;
  // The second byte's range excludes overlong forms, surrogates and what lies beyond U+10FFFF.
  const unsigned char lowest = lead == 0xE0 ? 0xA0 : lead == 0xF0 ? 0x90 : 0x80;
  const unsigned char highest = lead == 0xED ? 0x9F : lead == 0xF4 ? 0x8F : 0xBF;
  if (!isBetween(byteAt(bytes, at + 1), lowest, highest)) return 0;
  for (std::size_t i = 2; i < length; ++i) {
    if (!isBetween(byteAt(bytes, at + i), 0x80, 0xBF)) return 0;
  }
  return length;
}

}  // namespace

bool isUtf8(std::string_view bytes) {
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t length = sequenceLength(bytes, at);
    if (length == 0) return false;
    at += length;
  }
  return true;
}

std::string toUtf8(std::string_view bytes) {
  if (isUtf8(bytes)) return std::string(bytes);
  std::string text;
  text.reserve(bytes.size() + bytes.size() / 8);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const unsigned char byte = byteAt(bytes, i);
    appendUtf8(isBetween(byte, 0x80, 0x9F) ? kWindows1252[byte - 0x80U] : byte, text);
  }
  return text;
}

void appendUtf8(char32_t codePoint, std::string& text) {
  const bool isSurrogate = codePoint >= 0xD800 && codePoint <= 0xDFFF;
  if (isSurrogate || codePoint > kLargestCodePoint) codePoint = kReplacement;
  const auto put = [&](char32_t bits) { text.push_back(static_cast<char>(bits)); };
  const auto continuation = [&](int shift) { put(0x80U | ((codePoint >> shift) & 0x3FU)); };
  if (codePoint < 0x80) {
    put(codePoint);
  } else if (codePoint < 0x800) {
    put(0xC0U | (codePoint >> 6));
    continuation(0);
  } else if (codePoint < 0x10000) {
    put(0xE0U | (codePoint >> 12));
    continuation(6);
    continuation(0);
  } else {
    put(0xF0U | (codePoint >> 18));
    continuation(12);
    continuation(6);
    continuation(0);
  }
}

}  // namespace stridegraph
