#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace stridegraph::tools {

/// The whole file; kFile when it cannot be read.
Result<std::string> readFile(const std::string& path);

/// Replaces the file's content; kFile when it cannot be written.
Result<void> writeFile(const std::string& path, std::string_view content);
Result<void> writeFile(const std::string& path, std::span<const std::uint8_t> bytes);

/// The bytes of a text, borrowed.
std::span<const std::uint8_t> bytesOf(std::string_view text);

}  // namespace stridegraph::tools
