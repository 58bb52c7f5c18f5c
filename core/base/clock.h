#pragma once

#include <functional>

namespace stridegraph {

/// Milliseconds since any fixed moment. Core owns no clock: whoever wants timings or a time budget hands one
/// in; without one, times are 0 and budgets in milliseconds never run out.
using MillisecondClock = std::function<double()>;

}  // namespace stridegraph
