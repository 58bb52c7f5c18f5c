#include <gtest/gtest.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <ostream>
#include <vector>

#include "target.h"

namespace stridegraph::fuzz {

/// How GoogleTest shows a target.
void PrintTo(const Target& target, std::ostream* out) {
  *out << target.name;
}

namespace {

std::vector<std::filesystem::path> corpusOf(std::string_view target) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(STRIDEGRAPH_FUZZ_CORPUS) / target))
    files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<std::uint8_t> bytesOf(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  EXPECT_TRUE(file.is_open()) << path;
  return {std::istreambuf_iterator<char>(file), {}};
}

/// What fuzzing found worth keeping is tried again, without libFuzzer.
class FuzzCorpus : public ::testing::TestWithParam<Target> {};

TEST_P(FuzzCorpus, breaksNoPromise) {
  const std::vector<std::filesystem::path> files = corpusOf(GetParam().name);
  ASSERT_FALSE(files.empty());
  for (const std::filesystem::path& path : files) {
    try {
      GetParam().run(bytesOf(path));
    } catch (const std::exception& broken) {
      ADD_FAILURE() << path << ": " << broken.what();
    }
  }
}

TEST_P(FuzzCorpus, breaksNoPromiseWithoutBytes) {
  EXPECT_NO_THROW(GetParam().run({}));
}

INSTANTIATE_TEST_SUITE_P(All, FuzzCorpus, ::testing::ValuesIn(kTargets),
                         [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace stridegraph::fuzz
