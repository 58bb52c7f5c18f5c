#include "motion/captures.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>

namespace stridegraph::testing {

std::vector<std::filesystem::path> captures(std::string_view folder) {
  const char* const root = std::getenv("STRIDEGRAPH_MOCAP");
  std::vector<std::filesystem::path> files;
  if (root == nullptr) return files;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(std::filesystem::path(root) / folder)) {
    if (entry.path().extension() == ".bvh") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::string contentOf(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace stridegraph::testing
