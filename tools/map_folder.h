#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "bench/bench_run.h"

namespace stridegraph::tools {

/// Finds the exact shortest path of a room's disc and notes its length.
void noteShortest(bench::BenchRoom& room);

/// The maps of a folder, by name, with the lengths in its shortest_paths.txt ("NAME METRES" or "NAME none");
/// those that it does not name are found here. What is odd about the scenes goes to `notes` where it is not
/// null.
Result<std::vector<bench::BenchRoom>> readMapFolder(const std::string& folder, Warnings* notes = nullptr);

/// Writes rooms as a folder of that kind, which is made where it is not there.
Result<void> writeMapFolder(const std::vector<bench::BenchRoom>& rooms, const std::string& folder);

}  // namespace stridegraph::tools
