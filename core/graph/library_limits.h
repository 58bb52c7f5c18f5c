#pragma once

#include <cstddef>

namespace stridegraph {

/// How much a library may hold. The builder refuses more before it takes memory for it, and the reader of
/// .sgraph files refuses files that hold more.

inline constexpr std::size_t kMostLibraryClips = 10'000;  ///< Mirror images and pieces of cut clips count.
/// At the library's rate, mirror images counted: nine hours at 30 frames a second.
inline constexpr std::size_t kMostLibraryFrames = 1'000'000;
/// Frames times joints, end sites counted: 1.6 GB of memory.
inline constexpr std::size_t kMostLibraryRotations = 50'000'000;
/// Pairs of pieces of motion that are alike; each offers two transitions. 400 MB of memory.
inline constexpr std::size_t kMostLibraryRegions = 20'000'000;
inline constexpr std::size_t kMostLibraryNotes = 500;
inline constexpr std::size_t kMostNoteBytes = 2'000;  ///< Of a note's message and of its file name, each.
inline constexpr std::size_t kMostLicenseBytes = 10'000;

}  // namespace stridegraph
