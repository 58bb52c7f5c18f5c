#pragma once

#include <string>

#include "base/result.h"
#include "graph/library.h"

namespace stridegraph::tools {

/// Reads a library (.sgraph); kFile, or what readSgraph refuses, with the path as the error's file.
Result<MotionLibrary> readLibraryFile(const std::string& path);

}  // namespace stridegraph::tools
