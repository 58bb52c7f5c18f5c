#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace stridegraph {

enum class ByteOrder { kLittleEndian, kBigEndian };

/// A UTF-16 text as UTF-8.
struct Utf16Text {
  std::string utf8;
  /// Surrogates without their other half; each became U+FFFD.
  std::size_t loneSurrogates = 0;
  /// True when the number of bytes was odd: the last one was left out.
  bool hasHalfUnit = false;
};

/// Reads bytes as UTF-16 (The Unicode Standard, section 3.9, definition D91). A byte-order mark at the
/// beginning is left out.
Utf16Text utf8FromUtf16(std::string_view bytes, ByteOrder order);

}  // namespace stridegraph
