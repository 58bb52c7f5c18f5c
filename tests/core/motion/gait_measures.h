#pragma once

#include <algorithm>
#include <cmath>

#include "math/rotation.h"
#include "motion/gait_model.h"

namespace stridegraph::testing {

/// Heel and toe end of one foot at a frame.
struct Sole {
  Vec3 heel;
  Vec3 toe;
};
inline Sole soleAt(const Clip& clip, std::size_t frame, Side side) {
  const Skeleton skeleton = gaitSkeleton();
  const JointIndex ankle = gaitLeg(side).ankle;
  const JointPlacement foot = placeJoint(skeleton, clip.pose(frame), ankle);
  const JointPlacement toe = placeJoint(skeleton, clip.pose(frame), JointIndex(std::size_t{ankle.value + 2}));
  return {foot.position + foot.rotation * gaitHeel(Gait::kWalk), toe.position};
}

inline double lowestSole(const Clip& clip) {
  double lowest = 1.0;
  for (std::size_t f = 0; f < clip.frameCount(); ++f)
    for (const Side side : {Side::kLeft, Side::kRight}) {
      const Sole sole = soleAt(clip, f, side);
      lowest = std::min({lowest, sole.heel.y(), sole.toe.y()});
    }
  return lowest;
}

/// In how many frames nothing that touches the floor (within 3 mm) moves by less than 1 mm on it.
inline std::size_t framesWithoutFirmFoot(const Clip& clip) {
  std::size_t loose = 0;
  for (std::size_t f = 0; f + 1 < clip.frameCount(); ++f) {
    double slowest = 1.0;
    for (const Side side : {Side::kLeft, Side::kRight}) {
      const Sole now = soleAt(clip, f, side);
      const Sole next = soleAt(clip, f + 1, side);
      if (now.heel.y() < kGaitSoleMetres + 0.003)
        slowest = std::min(slowest, (onFloor(next.heel) - onFloor(now.heel)).norm());
      if (now.toe.y() < kGaitSoleMetres + 0.003)
        slowest = std::min(slowest, (onFloor(next.toe) - onFloor(now.toe)).norm());
    }
    if (slowest > 0.001) ++loose;
  }
  return loose;
}

inline double fastestJoint(const Clip& clip) {
  double fastest = 0.0;
  for (std::size_t f = 0; f + 1 < clip.frameCount(); ++f)
    for (std::size_t j = 1; j < clip.jointCount; ++j)
      fastest =
          std::max(fastest, angleBetween(clip.pose(f).rotations[j], clip.pose(f + 1).rotations[j]).radians());
  return fastest * clip.framesPerSecond;
}

}  // namespace stridegraph::testing
