#pragma once

#include <optional>
#include <span>

#include "base/error.h"
#include "graph/library.h"
#include "motion/bvh_reader.h"

namespace stridegraph {

/// Why clips cannot make up one library: every clip that is not sound, with kInvalidArgument; every clip
/// whose skeleton is another than that of most clips, with kSkeletonMismatch and the joints that differ; more
/// clips or frames than a library holds (library_limits.h). Empty when nothing is wrong. The message has a
/// line for each clip or group of clips where there are several, and counts what it does not name.
std::optional<Error> faultInClips(std::span<const BvhDocument> clips, const LibraryParams& params);

/// The same for clips that are to join a library: its skeleton is the one expected.
std::optional<Error> faultInClips(std::span<const BvhDocument> clips, const MotionLibrary& library);

}  // namespace stridegraph
