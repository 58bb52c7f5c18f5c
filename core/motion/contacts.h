#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "motion/clip.h"

namespace stridegraph {

/// When a foot joint counts as standing. A contact begins when the joint is both low and slow, and lasts
/// until it is high or fast (hysteresis: Schmitt 1938). Low is meant against the joint's lowest height within
/// a stride or so, since floors of captures may be warped by centimetres across the room. The thresholds lie
/// between what feet of captured walks do while planted (within 2 cm of that height, below 0.2 m/s) and in
/// swing (2 to 4 m/s).
struct ContactParams {
  double footReachMetres = 0.12;           ///< Joints that come this near the lowest one are feet, > 0.
  double strideSeconds = 0.7;              ///< Looked at before and after for the lowest height, > 0.
  double warpMetres = 0.06;                ///< At most this far above the joint's level is a floor, >= 0.
  double beginHeightMetres = 0.03;         ///< Above the floor there, > 0.
  double endHeightMetres = 0.05;           ///< >= beginHeightMetres.
  double beginSpeedMetresPerSecond = 0.4;  ///< In space, > 0.
  double endSpeedMetresPerSecond = 0.8;    ///< >= beginSpeedMetresPerSecond.
};

/// For each joint of the skeleton the height below which it is in 2 % of a clip's frames: where it lies when
/// it is down, whatever single frames do. Metres, world. The clip has frames.
std::vector<double> jointLevelsMetres(const Skeleton& skeleton, const Clip& clip);

/// Ankles, toes and their end sites, and how high each lies when it is planted.
struct FootJoints {
  std::vector<JointIndex> joints;    ///< Ascending; at most kMaxFootJoints.
  std::vector<double> levelsMetres;  ///< Of each, the median of its levels in the clips.
};
inline constexpr std::size_t kMaxFootJoints = 8;

/// Finds the joints that come near the floor from their levels in each clip: those that lie within
/// footReachMetres of the clip's lowest joint in some clip. Where there are more than kMaxFootJoints, the
/// lowest of every foot in turn. Clips may have different floors.
FootJoints findFootJoints(const Skeleton& skeleton, std::span<const std::vector<double>> clipLevels,
                          const ContactParams& params = {});

/// Which of the foot joints stand, frame by frame: bit k for feet.joints[k].
std::vector<std::uint8_t> footContacts(const Skeleton& skeleton, const Clip& clip, const FootJoints& feet,
                                       const ContactParams& params = {});

/// Where the feet of a clip mostly stand: the height below which the lowest of them is in a quarter of the
/// frames. Metres, world, at the joints.
double floorLevelMetres(const Skeleton& skeleton, const Clip& clip, std::span<const JointIndex> feet);

}  // namespace stridegraph
