#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "base/result.h"

namespace stridegraph::tools {

/// The largest files that are read; larger ones are refused before memory is taken for them.
inline constexpr std::uint64_t kMostLibraryBytes = (std::uint64_t{1} << 31U) - 1;
inline constexpr std::uint64_t kMostReportBytes = std::uint64_t{1} << 30U;

/// For how long a pipe may give nothing before it is given up.
inline constexpr int kPipeMilliseconds = 30'000;

/// The whole file, or all that a pipe gives. kFile when it cannot be read, is a folder or a device, or holds
/// more than `mostBytes`, and for a pipe that nothing writes to or that gives nothing for kPipeMilliseconds.
/// The error's file is the path as shownText() gives it.
Result<std::string> readFile(const std::string& path, std::uint64_t mostBytes = kMostReportBytes);

/// The bytes of a text, borrowed.
std::span<const std::uint8_t> bytesOf(std::string_view text);

/// The bytes as text, borrowed.
std::string_view textOf(std::span<const std::uint8_t> bytes);

}  // namespace stridegraph::tools
