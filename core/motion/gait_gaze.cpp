#include "motion/gait_gaze.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/check.h"
#include "math/rotation.h"
#include "motion/gait_curves.h"
#include "motion/gait_skeleton.h"

namespace stridegraph {
namespace {

constexpr double kLeadSeconds = 0.34;    ///< How far ahead the head looks.
constexpr double kSmoothSeconds = 0.20;  ///< Half the width of the bell over which it looks.
constexpr double kLargestLead = 0.80;    ///< Most that the head turns ahead of the body, rad.
constexpr double kTrunkShare = 0.15;     ///< Of the lead that the trunk makes.
constexpr double kOwnYaw = 0.35;         ///< Of the head's own turning about the heading that stays,
constexpr double kOwnTilt = 0.45;        ///< and of its own nodding and rolling.
constexpr Angle kGazePitch = Angle::degrees(4.0);  ///< Eyes on the floor some metres ahead.

/// Headings a third of a second later less headings now, rad, smooth and bounded.
std::vector<double> leads(const GaitTrack& track, double fps) {
  const std::size_t last = track.moments.size() - 1;
  const auto ahead = static_cast<std::size_t>(std::lround(kLeadSeconds * fps));
  std::vector<double> result;
  for (std::size_t i = 0; i <= last; ++i)
    result.push_back((track.moments[std::min(i + ahead, last)].heading - track.moments[i].heading).radians());
  result = bellMean(result, static_cast<std::size_t>(std::lround(kSmoothSeconds * fps)));
  for (double& lead : result) lead = kLargestLead * std::tanh(lead / kLargestLead);
  return result;
}

}  // namespace

void leadWithTheHead(const GaitTrack& track, Clip& clip) {
  STRIDEGRAPH_CHECK(track.moments.size() == clip.frameCount());
  const std::vector<double> lead = leads(track, clip.framesPerSecond);
  const Quat level = axisRotation(Axis::kX, kGazePitch);
  for (std::size_t f = 0; f < clip.frameCount(); ++f) {
    const std::span<Quat> rotations = clip.rotationsOf(f);
    const Quat& pelvis = rotations[indexOf(GaitJoint::kPelvis)];
    Quat& thorax = rotations[indexOf(GaitJoint::kThorax)];
    Quat& head = rotations[indexOf(GaitJoint::kHead)];
    const Quat seen = pelvis * thorax * head;
    const Quat trunkTurn = axisRotation(Axis::kY, Angle::radians(kTrunkShare * lead[f]));
    thorax = (pelvis.conjugate() * trunkTurn * pelvis * thorax).normalized();
    const HeadingAndTilt own = separateHeading(seen);
    const Angle body = track.moments[f].heading;
    const double beside = (own.heading.angle() - body).wrapped().radians();
    const Angle look = body + Angle::radians(lead[f] + kOwnYaw * beside);
    const Quat wanted = Heading::fromAngle(look).rotation() * slerp(level, own.tilt, kOwnTilt);
    head = ((pelvis * thorax).conjugate() * wanted).normalized();
  }
}

}  // namespace stridegraph
