#include "gait_fit/side_laws.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "gait_fit/spline.h"
#include "math/rotation.h"
#include "motion/contacts.h"
#include "motion/kinematics.h"

namespace stridegraph::gait_fit {
namespace {

using Eigen::Index;

constexpr double kPi = std::numbers::pi;
/// The heel's print lies this far behind the ankle in the flat foot.
constexpr double kHeelBehindAnkleMetres = 0.045;
/// A foot stands while it is slower than this share of the gait's speed.
constexpr double kStandingShareOfSpeed = 0.45;

bool counts(const Track& track, Index f) {
  return track.going[f] > 0.0 && f >= kEndFrames && f + kEndFrames < track.frames();
}

/// Linear least squares, row by row, with a faint ridge for regressors that the clips do not vary.
template <int kSize>
class Regression {
 public:
  void add(const Eigen::Vector<double, kSize>& regressors, double value) {
    gram_ += regressors * regressors.transpose();
    moments_ += value * regressors;
  }
  std::array<double, kSize> solve() const {
    constexpr double kFaint = 1.0;
    const Eigen::Vector<double, kSize> found =
        (gram_ + kFaint * Eigen::Matrix<double, kSize, kSize>::Identity()).ldlt().solve(moments_);
    std::array<double, kSize> result;
    std::copy(found.begin(), found.end(), result.begin());
    return result;
  }

 private:
  Eigen::Matrix<double, kSize, kSize> gram_ = Eigen::Matrix<double, kSize, kSize>::Zero();
  Eigen::Vector<double, kSize> moments_ = Eigen::Vector<double, kSize>::Zero();
};

void measureRates(const GaitFit& fit, SideLaws& laws) {
  Regression<4> cadence;
  Regression<2> slip;
  for (const Track& track : fit.tracks) {
    const Eigen::VectorXd rate = smoothed(slopeOf(track.phase, track.clip.framesPerSecond), 5);
    for (Index f = 0; f < track.frames(); ++f) {
      if (!counts(track, f)) continue;
      const double u = track.speed[f] - fit.params.series.referenceSpeed;
      const double w = track.turnRate[f];
      cadence.add({1.0, u, u * u, w * w}, rate[f]);
      slip.add({w, track.turnAcceleration[f]}, track.slip[f]);
    }
  }
  laws.cadence = cadence.solve();
  laws.slip = slip.solve();
}

/// A stance of one foot in the phase of that foot.
struct Stance {
  double speed;
  double on;
  double off;
  double flatPitch;  ///< Of the foot where its ankle is slowest, toes down, rad.
};

/// One threshold for landing and lifting off, so that neither is seen late. A foot of a runner that lands
/// between two frames is still faster than a walker's.
ContactParams contactParams(double bodySpeed) {
  ContactParams params;
  params.beginHeightMetres = params.endHeightMetres = 0.04;
  params.beginSpeedMetresPerSecond = params.endSpeedMetresPerSecond = kStandingShareOfSpeed * bodySpeed;
  return params;
}

std::array<JointIndex, 3> footOf(Side side) {
  const JointIndex ankle = gaitLeg(side).ankle;
  return {ankle, JointIndex(std::size_t{ankle.value + 1}), JointIndex(std::size_t{ankle.value + 2})};
}

/// Frames in which heel or toes of one side stand.
std::vector<bool> downFrames(const Track& track, const FootJoints& feet, Side side, double referenceSpeed) {
  const auto masks = footContacts(gaitSkeleton(), track.clip, feet, contactParams(referenceSpeed));
  unsigned ofSide = 0;
  for (const JointIndex joint : footOf(side))
    for (std::size_t k = 0; k < feet.joints.size(); ++k)
      if (feet.joints[k] == joint) ofSide |= 1U << k;
  std::vector<bool> down;
  for (const std::uint8_t mask : masks) down.push_back((mask & ofSide) != 0);
  return down;
}

/// The pitch of a foot, toes down, at the frame of first..last-1 at which its ankle is slowest: it lies flat.
double pitchWhereStill(const Track& track, Side side, std::size_t first, std::size_t last) {
  const auto ankleAt = [&](std::size_t f) {
    return placeJoint(gaitSkeleton(), track.clip.pose(f), gaitLeg(side).ankle);
  };
  double slowest = std::numeric_limits<double>::infinity();
  double pitch = 0.0;
  for (std::size_t f = first; f < last; ++f) {
    const double moved = (ankleAt(f + 1).position - ankleAt(f - 1).position).norm();
    if (moved >= slowest) continue;
    slowest = moved;
    pitch = std::asin(std::clamp(-(ankleAt(f).rotation * Vec3::UnitZ()).y(), -1.0, 1.0));
  }
  return pitch;
}

/// Whole stances of one foot within a track.
void collectStances(const Track& track, const std::vector<bool>& down, Side side,
                    std::vector<Stance>& found) {
  const double shift = side == Side::kLeft ? 0.0 : kPi;
  const auto phaseBetween = [&](std::size_t f) {
    return 0.5 * (track.phase[static_cast<Index>(f)] + track.phase[static_cast<Index>(f) - 1]) + shift;
  };
  std::size_t first = 0;
  for (std::size_t f = 1; f < down.size(); ++f) {
    if (down[f] && !down[f - 1]) first = f;
    if (down[f] || !down[f - 1] || first == 0) continue;
    const auto middle = static_cast<Index>((first + f) / 2);
    if (counts(track, static_cast<Index>(first)) && counts(track, static_cast<Index>(f))) {
      const double on = phaseBetween(first);
      const double wraps = 2.0 * kPi * std::round((0.5 * (on + phaseBetween(f)) - 0.5 * kPi) / (2.0 * kPi));
      found.push_back(
          {track.speed[middle], on - wraps, phaseBetween(f) - wraps, pitchWhereStill(track, side, first, f)});
    }
    first = 0;
  }
}

double medianOf(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Medians of the slowest, middle and fastest third of the stances.
std::array<ContactKnot, 3> contactKnots(std::vector<Stance> stances) {
  std::stable_sort(stances.begin(), stances.end(),
                   [](const Stance& a, const Stance& b) { return a.speed < b.speed; });
  std::array<ContactKnot, 3> knots;
  for (std::size_t k = 0; k < knots.size(); ++k) {
    const std::size_t first = std::min(stances.size() - 1, k * stances.size() / knots.size());
    const std::size_t next = std::max(first + 1, (k + 1) * stances.size() / knots.size());
    std::vector<double> speed, on, off;
    for (std::size_t s = first; s < next; ++s) {
      speed.push_back(stances[s].speed);
      on.push_back(stances[s].on);
      off.push_back(stances[s].off);
    }
    knots[k] = {medianOf(speed), medianOf(on), medianOf(off)};
  }
  return knots;
}

}  // namespace

Result<SideLaws> measureSideLaws(const GaitFit& fit) {
  std::vector<std::vector<double>> levels;
  for (const Track& track : fit.tracks) levels.push_back(jointLevelsMetres(gaitSkeleton(), track.clip));
  const FootJoints feet = findFootJoints(gaitSkeleton(), levels);
  std::vector<Stance> stances;
  for (const Track& track : fit.tracks)
    for (const Side side : {Side::kLeft, Side::kRight})
      collectStances(track, downFrames(track, feet, side, fit.params.series.referenceSpeed), side, stances);
  if (stances.empty())
    return fail(ErrorCode::kClipTooShort,
                "found no whole stance of a foot, expected clips that show a foot land and lift off again");
  SideLaws laws;
  measureRates(fit, laws);
  std::vector<double> pitches;
  for (const Stance& stance : stances) pitches.push_back(stance.flatPitch);
  laws.flatFootPitch = Angle::radians(medianOf(std::move(pitches)));
  laws.contacts = contactKnots(std::move(stances));
  return laws;
}

std::array<double, 3> heelInFoot(Angle flatFootPitch) {
  const Skeleton skeleton = gaitSkeleton();
  const Pose pose = gaitPose(Gait::kWalk, {});
  const Quat toes = pose.rotations[indexOf(GaitJoint::kLeftToes)];
  const Vec3 toeEnd = skeleton.joints[indexOf(GaitJoint::kLeftToes)].offset +
                      toes * skeleton.joints[indexOf(GaitJoint::kLeftToesEnd)].offset;
  const Quat flat = axisRotation(Axis::kX, flatFootPitch);
  const Vec3 heel = flat.conjugate() * Vec3(0.0, (flat * toeEnd).y(), -kHeelBehindAnkleMetres);
  return {0.0, heel.y(), heel.z()};
}

}  // namespace stridegraph::gait_fit
