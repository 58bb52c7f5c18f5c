#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/result.h"
#include "motion/bvh_reader.h"

namespace stridegraph::tools {

/// Each file once, in the order of the first time; for further times of a file, by whatever path, a note.
std::vector<std::string> withoutRepeats(const std::vector<std::string>& paths, Warnings& notes);

/// Reads clips, named after their files without folder and ending. Stops at the first error; `progress` is
/// told the share that is read.
Result<std::vector<BvhDocument>> readClipFiles(const std::vector<std::string>& paths,
                                               const BvhReadParams& params,
                                               const std::function<void(double)>& progress);

}  // namespace stridegraph::tools
