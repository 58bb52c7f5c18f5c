#pragma once

#include <cstdint>
#include <string>

namespace stridegraph::tools {

/// A figure for people: three digits that count, or all digits before the point, and no zeros after the last:
/// "0.0512", "12.3", "1235". Reports hold all digits.
std::string rounded(double value);

/// A duration in two units at most: "0.4 s", "12 s", "3 min 20 s", "2 h 5 min". 0 or more.
std::string roundedSeconds(double seconds);

/// A number of bytes: "512 bytes", "16 MiB", "1.5 GiB".
std::string roundedBytes(std::uint64_t bytes);

}  // namespace stridegraph::tools
