#pragma once

#include <span>
#include <vector>

#include "base/result.h"
#include "motion/clip.h"

namespace stridegraph {

/// How a skeleton's left and right belong together, and how its joints' axes do.
struct MirrorMap {
  /// For each joint the one on the other side; itself for joints in the middle. An involution that keeps
  /// parents: the partner of a joint's parent is the parent of its partner.
  std::vector<JointIndex> partner;
  /// For each joint the turn of its own axes after which its bones point as the reflection of its partner's
  /// do: the identity where the rest pose is symmetric about x = 0, and for end sites.
  std::vector<Quat> correction;
};

/// Pairs the joints of a skeleton by their names (see mirroredNames) or, where these tell nothing, by the
/// symmetry of the rest pose about x = 0 or z = 0. Rest axes may be arbitrary: then the corrections turn each
/// joint so that its bones mirror (a single bone exactly, several as well as they can) and, where that leaves
/// a twist open, so that the mirrored mean pose of `clips` is twisted as the mean pose itself. Give all clips
/// of a library at once: one clip's mean may be one-sided. Fails with kInvalidArgument when no pair is found.
Result<MirrorMap> findMirrorMap(const Skeleton& skeleton, std::span<const Clip> clips);

}  // namespace stridegraph
