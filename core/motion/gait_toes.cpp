#include "motion/gait_toes.h"

#include <algorithm>
#include <cmath>

#include "math/rotation.h"
#include "motion/gait_curves.h"

namespace stridegraph {
namespace {

constexpr double kEaseIn = 0.10;       ///< rad; below it the bend begins smoothly.
constexpr double kLargestBend = 0.72;  ///< rad
constexpr double kFlatWithin = 0.14;   ///< rad; a foot pitched by less is pressed flat.

}  // namespace

double toeBend(double pitch) {
  if (pitch <= 0.0) return 0.0;
  const double eased = pitch < kEaseIn ? pitch * pitch / (2.0 * kEaseIn) : pitch - 0.5 * kEaseIn;
  return kLargestBend * std::tanh(eased / kLargestBend);
}

double pitchBeyondFlat(const FootMotion& foot) {
  const Vec3 ahead = foot.rotation * Vec3::UnitZ();
  const Vec3 up = foot.rotation * Vec3::UnitY();
  const Vec3 sole = foot.ballInFoot + foot.toeFromBall - foot.heelInFoot;
  const double flat = std::atan2(sole.y(), sole.z());
  return Angle::radians(std::atan2(-ahead.y(), up.y()) - flat).wrapped().radians();
}

void settleSole(double seconds, double slapSeconds, FootMotion& foot) {
  const double pitch = pitchBeyondFlat(foot);
  const double kept = pitch > 0.0 ? smoothStep(pitch / kFlatWithin) : 1.0 - smoothStep(seconds / slapSeconds);
  foot.rotation = (foot.rotation * axisRotation(Axis::kX, Angle::radians(pitch * (kept - 1.0)))).normalized();
}

}  // namespace stridegraph
