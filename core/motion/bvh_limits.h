#pragma once

#include <cstddef>

namespace stridegraph {

/// Limits of what is read from a BVH file. docs/motion-files.md states the same figures, and a test compares
/// both. Each limit is checked before memory is taken for what it counts; together they keep a file within
/// about two gigabytes of memory, which is what WebAssembly has.

/// Bytes of a file: more than an hour of a whole body with fingers at 60 Hz.
inline constexpr std::size_t kMostBvhBytes = 500'000'000;
/// Joints and end sites of a skeleton.
inline constexpr std::size_t kMostBvhJoints = 10'000;
/// Joints from the root to an end site, both included.
inline constexpr std::size_t kMostBvhDepth = 1'000;
/// Channels of a joint: each of the six kinds once.
inline constexpr std::size_t kMostBvhChannels = 6;
/// Bytes of a name as UTF-8.
inline constexpr std::size_t kMostBvhNameBytes = 1'000;
/// Frames of a file: more than an hour at 240 Hz.
inline constexpr std::size_t kMostBvhFrames = 1'000'000;
/// Numbers in all rows together.
inline constexpr std::size_t kMostBvhNumbers = 60'000'000;
/// Frames times joints and end sites: a rotation is kept for each.
inline constexpr std::size_t kMostBvhRotations = 20'000'000;
/// Seconds from frame to frame; the shortest means 10,000 frames a second.
inline constexpr double kShortestBvhFrameSeconds = 0.0001;
inline constexpr double kLongestBvhFrameSeconds = 1.0;
/// Size of a number without its sign, in file units or degrees.
inline constexpr double kLargestBvhNumber = 1e9;

}  // namespace stridegraph
