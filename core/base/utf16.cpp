#include "base/utf16.h"

#include "base/utf8.h"

namespace stridegraph {
namespace {

constexpr char32_t kByteOrderMark = 0xFEFF;
constexpr char32_t kReplacement = 0xFFFD;

bool isHighSurrogate(char32_t unit) {
  return unit >= 0xD800 && unit <= 0xDBFF;
}

bool isLowSurrogate(char32_t unit) {
  return unit >= 0xDC00 && unit <= 0xDFFF;
}

char32_t unitAt(std::string_view bytes, ByteOrder order, std::size_t at) {
  const auto first = static_cast<unsigned char>(bytes[at]);
  const auto second = static_cast<unsigned char>(bytes[at + 1]);
  const bool isLittle = order == ByteOrder::kLittleEndian;
  return static_cast<char32_t>(isLittle ? second : first) << 8U | (isLittle ? first : second);
}

}  // namespace

Utf16Text utf8FromUtf16(std::string_view bytes, ByteOrder order) {
  Utf16Text text;
  text.hasHalfUnit = bytes.size() % 2 != 0;
  const std::size_t end = bytes.size() - bytes.size() % 2;
  text.utf8.reserve(end / 2 + end / 8);
  std::size_t at = end >= 2 && unitAt(bytes, order, 0) == kByteOrderMark ? 2 : 0;
  while (at < end) {
    const char32_t unit = unitAt(bytes, order, at);
    at += 2;
    char32_t codePoint = unit;
    if (isHighSurrogate(unit) && at < end && isLowSurrogate(unitAt(bytes, order, at))) {
      codePoint = 0x10000 + ((unit - 0xD800) << 10U) + (unitAt(bytes, order, at) - 0xDC00);
      at += 2;
    } else if (isHighSurrogate(unit) || isLowSurrogate(unit)) {
      codePoint = kReplacement;
      ++text.loneSurrogates;
    }
    appendUtf8(codePoint, text.utf8);
  }
  return text;
}

}  // namespace stridegraph
