#pragma once

#include <optional>
#include <vector>

#include "base/result.h"
#include "graph/library.h"
#include "graph/transition_scan.h"
#include "motion/mirror_map.h"

namespace stridegraph {

/// Clips on their way into a library: at its rate, cut at glitches, on one floor, every number a 32 bit
/// float, and mirrored when asked. What becomes of a clip never depends on clips after it (its mirror image:
/// on the first kPosesForMirror frames of all), so that clips may be appended to a library and those in it
/// stay as they are.
class ClipIntake {
 public:
  /// Frames that findMirrorMap() looks at: some minutes of an actor, with turns to both sides among them.
  static constexpr std::size_t kPosesForMirror = 5000;

  ClipIntake(const Skeleton& skeleton, const LibraryParams& params);
  /// Begins with the clips of a library that has the same params.
  explicit ClipIntake(MotionLibrary base);

  /// Cuts a clip at its glitches and takes in the pieces. A piece whose floor lies more than a centimetre off
  /// that of the first clip is moved to it. Frames that a clip shows already are left out. Each of these
  /// changes is a warning in `warnings`.
  void add(const Clip& clip, Warnings& warnings);
  /// Once all clips are in; fails as findMirrorMap() does.
  Result<void> findMirror();
  /// Adds the mirror image of clip c.
  void addMirrorOf(std::size_t c);

  /// Writes the clips into a library: its frames and where each clip lies among them.
  void collect(MotionLibrary& library) const;

  const std::vector<Clip>& clips() const { return clips_; }
  bool isMirrored(std::size_t c) const { return c >= originals_; }
  /// Clips that are no mirror images.
  std::size_t originals() const { return originals_; }
  /// Which clips are as they were in the base library, and what was found among them there. Empties what is
  /// kept of it.
  KnownRegions takeKnown();

 private:
  void addRounded(Clip clip);
  void addOriginal(Clip clip, Warnings& warnings);
  void level(Clip& clip, Warnings& warnings);
  bool isNameTaken(const std::string& name) const;
  const Clip* sameFramesAs(const Clip& clip) const;
  double floorOf(const Clip& clip) const;
  bool isAsInBase(const Clip& clip, std::size_t baseClip) const;

  Skeleton skeleton_;
  LibraryParams params_;
  std::vector<JointIndex> joints_;  ///< All of the skeleton.
  std::optional<MotionLibrary> base_;
  std::size_t baseOriginals_ = 0;
  std::optional<double> floorMetres_;  ///< Of the first clip.
  std::optional<MirrorMap> mirrorMap_;
  std::vector<Clip> clips_;
  std::size_t originals_ = 0;
  /// For each clip, the one of the base library that it is.
  std::vector<std::optional<std::size_t>> inBase_;
};

}  // namespace stridegraph
