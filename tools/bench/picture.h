#pragma once

#include "bench/bench_run.h"
#include "figures/svg.h"

namespace stridegraph::bench {

/// What was measured in one picture: times and lengths of walks by map and library, the searches and the
/// paths side by side, times in random rooms, growth. Panels without anything to show are left out.
figures::Svg benchPicture(const BenchDocument& document);

}  // namespace stridegraph::bench
