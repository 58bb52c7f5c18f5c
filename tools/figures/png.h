#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace stridegraph::figures {

/// A picture of pixels: rows from top to bottom; red, green, blue and, with four channels, opacity for each.
struct PixelImage {
  std::size_t width = 0;
  std::size_t height = 0;
  std::size_t channels = 3;
  std::vector<std::uint8_t> bytes;  ///< width x height x channels.
};

/// The bytes as base64 with padding (RFC 4648, section 4).
std::string base64(std::span<const std::uint8_t> bytes);

/// The image as "data:image/png;base64,...".
std::string pngDataUri(const PixelImage& image);

}  // namespace stridegraph::figures
