#pragma once

#include <vector>

#include "bench/bench_run.h"
#include "bench/panel.h"

namespace stridegraph::bench {

/// Times and lengths of walks by map and library, the searches and the paths side by side; of what was not
/// measured no panel.
std::vector<Panel> mapPanels(const BenchDocument& document);

}  // namespace stridegraph::bench
