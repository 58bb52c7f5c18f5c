#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "math/floor_transform.h"
#include "motion/clip.h"

namespace stridegraph {

/// Frames on either side of a frame that are compared with it (eq. 5.2: d = -2..2).
inline constexpr std::size_t kWindowReach = 2;
inline constexpr std::size_t kWindowFrames = 2 * kWindowReach + 1;

/// How much each joint of the skeleton counts in a distance, 0 or 1. Hands and all below them weigh nothing
/// (fig. 5.2), nor do end sites and toe tips: they swing far and say little. A hand is a joint whose name
/// holds "hand", "wrist", "palm", "finger" or "thumb", a tip one whose name ends in "end", "tip", "nub" or
/// "site", in any letter case.
std::vector<double> distanceWeights(const Skeleton& skeleton);

/// The floor translation and turn that bring `moved` nearest to `fixed`: least weighted sum of squared
/// distances (closed form of Kovar, Gleicher and Pighin 2002, section 3.1, without angles). Equal sizes; some
/// weight > 0.
FloorTransform alignOnFloor(std::span<const Vec3> fixed, std::span<const Vec3> moved,
                            std::span<const double> weights);

/// Distance of two windows, in metres: the root of the weighted mean square distance of their points after
/// the best floor alignment. Equal sizes; some weight > 0.
double windowDistanceMetres(std::span<const Vec3> fixed, std::span<const Vec3> moved,
                            std::span<const double> weights);

/// Joint positions of the frames around one, frame by frame, and distanceWeights() as often. The window must
/// lie within the clip.
std::vector<Vec3> windowPositions(const Skeleton& skeleton, const Clip& clip, std::size_t frame);
std::vector<double> windowWeights(const Skeleton& skeleton);

/// Distance of two frames (eq. 5.2): that of the windows of kWindowFrames around them. Plain and slow: the
/// yardstick of similarity.h. Both windows must lie within their clips.
double poseDistanceMetres(const Skeleton& skeleton, const Clip& a, std::size_t frameOfA, const Clip& b,
                          std::size_t frameOfB);

}  // namespace stridegraph
