#include "figures/png.h"

#include <algorithm>

#include "scene/base64_url.h"

#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#include <stb_image_write.h>

namespace stridegraph::figures {
namespace {

void appendBytes(void* context, void* data, int size) {
  auto& bytes = *static_cast<std::vector<std::uint8_t>*>(context);
  const auto* first = static_cast<const std::uint8_t*>(data);
  bytes.insert(bytes.end(), first, first + size);
}

}  // namespace

std::string base64(std::span<const std::uint8_t> bytes) {
  std::string text = toBase64Url(bytes);
  std::replace(text.begin(), text.end(), '-', '+');
  std::replace(text.begin(), text.end(), '_', '/');
  text.append((4 - text.size() % 4) % 4, '=');
  return text;
}

std::string pngDataUri(const PixelImage& image) {
  std::vector<std::uint8_t> bytes;
  const int width = static_cast<int>(image.width);
  const int channels = static_cast<int>(image.channels);
  stbi_write_png_to_func(appendBytes, &bytes, width, static_cast<int>(image.height), channels,
                         image.bytes.data(), channels * width);
  return "data:image/png;base64," + base64(bytes);
}

}  // namespace stridegraph::figures
