#pragma once

#include <cstdlib>

/// Ends the program when a caller broke a promise stated in a header. Never for input: input gets a Result.
#define STRIDEGRAPH_CHECK(condition) \
  do {                               \
    if (!(condition)) std::abort();  \
  } while (false)
