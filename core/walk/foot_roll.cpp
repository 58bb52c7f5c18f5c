#include "walk/foot_roll.h"

#include <algorithm>
#include <cmath>

namespace stridegraph {
namespace {

constexpr double kLargestPitch = 0.17;  // rad
constexpr double kSettledPitch = 1e-9;  // rad
/// Change of leg length with pitch below which pitching is given up, smoothly.
constexpr double kLeastLever = 0.02;  // metres per radian
/// Shares of its length at which a leg is bent enough for its knee not to mind, and at which it is not.
constexpr double kBentLeg = 0.95;
constexpr double kStraightLeg = 0.98;
/// The heel has left the floor for good when it holds as little as this.
constexpr double kHeelHold = 0.25;

/// Rises from 0 to 1 between `low` and `high`, with continuous speed.
double ramp(double value, double low, double high) {
  const double share = std::clamp((value - low) / (high - low), 0.0, 1.0);
  return share * share * (3.0 - 2.0 * share);
}

/// The pitch about `axis` through the pivot that brings the ankle, `arm` away from it, to `wantedMetres` from
/// the hip, `toHip` away from it: damped Newton steps, so that it changes smoothly where the pivot lies in
/// line.
double pitchFor(const Vec3& arm, const Vec3& toHip, const Vec3& axis, double wantedMetres) {
  double pitch = 0.0;
  for (int step = 0; step < 8; ++step) {
    const Vec3 turned = Eigen::AngleAxisd(pitch, axis) * arm;
    const Vec3 leg = turned - toHip;
    const double lever = leg.dot(axis.cross(turned)) / leg.norm();
    const double before = pitch;
    pitch -= (leg.norm() - wantedMetres) * lever / (lever * lever + kLeastLever * kLeastLever);
    pitch = std::clamp(pitch, -kLargestPitch, kLargestPitch);
    if (std::abs(pitch - before) < kSettledPitch) break;
  }
  return pitch;
}

}  // namespace

void rollOverToes(const FootTrack& track, const WalkFoot& foot, std::span<const double> hipRisesMetres,
                  PinnedStance& pinned) {
  for (std::size_t i = 0; i < pinned.corrections.size(); ++i) {
    const std::size_t f = pinned.stance.first + i;
    FootCorrection& correction = pinned.corrections[i];
    const Vec3& ankle = track.ankles[f].position;
    const double legInClip = (ankle - track.hips[f]).norm();
    const double share = ramp(legInClip / foot.legMetres, kBentLeg, kStraightLeg) *
                         ramp(kHeelHold - track.holds[0][f], 0.0, kHeelHold);
    if (share == 0.0) continue;
    const Quat yaw = yawTurn(correction[3]);
    Vec3 pivot = Vec3::Zero();
    double weights = 0.0;
    for (std::size_t k = 1; k < track.points.size(); ++k) {
      pivot += track.holds[k][f] * (yaw * (track.points[k][f] - ankle));
      weights += track.holds[k][f];
    }
    if (weights == 0.0) continue;
    pivot /= weights;  // From the ankle.
    const Vec3 place = ankle + correction.head<3>();
    const Vec3 hip = track.hips[f] + Vec3(0.0, hipRisesMetres[f], 0.0);
    const Vec3 side = yaw * track.ankles[f].rotation * foot.sideInAnkle;
    const double pitch = share * pitchFor(-pivot, hip - place - pivot, side, legInClip);
    correction.head<3>() += pivot - Eigen::AngleAxisd(pitch, side) * pivot;
    correction[4] = pitch;
  }
}

}  // namespace stridegraph
