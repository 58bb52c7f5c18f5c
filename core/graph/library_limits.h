#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "base/error.h"
#include "graph/library.h"
#include "motion/bvh_reader.h"

namespace stridegraph {

/// Limits of what goes into one library. The builder refuses more before it takes memory for it, and the
/// reader of .sgraph files refuses files that hold more. docs/motion-files.md states the same figures, and a
/// test compares both.

inline constexpr std::size_t kMostLibraryClips = 10'000;  ///< Mirror images and pieces of cut clips count.
/// Frames at the library's rate, mirror images among them: more than two hours at 30 Hz. All pairs of frames
/// are compared, so that the time to build grows with the square.
inline constexpr std::size_t kMostLibraryFrames = 250'000;
/// Pairs of frames that are compared at most.
inline constexpr std::uint64_t kMostLibraryPairs =
    std::uint64_t{kMostLibraryFrames} * (kMostLibraryFrames + 1) / 2;
/// Frames times joints and end sites: a rotation is kept for each.
inline constexpr std::size_t kMostLibraryRotations = 20'000'000;
/// Pairs of pieces that are alike. The graph that is made of them and pruned takes some 300 bytes for each.
inline constexpr std::size_t kMostLibraryRegions = 5'000'000;
/// How many times more frames a clip may have at the library's rate than as captured: 2.5 frames a second in
/// a library of 30. What lies between frames that are farther apart is made up rather than captured.
inline constexpr double kMostFramesForOne = 12.0;
inline constexpr std::size_t kMostLibraryNotes = 500;
inline constexpr std::size_t kMostNoteBytes = 2'000;  ///< Of a note's message and of its file name, each.
inline constexpr std::size_t kMostLicenseBytes = 10'000;

/// How much a library already holds.
struct HeldAmount {
  std::size_t clips = 0;
  std::size_t frames = 0;
};

/// Says of clips that are to make up a library, or to be appended to one that holds `held`, which limit they
/// break, with the clip concerned as the place; nothing when they keep to all. Takes no memory: clips are not
/// brought to the library's rate. `params` are in range and clips have a rate above 0.
std::optional<Error> faultInAmount(std::span<const BvhDocument> clips, const LibraryParams& params,
                                   const HeldAmount& held = {});

/// The same of the regions that were found among them so far.
std::optional<std::string> faultInRegionCount(std::size_t regions);

}  // namespace stridegraph
