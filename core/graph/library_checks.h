#pragma once

#include <optional>
#include <string>

#include "graph/library.h"

namespace stridegraph {

/// Each says in a sentence what breaks the rules of graph/library.h, and is empty when nothing does.

std::optional<std::string> faultIn(const LibraryParams& params);
/// One root, first; parents before children; offsets of at most 1e6 m; end sites without children.
std::optional<std::string> faultIn(const Skeleton& skeleton);
/// Right number of rotations; positions within 1e6 m; rotations of unit length within 1e-3; a rate > 0.
std::optional<std::string> faultIn(const Skeleton& skeleton, const Clip& clip);
/// Everything, indices, order and amounts (library_limits.h) included, and the graph strongly connected.
std::optional<std::string> faultIn(const MotionLibrary& library);

}  // namespace stridegraph
