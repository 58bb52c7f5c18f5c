#include "files.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace stridegraph::tools {
namespace {

tl::unexpected<Error> fileError(const std::string& path, const std::string& what) {
  return fail(ErrorCode::kFile, what + ": " + std::strerror(errno), {path});
}

}  // namespace

Result<std::string> readFile(const std::string& path) {
  if (std::filesystem::is_directory(path)) {
    return fail(ErrorCode::kFile, "found a folder, expected a file", {path});
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) return fileError(path, "cannot be opened");
  std::string content(std::istreambuf_iterator<char>(file), {});
  if (file.bad()) return fileError(path, "cannot be read");
  return content;
}

Result<void> writeFile(const std::string& path, std::string_view content) {
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  if (!file) return fileError(path, "cannot be written");
  file.write(content.data(), static_cast<std::streamsize>(content.size()));
  file.close();
  if (!file) return fileError(path, "cannot be written");
  return {};
}

Result<void> writeFile(const std::string& path, std::span<const std::uint8_t> bytes) {
  return writeFile(path, std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

std::span<const std::uint8_t> bytesOf(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

}  // namespace stridegraph::tools
