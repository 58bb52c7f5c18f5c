#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "motion/clip.h"
#include "motion/round_body.h"

namespace stridegraph {

/// A walk for a file, and whose it is.
struct WalkerClip {
  const Clip* clip = nullptr;
  std::size_t walker = 0;  ///< Counted from 0: names and colours it.
};

/// Clips of several bodies that move at the same time, one or more, as binary glTF 2.0 that any viewer shows
/// walking: nodes for the joints, the body as skinned mesh in the walker's colour, and one animation, since
/// viewers play one at a time. Who is done first stays as it is.
///
/// Names are valid UTF-8 without control characters, and all names of nodes, of meshes, of skins and of
/// materials differ. Where there are several clips, each has its joints below a node of its own ("walker_1",
/// "walker_2", ...) and everything of it is named after that ("walker_2_hips"). Key times begin at 0 and
/// grow; neighbouring keys of a rotation are never more than half a turn apart as quaternions (dot product
/// >= 0). Numbers that no file can hold become 0. A clip without frames is written standing, without tracks.
std::vector<std::uint8_t> writeGlb(const Skeleton& skeleton, const RoundBody& body,
                                   std::span<const WalkerClip> clips);

/// One clip.
std::vector<std::uint8_t> writeGlb(const Skeleton& skeleton, const RoundBody& body, const Clip& clip);

}  // namespace stridegraph
