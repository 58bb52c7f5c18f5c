#include "motion/gait_feet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/check.h"
#include "math/rotation.h"
#include "motion/gait_curves.h"
#include "motion/gait_footprint.h"
#include "motion/gait_toes.h"

namespace stridegraph {
namespace {

constexpr double kLongestLeg = 0.999;     ///< In swing, and where all else fails.
constexpr double kLongestJogLeg = 0.992;  ///< A jog lands on a bent knee.
constexpr double kWalkLowering = 0.020;   ///< Most that the root is lowered for a leg in stance, metres.
constexpr double kJogLowering = 0.004;
constexpr double kLargestRelease = 0.35;  ///< Share of a stance that may be given up at its end.
/// Heel and toe end over the floor in the middle of a swing, metres.
constexpr double kWalkClearance = 0.018;
constexpr double kJogClearance = 0.040;
constexpr double kWalkSlapSeconds = 0.10;  ///< From heel strike to flat foot.
constexpr double kJogSlapSeconds = 0.08;
constexpr std::size_t kLiftEaseFrames = 4;  ///< Over which a lifted swing begins and ends.
constexpr double kToeFadeSeconds = 0.17;  ///< In which the toes straighten after the foot has left the floor.

/// One foot through the whole clip.
struct Foot {
  Leg leg;
  std::vector<FootMotion> motion;
  std::vector<Vec3> hips;  ///< Where the hip joint is, world.
  std::vector<bool> down;
  std::vector<FootCorrection> corrections;
};

Foot footOf(const Skeleton& skeleton, const GaitTrack& track, const Clip& clip, Side side) {
  Foot foot;
  foot.leg = gaitLeg(side);
  const std::size_t toes = foot.leg.ankle.value + 1;
  const Vec3 walkHeel = gaitHeel(Gait::kWalk);
  const Vec3 jogHeel = gaitHeel(Gait::kJog);
  for (std::size_t f = 0; f < clip.frameCount(); ++f) {
    const PoseView pose = clip.pose(f);
    const JointPlacement ankle = placeJoint(skeleton, pose, foot.leg.ankle);
    const double jog = track.moments[f].jogShare;
    foot.motion.push_back({ankle.position, ankle.rotation, walkHeel + jog * (jogHeel - walkHeel),
                           skeleton.joints[toes].offset,
                           pose.rotations[toes] * skeleton.joints[toes + 1].offset});
    foot.hips.push_back(placeJoint(skeleton, pose, foot.leg.hip).position);
  }
  foot.down.assign(clip.frameCount(), false);
  foot.corrections.resize(clip.frameCount());
  return foot;
}

double reachAt(const GaitMoment& moment, double legMetres) {
  return legMetres * std::lerp(gaitTable(Gait::kWalk).reach, gaitTable(Gait::kJog).reach, moment.jogShare);
}

/// Lets the sole settle and the toes bend; into the swing the bend goes on for a moment and fades.
void shapeFoot(const GaitTrack& track, const std::vector<Stance>& stances, double fps, Foot& foot) {
  std::vector<double> bendShare(foot.motion.size(), 0.0);
  for (const Stance& stance : stances) {
    for (std::size_t f = stance.first; f <= stance.last; ++f) {
      const double slap = std::lerp(kWalkSlapSeconds, kJogSlapSeconds, track.moments[f].jogShare);
      // A foot that stood from the first frame on has no strike to come down from.
      const double since = stance.first == 0 ? slap : static_cast<double>(f - stance.first) / fps;
      settleSole(since, slap, foot.motion[f]);
    }
    const auto fade = static_cast<std::size_t>(std::lround(kToeFadeSeconds * fps));
    const std::size_t from = stance.first - std::min(stance.first, fade / 2);
    const std::size_t end = std::min(stance.last + fade, bendShare.size() - 1);
    for (std::size_t f = from; f <= end; ++f) {
      double share = 1.0;
      if (f > stance.last) share = 1.0 - static_cast<double>(f - stance.last) / static_cast<double>(fade);
      if (f < stance.first)
        share = 1.0 - static_cast<double>(stance.first - f) / static_cast<double>(fade / 2 + 1);
      bendShare[f] = std::max(bendShare[f], smoothStep(share));
    }
  }
  for (std::size_t f = 0; f < bendShare.size(); ++f)
    foot.motion[f].toeBend = bendShare[f] * toeBend(pitchBeyondFlat(foot.motion[f]));
}

/// Corrects every stance, and ends it before the leg would get too long.
void pinStances(const GaitTrack& track, const std::vector<Stance>& stances, double legMetres, Foot& foot) {
  for (const Stance& stance : stances) {
    const Footprint print = footprintOf(foot.motion, track, stance);
    for (std::size_t f = stance.first; f <= stance.last; ++f) {
      foot.corrections[f] = correctionTo(print, foot.motion[f]);
      const double share =
          static_cast<double>(f - stance.first) / static_cast<double>(stance.last - stance.first + 1);
      // Late in a stance the knee bends already: as long as the model's own leg, not as long as it can get.
      const double reach = reachAt(track.moments[f], legMetres);
      const double own = std::min((foot.motion[f].ankle - foot.hips[f]).norm(), reach);
      const double bending = smoothStep((share - 0.6) / 0.35) * walkingShare(track.moments[f]);
      if (share > 0.5)
        liftHeel(foot.motion[f], foot.hips[f], std::lerp(reach, own, bending), foot.corrections[f]);
      foot.down[f] = true;
    }
    const double length = static_cast<double>(stance.last - stance.first);
    const auto spare = static_cast<std::size_t>(kLargestRelease * length);
    for (std::size_t f = stance.last; f > stance.last - spare; --f) {
      const Vec3 ankle = foot.motion[f].ankle + foot.corrections[f].place;
      if ((ankle - foot.hips[f]).norm() <= reachAt(track.moments[f], legMetres)) break;
      foot.down[f] = false;
    }
  }
}

/// Each value becomes the largest within `reach` frames, then a bell-shaped mean: an envelope without
/// corners.
std::vector<double> envelope(const std::vector<double>& values, std::size_t reach) {
  std::vector<double> largest = values;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t last = std::min(i + reach, values.size() - 1);
    for (std::size_t k = i - std::min(i, reach); k <= last; ++k) largest[i] = std::max(largest[i], values[k]);
  }
  return bellMean(largest, reach);
}

/// Lifts the swinging foot where it would come too near to the floor.
void clearFloor(const GaitTrack& track, Foot& foot) {
  const std::size_t count = foot.down.size();
  std::vector<double> lift(count, 0.0);
  std::size_t f = 0;
  while (f < count) {
    if (foot.down[f]) {
      ++f;
      continue;
    }
    std::size_t next = f;
    while (next < count && !foot.down[next]) ++next;
    for (std::size_t i = f; i < next; ++i) {
      const double share = static_cast<double>(i - f + 1) / static_cast<double>(next - f + 1);
      const double clearance = std::lerp(kWalkClearance, kJogClearance, track.moments[i].jogShare);
      const double wanted = clearance * std::sin(std::numbers::pi * share);
      const FootMotion now = corrected(foot.motion[i], foot.corrections[i]);
      lift[i] = std::max(0.0, kGaitSoleMetres + wanted - std::min(now.heel().y(), now.toe().y()));
    }
    f = next;
  }
  const std::vector<double> smooth = envelope(lift, 2);
  for (std::size_t i = 0; i < count; ++i) {
    if (foot.down[i]) continue;
    // Eased in and out, so that neither toe-off nor landing is a jump; but never through the floor.
    const std::size_t reach = kLiftEaseFrames;
    std::size_t away = 1;
    while (away < reach && away <= i && i + away < count && !foot.down[i - away] && !foot.down[i + away])
      ++away;
    const FootMotion now = corrected(foot.motion[i], foot.corrections[i]);
    const double through = kGaitSoleMetres - std::min(now.heel().y(), now.toe().y());
    const double eased = smooth[i] * smoothStep(static_cast<double>(away) / static_cast<double>(reach));
    foot.corrections[i].place.y() += std::max({eased, through, 0.0});
  }
}

/// How far the root must come down at each frame for the legs in stance.
std::vector<double> rootLowering(const GaitTrack& track, const std::array<Foot, 2>& feet, double legMetres) {
  std::vector<double> lowering(track.moments.size(), 0.0);
  for (const Foot& foot : feet) {
    for (std::size_t f = 0; f < lowering.size(); ++f) {
      if (!foot.down[f]) continue;
      const Vec3 ankle = foot.motion[f].ankle + foot.corrections[f].place;
      const double reach = reachAt(track.moments[f], legMetres);
      const double across = (onFloor(ankle) - onFloor(foot.hips[f])).norm();
      const double up = std::sqrt(std::max(0.0, reach * reach - across * across));
      lowering[f] = std::max(lowering[f], foot.hips[f].y() - ankle.y() - up);
    }
  }
  lowering = envelope(lowering, 3);
  for (std::size_t f = 0; f < lowering.size(); ++f)
    lowering[f] = std::min(lowering[f], std::lerp(kWalkLowering, kJogLowering, track.moments[f].jogShare));
  return lowering;
}

}  // namespace

void plantFeet(const GaitTrack& track, Clip& clip) {
  STRIDEGRAPH_CHECK(track.moments.size() == clip.frameCount());
  const Skeleton skeleton = gaitSkeleton();
  const double legMetres = legLengths(skeleton, gaitLeg(Side::kLeft)).whole();
  std::array<Foot, 2> feet = {footOf(skeleton, track, clip, Side::kLeft),
                              footOf(skeleton, track, clip, Side::kRight)};
  for (const Side side : {Side::kLeft, Side::kRight}) {
    Foot& foot = feet[static_cast<std::size_t>(side)];
    const std::vector<Stance> stances = stancesOf(track, side);
    shapeFoot(track, stances, clip.framesPerSecond, foot);
    pinStances(track, stances, legMetres, foot);
    carryThroughSwing(foot.down, foot.corrections);
    clearFloor(track, foot);
  }
  const std::vector<double> lowering = rootLowering(track, feet, legMetres);
  for (std::size_t f = 0; f < clip.frameCount(); ++f) {
    clip.rootPositions[f].y() -= lowering[f];
    for (const Foot& foot : feet) {
      const FootMotion target = corrected(foot.motion[f], foot.corrections[f]);
      const double longest = std::lerp(kLongestLeg, kLongestJogLeg, track.moments[f].jogShare);
      solveLeg(skeleton, foot.leg, {target.ankle, target.rotation}, longest, clip.rootPositions[f],
               clip.rotationsOf(f));
      Quat& toes = clip.rotationsOf(f)[foot.leg.ankle.value + 1];
      toes = (axisRotation(Axis::kX, Angle::radians(-target.toeBend)) * toes).normalized();
    }
  }
}

}  // namespace stridegraph
