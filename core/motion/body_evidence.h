#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "motion/clip.h"

namespace stridegraph {

/// How far a body reaches along x, y and z, in whatever unit its skeleton has.
struct BodyExtents {
  Vec3 posed = Vec3::Zero();  ///< Median over frames spread over the clip.
  Vec3 rest = Vec3::Zero();   ///< With all rotations zero.
};
BodyExtents measureExtents(const Skeleton& skeleton, const Clip& clip);

/// A direction that could be up: +x, -x, +y, -y, +z, -z.
inline constexpr std::size_t kDirections = 6;
Vec3 directionVector(std::size_t direction);

/// What a clip tells of where up is and how large the body is, in the unit and axes of its skeleton. Fewer
/// than five frames are poses, not a motion: of what moves in them nothing is said.
struct BodyEvidence {
  BodyExtents extents;
  double size = 0.0;              ///< The longest extent, posed or at rest; 0 for a point.
  Vec3 rootRange = Vec3::Zero();  ///< How far the root comes along each axis.
  /// For each direction, how much the height of the lowest joint varies: its 5th to 95th percentile.
  std::array<double, kDirections> levelSpread = {};
  /// For each direction, the median speed of the lowest joint over the median speed of the root, of frames in
  /// which the root goes more than 0.15 sizes a second. Absent where it hardly does.
  std::optional<std::array<double, kDirections>> slip;
  /// From feet to head, by the names of joints; medians. Absent where no joint has such a name.
  std::optional<Vec3> feetToHead;
  std::optional<Vec3> feetToHeadAtRest;
  bool hasHead = false;  ///< A joint is called so.
  bool hasFeet = false;
};
BodyEvidence gatherEvidence(const Skeleton& skeleton, const Clip& clip);

}  // namespace stridegraph
