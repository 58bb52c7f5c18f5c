#pragma once

/// STRIDEGRAPH_WIDE marks a function that may use the 32 byte registers of AVX2. Call it only where
/// hasWideRegisters() says so, and give it nothing whose result depends on the width: sums of many numbers in
/// one lane each, never one sum across lanes. Multiplications and additions are never fused (-ffp-contract).
#if defined(__x86_64__)
#define STRIDEGRAPH_WIDE __attribute__((target("avx2")))
#else
#define STRIDEGRAPH_WIDE
#endif

/// Puts the same code into both the plain and the wide function that call it.
#define STRIDEGRAPH_INLINE inline __attribute__((always_inline))

namespace stridegraph {

inline bool hasWideRegisters() {
#if defined(__x86_64__)
  return __builtin_cpu_supports("avx2") != 0;
#else
  return false;
#endif
}

}  // namespace stridegraph
