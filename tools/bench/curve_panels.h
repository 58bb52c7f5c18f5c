#pragma once

#include <vector>

#include "bench/bench_run.h"
#include "bench/panel.h"

namespace stridegraph::bench {

/// How times in random rooms lie: one panel, or none where none were measured.
std::vector<Panel> randomPanels(const BenchDocument& document);

/// For each kind of growth a panel with every figure that is a time.
std::vector<Panel> growthPanels(const BenchDocument& document);

}  // namespace stridegraph::bench
