#pragma once

#include <string>
#include <vector>

#include "bench/summary.h"

namespace stridegraph::bench {

/// What the worst of the maps come to, for each library and place: maps with a way of up to 100 m, and longer
/// ones. Empty without guided walks.
std::string overviewTable(const std::vector<BenchRun>& runs);

/// For each library the guided search, natively and in Node.js, and all searches side by side; then paths.
std::string mapTables(const std::vector<BenchRun>& runs);

}  // namespace stridegraph::bench
