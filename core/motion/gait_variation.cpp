#include "motion/gait_variation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/check.h"
#include "math/rotation.h"
#include "motion/gait_footprint.h"
#include "motion/gait_step_noise.h"

namespace stridegraph {
namespace {

constexpr double kPi = std::numbers::pi;

// From step to step, one standard deviation.
constexpr double kArmSwing = 0.07;                                            ///< Share of the swing.
constexpr double kTrunkPitch = 0.008, kTrunkYaw = 0.010, kTrunkRoll = 0.006;  ///< rad
constexpr double kSway = 0.003;                                               ///< metres, across the way

/// The jolt of a heel strike: an oscillation that dies away. Sizes below are those of its envelope at 1.3
/// m/s.
constexpr double kJoltHertz = 7.0;
constexpr double kJoltSeconds = 0.07;
constexpr double kJoltDrop = 0.0036, kJoltBrake = 0.0044, kJoltSideways = 0.0040;  ///< metres
constexpr double kRootTremor = 0.0007;  ///< metres along each axis, root mean square

/// What the jolt and the fine unrest do to a joint, rad. As in captures, most of the unrest of a limb is
/// about its own bone (y), so that it moves hands and feet little.
struct Unrest {
  GaitJoint joint;               ///< Central or left.
  double jolt;                   ///< About the sideways axis.
  std::array<double, 3> tremor;  ///< Root mean square about each axis of the joint.
  bool inSwing = false;          ///< Only while the foot of that side is in the air.
};
constexpr std::array<Unrest, 8> kUnrest = {{{GaitJoint::kThorax, 0.018, {0.0020, 0.0030, 0.0020}},
                                            {GaitJoint::kHead, -0.008, {0.0020, 0.0030, 0.0015}},
                                            {GaitJoint::kLeftHumerus, 0.012, {0.0015, 0.0060, 0.0015}},
                                            {GaitJoint::kLeftRadius, 0.010, {0.0020, 0.0, 0.0}},
                                            {GaitJoint::kLeftHand, 0.016, {0.0010, 0.0130, 0.0}},
                                            {GaitJoint::kLeftFemur, 0.0, {0.0045, 0.0270, 0.0025}, true},
                                            {GaitJoint::kLeftTibia, 0.0, {0.0080, 0.0020, 0.0}, true},
                                            {GaitJoint::kLeftFoot, 0.0, {0.0290, 0.0380, 0.0280}, true}}};

/// A sum of oscillations in the band of physiological tremor, with root mean square 1, whose accelerations
/// weigh the same.
class Tremor {
 public:
  explicit Tremor(Random& random) {
    double power = 0.0;
    for (Wave& wave : waves_) {
      wave.radPerSecond = 2.0 * kPi * random.uniform(5.5, 10.0);
      wave.phase = random.uniform(0.0, 2.0 * kPi);
      wave.size = 1.0 / (wave.radPerSecond * wave.radPerSecond);
      power += 0.5 * wave.size * wave.size;
    }
    for (Wave& wave : waves_) wave.size /= std::sqrt(power);
  }
  double at(double seconds) const {
    double sum = 0.0;
    for (const Wave& wave : waves_) sum += wave.size * std::sin(wave.radPerSecond * seconds + wave.phase);
    return sum;
  }

 private:
  struct Wave {
    double radPerSecond = 0.0;
    double phase = 0.0;
    double size = 0.0;
  };
  std::array<Wave, 5> waves_;
};

Quat smallTurn(const Vec3& vector) {
  return Quat(1.0, 0.5 * vector.x(), 0.5 * vector.y(), 0.5 * vector.z()).normalized();
}

/// How fresh the last heel strike of a side is, frame by frame: the oscillation since then, times the pace.
std::vector<double> joltsOf(const GaitTrack& track, Side side, double fps) {
  std::vector<double> jolts(track.moments.size(), 0.0);
  for (const Stance& stance : stancesOf(track, side)) {
    if (stance.first == 0) continue;
    const double pace = std::min(track.moments[stance.first].speed / 1.3, 1.8);
    for (std::size_t f = stance.first; f < jolts.size(); ++f) {
      const double t = (static_cast<double>(f - stance.first) + 0.5) / fps;
      if (t > 6.0 * kJoltSeconds) break;
      jolts[f] += pace * std::exp(-t / kJoltSeconds) * std::sin(2.0 * kPi * kJoltHertz * t);
    }
  }
  return jolts;
}

/// 0 where the foot of a side is down, rising to 1 in the middle of each swing.
std::vector<double> aloft(const GaitTrack& track, Side side) {
  std::vector<double> result(track.moments.size(), 0.0);
  std::size_t off = 0;
  for (const Stance& stance : stancesOf(track, side)) {
    const double span = static_cast<double>(stance.first - off) + 1.0;
    for (std::size_t f = off; f < stance.first; ++f)
      result[f] = std::sin(kPi * (static_cast<double>(f - off) + 1.0) / span);
    off = stance.last + 1;
  }
  return result;
}

/// +1 where the left side is first to be foremost after the clip begins, else -1: tells a request from its
/// mirror image, so that what is drawn for the one side goes to the other.
double leadingSide(const GaitTrack& track) {
  const double turn = (track.moments[track.margin].phase + 0.1) / (2.0 * kPi);
  return turn - std::floor(turn) < 0.5 ? 1.0 : -1.0;
}

/// All that is random about one clip, drawn once.
struct Drawn {
  StepNoise trunkPitch, trunkYaw, trunkRoll, sway;
  std::array<StepNoise, 2> armSwing;
  std::array<Tremor, 3> rootTremor;
  std::vector<std::array<Tremor, 6>> tremors;  ///< For each of kUnrest: leading side x y z, other side x y z.

  Drawn(Random& random, std::size_t steps)
      : trunkPitch(random, steps),
        trunkYaw(random, steps),
        trunkRoll(random, steps),
        sway(random, steps),
        armSwing{StepNoise(random, steps), StepNoise(random, steps)},
        rootTremor{Tremor(random), Tremor(random), Tremor(random)} {
    for (std::size_t u = 0; u < kUnrest.size(); ++u)
      tremors.push_back(
          {Tremor(random), Tremor(random), Tremor(random), Tremor(random), Tremor(random), Tremor(random)});
  }
};

/// Sizes of what happens at one frame.
struct Instant {
  double seconds;
  double steps;
  double jolt;                  ///< Of both feet.
  double sideJolt;              ///< Left less right.
  std::array<double, 2> aloft;  ///< For each side 0 in stance .. 1 in the middle of a swing.
  double going;                 ///< 0 standing .. 1
  double pace;                  ///< Unrest by that of a brisk walk.
  double side;                  ///< leadingSide()
  double share;                 ///< GaitRequest::variation
};

void turnBy(Clip& clip, std::size_t frame, GaitJoint joint, const Vec3& vector) {
  Quat& rotation = clip.rotationsOf(frame)[indexOf(joint)];
  rotation = (rotation * smallTurn(vector)).normalized();
}

void moveTrunk(const Drawn& drawn, const Instant& now, const Heading& heading, std::size_t frame,
               Clip& clip) {
  const double share = now.share * now.going;
  turnBy(clip, frame, GaitJoint::kThorax,
         share * Vec3(kTrunkPitch * drawn.trunkPitch.at(now.steps),
                      now.side * kTrunkYaw * drawn.trunkYaw.at(now.steps),
                      now.side * kTrunkRoll * drawn.trunkRoll.at(now.steps)));
  const Vec2 across = heading.rotate({1.0, 0.0});
  const Vec2 ahead = heading.rotate({0.0, 1.0});
  const double sideways =
      share * (now.side * kSway * drawn.sway.at(now.steps) + kJoltSideways * now.sideJolt);
  const auto tremor = [&](std::size_t axis) {
    return share * kRootTremor * drawn.rootTremor[axis].at(now.seconds);
  };
  const Vec2 moved =
      (sideways + now.side * tremor(0)) * across + (tremor(2) - share * kJoltBrake * now.jolt) * ahead;
  clip.rootPositions[frame] += Vec3(moved.x(), tremor(1) - share * kJoltDrop * now.jolt, moved.y());
}

void shake(const Drawn& drawn, const Instant& now, std::size_t frame, Clip& clip) {
  for (std::size_t u = 0; u < kUnrest.size(); ++u) {
    const Unrest& unrest = kUnrest[u];
    const GaitJoint twin = otherSide(unrest.joint);
    const double unrestShare = now.share * std::lerp(0.3, now.pace, now.going);
    const double jolt = unrest.jolt * now.share * now.going * now.jolt;
    for (const GaitJoint joint : {unrest.joint, twin}) {
      const bool central = twin == unrest.joint;
      const bool left = joint == unrest.joint;
      // Of a central joint the sideways parts change sign with the side, of a limb they follow its own side.
      const double sign = central ? now.side : (left ? 1.0 : -1.0);
      const std::size_t first = central || (left == (now.side > 0.0)) ? 0 : 3;
      const double size = unrest.inSwing ? unrestShare * now.aloft[left ? 0 : 1] : unrestShare;
      const auto tremor = [&](std::size_t axis) {
        return size * unrest.tremor[axis] * drawn.tremors[u][first + axis].at(now.seconds);
      };
      turnBy(clip, frame, joint, Vec3(jolt + tremor(0), sign * tremor(1), sign * tremor(2)));
      if (central) break;
    }
  }
}

/// Where the upper arms are in the middle of their swing, left and right.
std::array<Quat, 2> meanUpperArms(const GaitMoment& moment) {
  const auto mean = [](Gait gait) {
    const auto& wxyz = gaitTable(gait).means[static_cast<std::size_t>(StoredJoint::kHumerus)];
    return Quat(wxyz[0], wxyz[1], wxyz[2], wxyz[3]).normalized();
  };
  const Quat left = slerp(mean(Gait::kWalk), mean(Gait::kJog), moment.jogShare);
  return {left, Quat(left.w(), left.x(), -left.y(), -left.z())};
}

/// Swings each upper arm a little more or less about where it is on the mean of the clip's cycle.
void varyArms(const Drawn& drawn, const Instant& now, const std::array<Quat, 2>& meanArms, std::size_t frame,
              Clip& clip) {
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const bool left = side == Side::kLeft;
    const GaitJoint joint = left ? GaitJoint::kLeftHumerus : GaitJoint::kRightHumerus;
    const StepNoise& noise = drawn.armSwing[left == (now.side > 0.0) ? 0 : 1];
    const double gain = 1.0 + kArmSwing * now.share * now.going * noise.at(now.steps);
    Quat& rotation = clip.rotationsOf(frame)[indexOf(joint)];
    const Quat& mean = meanArms[left ? 0 : 1];
    const Eigen::AngleAxisd swing(mean.conjugate() * rotation);
    rotation = (mean * Quat(Eigen::AngleAxisd(gain * swing.angle(), swing.axis()))).normalized();
  }
}

}  // namespace

void enliven(const GaitRequest& request, const GaitTrack& track, Clip& clip) {
  STRIDEGRAPH_CHECK(track.moments.size() == clip.frameCount());
  if (request.variation <= 0.0) return;
  const double fps = clip.framesPerSecond;
  Random random(request.seed);
  const Drawn drawn(random, static_cast<std::size_t>(track.moments.back().steps) + 1);
  const std::vector<double> left = joltsOf(track, Side::kLeft, fps);
  const std::vector<double> right = joltsOf(track, Side::kRight, fps);
  const std::array<std::vector<double>, 2> swing = {aloft(track, Side::kLeft), aloft(track, Side::kRight)};
  const double side = leadingSide(track);
  for (std::size_t f = 0; f < clip.frameCount(); ++f) {
    const GaitMoment& moment = track.moments[f];
    const double seconds = (static_cast<double>(f) - static_cast<double>(track.margin)) / fps;
    const Instant now{seconds,
                      moment.steps,
                      left[f] + right[f],
                      left[f] - right[f],
                      {swing[0][f], swing[1][f]},
                      std::max(walkingShare(moment), 0.5 * steppingShare(moment)),
                      std::clamp(moment.speed / 1.2, 1.05, 1.45),
                      side,
                      request.variation};
    moveTrunk(drawn, now, Heading::fromAngle(moment.heading), f, clip);
    varyArms(drawn, now, meanUpperArms(moment), f, clip);
    shake(drawn, now, f, clip);
  }
}

}  // namespace stridegraph
