#include "motion/gait_balance.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/check.h"
#include "math/rotation.h"
#include "motion/gait_curves.h"
#include "motion/gait_footprint.h"

namespace stridegraph {
namespace {

constexpr double kShift = 0.050;        ///< Root towards the foot that carries, metres.
constexpr double kShiftSeconds = 0.45;  ///< Reach of its smoothing, so that it begins before the step.
constexpr double kShiftList = 0.030;    ///< Pelvis, rad; the trunk stays upright.

/// +1 where the left foot alone carries, -1 where the right does, smoothed.
std::vector<double> carriedSide(const GaitTrack& track, double fps) {
  std::vector<double> carried(track.moments.size(), 0.0);
  for (const Side side : {Side::kLeft, Side::kRight})
    for (const Stance& stance : stancesOf(track, side))
      for (std::size_t f = stance.first; f <= stance.last; ++f) {
        const double slow = 1.0 - walkingShare(track.moments[f]);
        carried[f] += side == Side::kLeft ? slow : -slow;
      }
  return bellMean(carried, static_cast<std::size_t>(std::lround(kShiftSeconds * fps)));
}

}  // namespace

void shiftWeight(const GaitTrack& track, Clip& clip) {
  STRIDEGRAPH_CHECK(track.moments.size() == clip.frameCount());
  const std::vector<double> carried = carriedSide(track, clip.framesPerSecond);
  for (std::size_t f = 0; f < clip.frameCount(); ++f) {
    const double shift = std::clamp(2.0 * carried[f], -1.0, 1.0) * (1.0 - walkingShare(track.moments[f]));
    const Heading heading = Heading::fromAngle(track.moments[f].heading);
    const Vec2 moved = heading.rotate({kShift * shift, 0.0});
    clip.rootPositions[f] += Vec3(moved.x(), 0.0, moved.y());
    Quat& pelvis = clip.rotationsOf(f)[indexOf(GaitJoint::kPelvis)];
    const Vec3 forward(heading.sin, 0.0, heading.cos);
    const Quat list(Eigen::AngleAxisd(kShiftList * shift, forward));
    Quat& thorax = clip.rotationsOf(f)[indexOf(GaitJoint::kThorax)];
    const Quat trunk = pelvis * thorax;
    pelvis = (list * pelvis).normalized();
    thorax = (pelvis.conjugate() * trunk).normalized();
  }
}

}  // namespace stridegraph
