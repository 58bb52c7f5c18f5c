#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/result.h"
#include "graph/library.h"

namespace stridegraph {

/// The library as .sgraph bytes (FlatBuffers): self-contained and the same for the same library.
std::vector<std::uint8_t> writeSgraph(const MotionLibrary& library);

/// Loads .sgraph bytes. Everything is verified before it is used: structure, version, hash, every index and
/// number. Fails with kAssetDamaged or kAssetVersion.
Result<MotionLibrary> readSgraph(std::span<const std::uint8_t> bytes);

}  // namespace stridegraph
