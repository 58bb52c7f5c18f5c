#include "motion/gait_synthesis.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "motion/gait_balance.h"
#include "motion/gait_feet.h"
#include "motion/gait_flight.h"
#include "motion/gait_gaze.h"
#include "motion/gait_variation.h"

namespace stridegraph {
namespace {

constexpr double kPi = std::numbers::pi;

// Small steps on the spot. No capture shows them: judged by eye, within what the standing pose bears.
constexpr double kStepHeight = 0.055;   ///< metres
constexpr double kStepSway = 0.022;     ///< Root towards the foot that carries, metres.
constexpr double kStepArmSwing = 0.10;  ///< Upper arms, each against its leg, rad.
constexpr double kStepCrouch = 0.010;   ///< metres

/// Slowest speeds at which the fits may be asked.
constexpr double kSlowestWalk = 0.75;
constexpr double kSlowestJog = 1.6;

Pose blendPoses(const Pose& from, const Pose& to, double share) {
  Pose result = from;
  result.rootPosition = from.rootPosition + share * (to.rootPosition - from.rootPosition);
  for (std::size_t j = 0; j < result.rotations.size(); ++j)
    result.rotations[j] = slerp(from.rotations[j], to.rotations[j], share);
  return result;
}

/// Going at the moment's speed: walk, jog or something between, at the same phase. How quickly the turn rate
/// changes is left out: these clips change it several times as quickly as the captures that the table was
/// measured on, and what it says beyond them snaps knees straight.
Pose goingPose(const GaitMoment& moment) {
  const GaitState walk{moment.phase, std::max(moment.speed, kSlowestWalk), moment.turnRate};
  const GaitState jog{moment.phase, std::max(moment.speed, kSlowestJog), moment.turnRate};
  if (moment.jogShare <= 0.0) return gaitPose(Gait::kWalk, walk);
  if (moment.jogShare >= 1.0) return gaitPose(Gait::kJog, jog);
  return blendPoses(gaitPose(Gait::kWalk, walk), gaitPose(Gait::kJog, jog), moment.jogShare);
}

void turnJoint(Pose& pose, GaitJoint joint, double yaw) {
  Quat& rotation = pose.rotations[indexOf(joint)];
  rotation = axisRotation(Axis::kY, Angle::radians(yaw)) * rotation;
}

/// Share of the swing of a foot whose stance lies round `middle`: 0..1 in swing, 0 in stance.
double swingShare(double phase, const ContactPhases& contact) {
  const double fromSwing = std::remainder(phase - contact.middle() - kPi, 2.0 * kPi);
  const double half = kPi - contact.halfWidth();
  if (half <= 0.0 || std::abs(fromSwing) >= half) return 0.0;
  return 0.5 * (fromSwing / half + 1.0);
}

/// Small steps on the spot, laid over the standing pose with weight `share`.
void stepOnTheSpot(const Skeleton& skeleton, const GaitMoment& moment, double share, Pose& pose) {
  const ContactPhases contact = contactAt(moment);
  std::array<AnkleTarget, 2> targets;
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const JointPlacement ankle = placeJoint(skeleton, pose.view(), gaitLeg(side).ankle);
    const double phase = moment.phase + (side == Side::kLeft ? 0.0 : kPi);
    const double swing = swingShare(phase, contact);
    const double up = std::pow(std::sin(kPi * swing), 2.0);
    const double tip = std::sin(kPi * swing) * std::sin(2.0 * kPi * swing);
    const Quat pitch = axisRotation(Axis::kX, Angle::degrees(14.0 * share * tip));
    targets[static_cast<std::size_t>(side)] = {ankle.position + Vec3(0, share * kStepHeight * up, 0),
                                               ankle.rotation * pitch};
  }
  const double sway = std::sin(moment.phase - contact.middle() + 0.5 * kPi);
  pose.rootPosition += share * Vec3(kStepSway * sway, -kStepCrouch, 0);
  pose.rotations[0] = axisRotation(Axis::kZ, Angle::degrees(-1.5 * share * sway)) * pose.rotations[0];
  const double lead = share * std::clamp(moment.turnRate, -1.2, 1.2);
  turnJoint(pose, GaitJoint::kThorax, 0.10 * lead);
  turnJoint(pose, GaitJoint::kHead, 0.25 * lead);
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const bool left = side == Side::kLeft;
    Quat& arm = pose.rotations[indexOf(left ? GaitJoint::kLeftHumerus : GaitJoint::kRightHumerus)];
    const double swing = share * kStepArmSwing * (left ? sway : -sway);
    arm = axisRotation(Axis::kX, Angle::radians(swing)) * arm;
  }
  for (const Side side : {Side::kLeft, Side::kRight})
    solveLeg(skeleton, gaitLeg(side), targets[static_cast<std::size_t>(side)], 0.999, pose.rootPosition,
             pose.rotations);
}

/// Breathing and a little sway, so that a standing body lives. `seconds` since the clip began; `side`, -1..1,
/// changes sign in a mirrored walk, so that the sway does.
void sway(double seconds, double side, double share, Pose& pose) {
  const double slow = side * std::sin(2.0 * kPi * seconds / 4.8);
  const double breath = std::sin(2.0 * kPi * seconds / 3.2);
  pose.rootPosition += share * Vec3(0.004 * slow, 0.0, 0.003 * breath);
  Quat& thorax = pose.rotations[indexOf(GaitJoint::kThorax)];
  thorax = axisRotation(Axis::kX, Angle::degrees(-0.6 * share * breath)) *
           axisRotation(Axis::kZ, Angle::degrees(0.4 * share * slow)) * thorax;
}

/// The pose of a moment in the world, feet not yet planted.
Pose poseAt(const Skeleton& skeleton, const GaitMoment& moment, double seconds) {
  const double walking = walkingShare(moment);
  Pose pose = goingPose(moment);
  if (walking < 1.0) {
    Pose still = standingPose();
    const double stepping = steppingShare(moment);
    if (stepping > 0.0) stepOnTheSpot(skeleton, moment, stepping, still);
    sway(seconds, std::sin(moment.phase), 1.0 - walking, still);
    pose = blendPoses(still, pose, walking);
  }
  const FloorTransform worldFromPath{moment.place, Heading::fromAngle(moment.heading)};
  pose.rootPosition = worldFromPath.apply(pose.rootPosition);
  pose.rotations[0] = (worldFromPath.heading.rotation() * pose.rotations[0]).normalized();
  return pose;
}

/// Frames first..first+count-1, moved so that the root of the first is over the origin.
Clip cut(const Clip& clip, std::size_t first, std::size_t count) {
  Clip result;
  result.name = clip.name;
  result.framesPerSecond = clip.framesPerSecond;
  result.jointCount = clip.jointCount;
  const Vec2 start = onFloor(clip.rootPositions[first]);
  for (std::size_t f = first; f < first + count; ++f) {
    result.append(clip.pose(f));
    result.rootPositions.back() -= Vec3(start.x(), 0.0, start.y());
  }
  return result;
}

}  // namespace

Result<Clip> synthesiseGait(const GaitRequest& request) {
  Result<GaitTrack> track = layTrack(request);
  if (!track) return fail(std::move(track));
  const Skeleton skeleton = gaitSkeleton();
  Clip clip;
  clip.name = request.name;
  clip.framesPerSecond = request.framesPerSecond;
  clip.jointCount = skeleton.size();
  for (std::size_t f = 0; f < track->moments.size(); ++f) {
    const double seconds =
        (static_cast<double>(f) - static_cast<double>(track->margin)) / request.framesPerSecond;
    clip.append(poseAt(skeleton, track->moments[f], seconds).view());
  }
  enliven(request, *track, clip);
  shiftWeight(*track, clip);
  fallFreely(*track, clip);
  plantFeet(*track, clip);
  leadWithTheHead(*track, clip);
  return cut(clip, track->margin, clip.frameCount() - 2 * track->margin);
}

}  // namespace stridegraph
