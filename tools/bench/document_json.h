#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "bench/bench_run.h"

namespace stridegraph::bench {

/// {"runs": [{"place": "native", "library": "default", "set": "maps", "room": "01_empty", "method": "guided",
/// "seed": 1, "status": "arrived", "shortest_m": 21.9, "total_ms": 9.1, ...}], "growth": [{"place": "native",
/// "what": "frames", "size": 1000, "figures": {"build s": 0.1}}]}
std::string writeBenchJson(const BenchDocument& document);

/// Adds what a text of that form holds to a document; members of a run that are missing stay as in a new
/// BenchRun. A text without a list of runs is kInvalidArgument; `name` becomes the error's file. A run
/// without a shortest path takes that of the same room, where the document knows it.
Result<void> joinBenchJson(std::string_view text, const std::string& name, BenchDocument& document);

}  // namespace stridegraph::bench
