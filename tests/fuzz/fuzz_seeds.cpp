#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

#include "graph/sgraph_file.h"
#include "graph/test_library.h"
#include "math/random.h"
#include "scene/base64_url.h"
#include "scene/scene_json.h"
#include "scene/scene_link.h"
#include "target.h"
#include "walk/test_library.h"

namespace stridegraph::fuzz {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kRowsKept = 4;

std::string textOf(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void write(const fs::path& path, std::string_view bytes) {
  std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

void write(const fs::path& path, Bytes bytes) {
  write(path, std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

/// A motion file with its first rows only: what is odd about a file is odd about a small one.
std::string cut(const std::string& text) {
  std::istringstream lines(text);
  std::string kept;
  std::size_t rows = 0;
  bool inRows = false;
  for (std::string line; rows < kRowsKept && std::getline(lines, line);) {
    kept += line + "\n";
    if (inRows) ++rows;
    if (line.starts_with("Frame Time")) inRows = true;
  }
  return kept;
}

/// Calls visit(path) for each file of the test data with that ending.
template <typename Visit>
void eachFile(const fs::path& folder, const std::string& ending, const Visit& visit) {
  if (!fs::exists(folder)) return;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().extension() == ending) visit(entry.path());
}

void writeTexts(const fs::path& source, const fs::path& seeds) {
  eachFile(source / "tests/data", ".bvh", [&](const fs::path& path) {
    const std::string text = textOf(path);
    write(seeds / "bvh" / path.filename(), text.size() > 8000 ? cut(text) : text);
  });
  const auto scene = [&](const fs::path& path) {
    const std::string text = textOf(path);
    write(seeds / "scene" / path.filename(), text);
    const Result<Scene> read = readSceneJson(text);
    if (!read) return;
    SharedScene shared;
    shared.scene = *read;
    const std::string link = encodeLink(shared);
    write(seeds / "link" / path.stem(), link);
    const auto bytes = fromBase64Url(std::string_view(link).substr(2));
    write(seeds / "link" / (path.stem().string() + "_body"), Bytes(*bytes).first(bytes->size() - 4));
  };
  eachFile(source / "tests/data", ".json", scene);
  eachFile(source / "public/scenes", ".json", scene);
}

void writeLibraries(const fs::path& seeds) {
  write(seeds / "sgraph/arcs.sgraph", writeSgraph(testing::threeArcs()));
  write(seeds / "sgraph/arcs_and_a_stop.sgraph", writeSgraph(testing::threeArcsAndAStop()));
}

/// For targets that make things of bytes.
void writeRandomBytes(const fs::path& seeds) {
  Random random(1);
  for (const Target& target : kTargets) {
    if (target.name == "bvh" || target.name == "scene") continue;
    for (std::size_t count = 0; count < 60; ++count) {
      std::vector<std::uint8_t> bytes(8 + random.below(120));
      for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.bits());
      write(seeds / target.name / ("random_" + std::to_string(count)), bytes);
    }
  }
}

}  // namespace
}  // namespace stridegraph::fuzz

/// fuzz_seeds SOURCE FOLDER: what each target begins with, from the test data of the source folder.
int main(int argc, char** argv) {
  using namespace stridegraph::fuzz;
  if (argc != 3) {
    std::fputs("fuzz_seeds SOURCE FOLDER\n", stderr);
    return 2;
  }
  const fs::path seeds = argv[2];
  for (const Target& target : kTargets) fs::create_directories(seeds / target.name);
  writeTexts(argv[1], seeds);
  writeLibraries(seeds);
  writeRandomBytes(seeds);
  return 0;
}
