#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "program/files.h"

namespace stridegraph::tools {

/// A folder of its own for each test, since they run side by side.
class TestFolder : public ::testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string in(const std::string& name) const { return (folder_ / name).string(); }
  std::string content(const std::string& name) const { return readFile(in(name)).value_or("unreadable"); }
  /// How many files and folders there are, hidden ones included.
  std::size_t entryCount() const {
    std::size_t count = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder_)) ++count;
    return count;
  }

  const std::filesystem::path folder_ =
      std::filesystem::path(::testing::TempDir()) /
      (std::string("stridegraph_") +
       ::testing::UnitTest::GetInstance()->current_test_info()->test_suite_name() + "_" +
       ::testing::UnitTest::GetInstance()->current_test_info()->name());
};

}  // namespace stridegraph::tools
