#pragma once

#include <chrono>
#include <ctime>

namespace stridegraph::tools {

/// The clock of programs: milliseconds since some moment, never going back.
inline double millisecondsNow() {
  using Milliseconds = std::chrono::duration<double, std::milli>;
  return Milliseconds(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Milliseconds that the processor has spent on this program: what else runs beside it hardly counts.
inline double processorMillisecondsNow() {
  return 1000.0 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

}  // namespace stridegraph::tools
