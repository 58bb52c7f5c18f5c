#pragma once

#include <chrono>

namespace stridegraph::tools {

/// The clock of programs: milliseconds since some moment, never going back.
inline double millisecondsNow() {
  using Milliseconds = std::chrono::duration<double, std::milli>;
  return Milliseconds(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace stridegraph::tools
