#pragma once

#include <span>

#include "base/result.h"
#include "graph/jerks.h"
#include "graph/library_builder.h"

namespace stridegraph {

/// Makes the graph of a library that has its frames, clips and regions; nothing plays or blends across the
/// jerks (ascending). Reports what pruning leaves. Fails with kEmptyGraph when that is nothing.
Result<void> connectLibrary(MotionLibrary& library, std::span<const Jerk> jerks, BuildReport& report);

}  // namespace stridegraph
