#pragma once

#include <string>

#include "bench/bench_run.h"

namespace stridegraph::bench {

/// Every table of a document as Markdown: for each library a row per map, the searches side by side, paths,
/// random rooms, agreement of places, growth. Tables without a row are left out.
std::string benchTables(const BenchDocument& document);

}  // namespace stridegraph::bench
