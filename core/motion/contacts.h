#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "motion/clip.h"

namespace stridegraph {

/// When a foot joint counts as standing. A contact begins when the joint is both low and slow, and lasts
/// until it is high or fast (hysteresis: Schmitt 1938). The levels lie between what the feet of captured
/// walks do while planted (within 2 cm of their level, below 0.2 m/s) and in swing (2 to 4 m/s).
struct ContactParams {
  double footReachMetres = 0.12;           ///< Joints that come this near the lowest one are feet, > 0.
  double beginHeightMetres = 0.03;         ///< Above the joint's own level, > 0.
  double endHeightMetres = 0.05;           ///< >= beginHeightMetres.
  double beginSpeedMetresPerSecond = 0.4;  ///< In space, > 0.
  double endSpeedMetresPerSecond = 0.8;    ///< >= beginSpeedMetresPerSecond.
};

/// Ankles, toes and their end sites, and how high each lies when it is planted.
struct FootJoints {
  std::vector<JointIndex> joints;    ///< Ascending; at most kMaxFootJoints.
  std::vector<double> levelsMetres;  ///< World height of each when planted.
};
inline constexpr std::size_t kMaxFootJoints = 8;

/// Finds the joints that come near the floor in these clips of one skeleton: those whose level lies within
/// footReachMetres of the lowest. Where there are more than kMaxFootJoints, the lowest of every foot in turn.
/// A joint's level is the height below which it is in 2 % of the frames, so that single frames count little;
/// which joints are feet is judged clip by clip, so that clips with different floors may be asked.
FootJoints findFootJoints(const Skeleton& skeleton, std::span<const Clip> clips,
                          const ContactParams& params = {});

/// Which of the foot joints stand, frame by frame: bit k for feet.joints[k].
std::vector<std::uint8_t> footContacts(const Skeleton& skeleton, const Clip& clip, const FootJoints& feet,
                                       const ContactParams& params = {});

/// The height that the lowest foot joint keeps to in a clip: its floor, at the feet's joints. Metres.
double floorLevelMetres(const Skeleton& skeleton, const Clip& clip, std::span<const JointIndex> feet);

}  // namespace stridegraph
