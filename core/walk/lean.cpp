#include "walk/lean.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "walk/correction_blend.h"

namespace stridegraph {
namespace {

constexpr double kGravity = 9.81;        // m/s2
constexpr double kBalanceSeconds = 0.6;  ///< To either side, over which accelerations are balanced: a step.
/// How much of the way out feet go: leaning comes and goes over planted feet, which would slide (measured:
/// with all of it by half as much again as without leaning, with half of it by as much as without).
constexpr double kFeetShare = 0.5;

/// Smooth means of one coordinate.
std::vector<double> smoothed(std::span<const Vec2> accelerations, Eigen::Index coordinate,
                             double framesPerSecond) {
  const auto reach = static_cast<std::size_t>(std::max(1.0, std::round(kBalanceSeconds * framesPerSecond)));
  std::vector<double> values;
  values.reserve(accelerations.size());
  for (const Vec2& acceleration : accelerations) values.push_back(acceleration[coordinate]);
  return smoothMean(values, std::vector<double>(values.size(), 1.0), reach);
}

Lean leanTowards(const Vec2& acceleration, const Vec3& root) {
  if (acceleration == Vec2::Zero()) return {};
  const Vec3 up = Vec3(acceleration.x(), kGravity, acceleration.y()).normalized();
  Lean lean;
  lean.turn = Quat::FromTwoVectors(Vec3::UnitY(), up);
  lean.feetMove = -kFeetShare * root.y() * Vec3(up.x(), 0.0, up.z());
  lean.rootSinks = kFeetShare * kFeetShare * root.y() * (1.0 - up.y());
  return lean;
}

}  // namespace

std::vector<Lean> balancingLeans(std::span<const Vec2> accelerations, std::span<const Vec3> roots,
                                 double framesPerSecond) {
  STRIDEGRAPH_CHECK(accelerations.size() == roots.size());
  const std::vector<double> x = smoothed(accelerations, 0, framesPerSecond);
  const std::vector<double> z = smoothed(accelerations, 1, framesPerSecond);
  std::vector<Lean> leans;
  leans.reserve(roots.size());
  for (std::size_t f = 0; f < roots.size(); ++f) leans.push_back(leanTowards({x[f], z[f]}, roots[f]));
  return leans;
}

void leanOver(std::span<const Lean> leans, std::span<const Vec3> roots, FootTrack& track) {
  STRIDEGRAPH_CHECK(leans.size() == track.frameCount() && roots.size() == track.frameCount());
  for (std::size_t f = 0; f < leans.size(); ++f) {
    const Lean& lean = leans[f];
    if (lean.isUpright()) continue;
    track.hips[f] = roots[f] + lean.turn * (track.hips[f] - roots[f]);
    track.hipRotations[f] = lean.turn * track.hipRotations[f];
    track.ankles[f].position += lean.feetMove;
    for (std::vector<Vec3>& points : track.points) points[f] += lean.feetMove;
  }
}

}  // namespace stridegraph
