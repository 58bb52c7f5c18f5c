#pragma once

#include <string>
#include <string_view>

namespace stridegraph {

/// True when the bytes are well-formed UTF-8: no overlong forms, no surrogates, nothing above U+10FFFF
/// (The Unicode Standard, table 3-7).
bool isUtf8(std::string_view bytes);

/// The bytes unchanged when they are UTF-8; otherwise as UTF-8 after reading every byte as Windows-1252.
/// Bytes that Windows-1252 leaves undefined become the control characters of Latin-1 (WHATWG Encoding
/// Standard, index windows-1252), so that no byte is lost.
std::string toUtf8(std::string_view bytes);

/// Appends the UTF-8 form of a code point. Surrogates and values above U+10FFFF become U+FFFD.
void appendUtf8(char32_t codePoint, std::string& text);

}  // namespace stridegraph
