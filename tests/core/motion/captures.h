#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace stridegraph::testing {

/// What a test says that is skipped for want of captured clips.
inline constexpr std::string_view kNoCaptures = "STRIDEGRAPH_MOCAP names no folder with captured clips";

/// All BVH files below `folder` (all folders when empty) of the folder that the environment variable
/// STRIDEGRAPH_MOCAP names, sorted; empty when it is not set.
std::vector<std::filesystem::path> captures(std::string_view folder = {});

/// The bytes of a file.
std::string contentOf(const std::filesystem::path& file);

}  // namespace stridegraph::testing
