#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "graph/motion_graph.h"
#include "math/floor_transform.h"
#include "motion/bvh_layout.h"
#include "motion/clip.h"

namespace stridegraph {

/// How a library is built from clips.
struct LibraryParams {
  double thresholdMetres = 0.05;        ///< tau of section 5.3.2, > 0: largest distance along a transition.
  std::uint32_t transitionFrames = 13;  ///< l of section 5.3.2, 2..120 (thesis: 13).
  double framesPerSecond = 30.0;        ///< Rate of the whole library, 1..240.
  bool mirror = false;                  ///< Also every clip with left and right swapped.
  /// Of transitions that lie within this many frames of each other only the best is kept, 0..100.
  std::uint32_t neighbourFrames = 6;
  /// How many times longer one side of a transition may be than the other, 1 (never) to 2, so that a slow
  /// and a brisk step connect; see ValleyParams.
  double largestSpanRatio = 1.5;
  /// Kept at most, 1000 or more (thinnedGraph). What one actor walks in 3 minutes has some 8000 with mirror
  /// images; what a search may look through in a few milliseconds is the reason for the limit.
  std::uint32_t mostTransitions = 15'000;
};

/// Two pieces of a library's motion that are alike: frames row..row + rowSpan and column..column +
/// columnSpan, row < column. A transition leads from `row` to the end of the other piece, and one from
/// `column` to the end of the first.
struct AlikeRegion {
  FrameIndex row;
  FrameIndex column;
  std::uint16_t rowSpan = 0;
  std::uint16_t columnSpan = 0;
  float distanceMetres = 0.0F;  ///< Mean along it (eq. 5.2, in metres).

  auto operator<=>(const AlikeRegion&) const = default;
};

/// Which foot joints touch the floor, a bit for each entry of MotionLibrary::contactJoints.
using ContactMask = std::uint8_t;

/// Where a clip of a library lies among its frames.
struct LibraryClip {
  std::string name;
  std::uint32_t firstFrame = 0;
  std::uint32_t frameCount = 0;
  bool mirrored = false;
};

/// Everything that a walk is made of: captured frames of one skeleton and the graph that connects them.
/// Immutable once built or loaded.
struct MotionLibrary {
  Skeleton skeleton;
  BvhLayout layout;  ///< How its walks are written as BVH.
  Clip frames;       ///< All clips one after the other; every number is exactly a 32 bit float.
  std::vector<LibraryClip> clips;
  MotionGraph graph;  ///< Pruned: one strongly connected part.
  /// All that were found, also where pruning left nothing, in ascending order: clips that are appended need
  /// not compare these again.
  std::vector<AlikeRegion> regions;

  Heading facingOffset;  ///< Root heading less direction of travel; facing = root heading - facingOffset.
  std::vector<JointIndex> contactJoints;  ///< Ankles and toes; at most 8.
  std::vector<ContactMask> contacts;      ///< One for each frame.
  double floorHeightMetres = 0.0;         ///< Lowest level that the feet keep to.

  LibraryParams params;
  std::string license;  ///< A line on where the clips come from and on what terms; may be empty.
  /// What was odd about its clips and what the graph lacks, kept so that it can be read wherever the library
  /// is. At most kMostLibraryNotes (library_limits.h).
  Warnings notes;
  /// Of its .sgraph bytes without the notes; the same library has the same hash everywhere.
  std::uint64_t hash = 0;

  /// Where the body stands and looks at a frame: floor point of the root, and facing (heading -
  /// facingOffset).
  FloorTransform placementAt(FrameIndex frame) const;
  /// The clip that a frame belongs to.
  const LibraryClip& clipOf(FrameIndex frame) const;
};

}  // namespace stridegraph
