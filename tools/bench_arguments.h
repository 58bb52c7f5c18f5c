#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "bench/measuring.h"
#include "program/file_identity.h"

namespace stridegraph::tools {

/// What `stridegraph bench` is asked.
struct BenchArguments {
  std::string mapsFolder;
  std::vector<std::string> graphPaths;
  std::vector<std::string> methods = {"exact",           "prm",    "rrt-connect",   "guided",
                                      "guided-improved", "thesis", "thesis-checked"};
  std::uint64_t seeds = 20;
  std::optional<std::uint64_t> randomSeed;
  std::uint64_t firstRoom = 1;
  std::uint64_t rooms = 1000;
  std::string writtenFolder;
  std::vector<std::size_t> frames;
  std::vector<std::size_t> rectangles;
  std::vector<std::size_t> walkers;
  std::vector<std::string> joinedPaths;
  std::string jsonPath;
  std::string markdownPath;
  std::string picturePath;
  bool processorTime = false;
  bool isQuiet = false;
  bench::MeasureParams measure;
  std::vector<std::string> given;  ///< Names of the options that were given.

  bool asksFor(std::string_view method) const;
  bool isGiven(std::string_view option) const;
};

/// Adds the options of the command; all but `given` are in `arguments` once they are parsed.
void addBenchOptions(CLI::App& command, const std::shared_ptr<BenchArguments>& arguments);

/// Refuses arguments that ask for nothing, with what to give; kInvalidArgument.
Result<void> checkBenchWork(const BenchArguments& arguments);

/// Refuses outputs that would overwrite an input or one another; kFile.
Result<void> checkBenchPaths(const BenchArguments& arguments);

/// Options that make no difference beside the others, a note each.
Warnings uselessOptions(const BenchArguments& arguments);

}  // namespace stridegraph::tools
