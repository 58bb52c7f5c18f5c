#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace stridegraph {

/// Bytes as letters that need no escaping in an address: base64url without padding (RFC 4648, section 5).
std::string toBase64Url(std::span<const std::uint8_t> bytes);

/// The bytes again; nothing unless the text is exactly what toBase64Url writes.
std::optional<std::vector<std::uint8_t>> fromBase64Url(std::string_view text);

}  // namespace stridegraph
