#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/result.h"
#include "graph/library.h"

namespace stridegraph {

/// The version of .sgraph files that this program writes and reads. It changes with the schema,
/// and whenever the same clips would give other regions: a library to append to must not mix two ways.
inline constexpr std::uint32_t kSgraphVersion = 2;

/// The library as .sgraph bytes (FlatBuffers): self-contained and the same for the same library. Frames and
/// joint angles are written as 32 bit floats. Of the library's hash no notice is taken: the bytes' own goes
/// in. All texts are written as UTF-8 (toUtf8()), and of the notes those that keepableNotes() leaves.
std::vector<std::uint8_t> writeSgraph(const MotionLibrary& library);

/// The hash that writeSgraph() puts into the bytes: MotionLibrary::hash of what readSgraph() makes of them.
/// Notes do not count, so that a library with them and one without walk from the same links.
std::uint64_t sgraphHash(const MotionLibrary& library);

/// Loads .sgraph bytes, at any address. Everything is verified before it is used: structure, version, hash,
/// every index, number and count, and that the graph is one strongly connected part. Texts that are not
/// UTF-8, which older programs wrote, are read as toUtf8() does. Fails with kAssetDamaged, or with
/// kAssetVersion for files of another version.
Result<MotionLibrary> readSgraph(std::span<const std::uint8_t> bytes);

}  // namespace stridegraph
