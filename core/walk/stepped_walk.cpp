#include "walk/stepped_walk.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "motion/gait_curves.h"
#include "motion/leg_ik.h"
#include "walk/correction_blend.h"

namespace stridegraph {
namespace {

/// The hips' way is smoothed over this share of a step to either side.
constexpr double kSmoothing = 0.45;
/// Of a swing, how long the foot rises before it goes on and sinks after it has come.
constexpr double kUpright = 0.08;
/// The heel rises this long before the foot is lifted, and is down again at this time of the swing: shares.
constexpr double kHeelBefore = 0.28;
constexpr double kHeelUntil = 0.8;
/// A foot that goes so far ahead rises its heel by all of the params' angle.
constexpr double kHeelMetres = 0.7;
/// Of a foot that goes so far ahead, the upper body moves as in the captured walk.
constexpr double kWholeSwingMetres = 1.1;
/// A stand of fewer frames is shown as its one frame.
constexpr double kLeastSpan = 10.0;
/// In which the hips are lowered for a leg that would not reach, and raised again.
constexpr double kLoweringSeconds = 0.15;

/// From 0 to 1 with neither speed nor acceleration at both ends (5th order minimum jerk, Flash and Hogan
/// 1985).
double minimumJerk(double x) {
  const double t = std::clamp(x, 0.0, 1.0);
  return t * t * t * (10.0 + t * (-15.0 + 6.0 * t));
}

/// From 0 to 1 and back to 0, without corners.
double bump(double x) {
  if (x <= 0.0 || x >= 1.0) return 0.0;
  const double half = x * (1.0 - x);
  return 64.0 * half * half * half;
}

/// A step on the clock, frames.
struct TimedStep {
  const Footfall* fall = nullptr;
  double begin = 0.0;
  double frames = 0.0;
  double lift = 0.0;  ///< The foot leaves the floor
  double land = 0.0;  ///< and is down again.
};

FloorTransform middleOf(const FloorTransform& a, const FloorTransform& b) {
  return {0.5 * (a.translation + b.translation), blend(a.heading, b.heading, 0.5)};
}

/// A foot at one frame.
struct FootPose {
  FloorTransform base;  ///< Of the body, by which the foot stands.
  double lift = 0.0;    ///< Metres.
  double heel = 0.0;    ///< rad
  bool down = true;
};

class SteppedWalk {
 public:
  SteppedWalk(const MotionLibrary& library, const StandingBody& body, const StepPlan& plan,
              const SteppedWalkParams& params)
      : library_(library), body_(body), plan_(plan), params_(params), fps_(library.frames.framesPerSecond) {}

  SynthesisedWalk make() {
    setClock();
    layHips();
    setSwing();
    lowerHips();
    for (std::size_t f = 0; f < frames_; ++f) append(f);
    return std::move(walk_);
  }

 private:
  void setClock() {
    double now = std::max(4.0, std::round(params_.restSeconds * fps_));
    double longest = 1.0;
    for (const Footfall& fall : plan_.steps) {
      TimedStep step;
      step.fall = &fall;
      step.begin = now;
      const double metres = (placeOf(fall.foot, fall.to) - placeOf(fall.foot, fall.from)).norm();
      const double turn = std::abs((fall.to.heading - fall.from.heading).angle().radians());
      step.frames =
          fps_ * (params_.stepSeconds + params_.perMetreSeconds * metres + params_.perRadianSeconds * turn);
      const double rest = 0.5 * (1.0 - params_.swingShare) * step.frames;
      step.lift = step.begin + rest;
      step.land = step.begin + step.frames - rest;
      now += step.frames;
      longest = std::max(longest, step.frames);
      steps_.push_back(step);
    }
    smoothing_ = static_cast<std::size_t>(kSmoothing * longest);
    frames_ = static_cast<std::size_t>(std::ceil(now + std::max(6.0, params_.restSeconds * fps_))) + 1;
    // The hips come to rest within the smoothing behind the last step.
    if (!steps_.empty()) frames_ += smoothing_;
    walk_.clip.framesPerSecond = fps_;
    walk_.clip.jointCount = library_.skeleton.size();
  }

  Vec2 placeOf(std::size_t foot, const FloorTransform& base) const {
    const Vec3& ankle = body_.feet[foot].ankle.position;
    return base * Vec2(ankle.x(), ankle.z());
  }

  /// Corners of the hips' way: between both feet when both are down, over the one that stands otherwise.
  struct Corner {
    double frame = 0.0;
    FloorTransform body;
  };
  std::vector<Corner> corners() const {
    std::vector<Corner> list = {{0.0, plan_.start}};
    std::array<FloorTransform, 2> stands = {plan_.start, plan_.start};
    for (const TimedStep& step : steps_) {
      const std::size_t foot = step.fall->foot;
      const FloorTransform before = middleOf(stands[0], stands[1]);
      stands[foot] = step.fall->to;
      const FloorTransform after = middleOf(stands[0], stands[1]);
      list.push_back({step.begin, before});
      FloorTransform over = middleOf(before, after);
      const Vec2 aside = placeOf(1 - foot, stands[1 - foot]) - over.translation;
      const Vec2 across = over.heading.rotate(Vec2::UnitX());
      over.translation += params_.swayMetres * std::copysign(1.0, aside.dot(across)) * across;
      list.push_back({step.begin + 0.5 * step.frames, over});
    }
    if (!steps_.empty()) list.push_back({steps_.back().begin + steps_.back().frames, plan_.goal});
    return list;
  }

  void layHips() {
    const std::vector<Corner> list = corners();
    std::array<std::vector<double>, 3> tracks;
    std::vector<double> turns = {0.0};
    for (std::size_t i = 1; i < list.size(); ++i)
      turns.push_back(turns.back() + (list[i].body.heading - list[i - 1].body.heading).angle().radians());
    std::size_t next = 1;
    for (std::size_t f = 0; f < frames_; ++f) {
      const auto now = static_cast<double>(f);
      while (next < list.size() && list[next].frame <= now) ++next;
      const Corner& a = list[next - 1];
      const Corner& b = list[std::min(next, list.size() - 1)];
      const double span = b.frame - a.frame;
      const double share = span > 0.0 ? std::clamp((now - a.frame) / span, 0.0, 1.0) : 0.0;
      const Vec2 place = a.body.translation + share * (b.body.translation - a.body.translation);
      const double turn = std::lerp(turns[next - 1], turns[std::min(next, list.size() - 1)], share);
      tracks[0].push_back(place.x());
      tracks[1].push_back(place.y());
      tracks[2].push_back(turn);
    }
    for (std::vector<double>& track : tracks) track = bellMean(track, smoothing_);
    for (std::size_t f = 0; f < frames_; ++f) {
      walk_.placements.push_back({{tracks[0][f], tracks[1][f]},
                                  plan_.start.heading + Heading::fromAngle(Angle::radians(tracks[2][f]))});
    }
    // Sums leave a rest at the ends, where the body stands exactly where it should.
    walk_.placements.front() = plan_.start;
    walk_.placements.back() = plan_.goal;
  }

  /// How much of a walk the upper body shows: more in longer steps ahead, nothing where the body stands.
  void setSwing() {
    swing_.assign(frames_, 0.0);
    for (const TimedStep& step : steps_) {
      const double share = std::clamp(metresAhead(*step.fall) / kWholeSwingMetres, 0.0, 1.0);
      const auto end = std::min(frames_, static_cast<std::size_t>(step.begin + step.frames));
      for (auto f = static_cast<std::size_t>(std::ceil(step.begin)); f < end; ++f) swing_[f] = share;
    }
    swing_ = bellMean(swing_, smoothing_);
  }

  /// How far ahead a foot goes, seen by the body before it.
  double metresAhead(const Footfall& fall) const {
    return fall.from.heading.direction().dot(placeOf(fall.foot, fall.to) - placeOf(fall.foot, fall.from));
  }

  /// Turns the joints of the upper body as in a walk, as much as that is shown.
  void swingArms(std::size_t frame, Pose& pose) const {
    if (!body_.cycle || steps_.empty() || swing_[frame] < 1e-6) return;
    const auto now = static_cast<double>(frame);
    const TimedStep* step = &steps_.front();
    for (const TimedStep& next : steps_)
      if (next.begin <= now) step = &next;
    const double share = std::clamp((now - step->begin) / step->frames, 0.0, 1.0);
    for (const JointIndex joint : body_.upper) {
      Quat& rotation = pose.rotations[joint.value];
      rotation =
          rotation
              .slerp(swing_[frame], rotationInCycle(library_, *body_.cycle, joint, step->fall->foot, share))
              .normalized();
    }
  }

  /// How a foot is at a frame.
  FootPose footAt(std::size_t foot, double frame) const {
    FootPose pose{plan_.start};
    for (const TimedStep& step : steps_) {
      if (step.fall->foot != foot) continue;
      const FloorTransform& from = step.fall->from;
      const FloorTransform& to = step.fall->to;
      const double swing = (frame - step.lift) / (step.land - step.lift);
      const double metres = (placeOf(foot, to) - placeOf(foot, from)).norm();
      const double ahead = metresAhead(*step.fall);
      const double most = params_.heelRise.radians() * std::clamp(ahead / kHeelMetres, 0.0, 1.0);
      pose.heel += most * bump((swing + kHeelBefore) / (kHeelUntil + kHeelBefore));
      if (swing <= 0.0) continue;
      pose.base = to;
      if (swing >= 1.0) continue;
      const double share = minimumJerk((swing - kUpright) / (1.0 - 2.0 * kUpright));
      const double turn = (to.heading - from.heading).angle().radians();
      pose.base = {from.translation + share * (to.translation - from.translation),
                   from.heading + Heading::fromAngle(Angle::radians(share * turn))};
      pose.lift = (params_.liftMetres + params_.liftPerMetre * metres) * bump(swing);
      pose.down = false;
    }
    return pose;
  }

  /// Where the ankle is to be, world.
  AnkleTarget targetOf(const StandingFoot& foot, const FootPose& pose) const {
    const Quat turn = pose.base.heading.rotation();
    AnkleTarget target{pose.base.apply(foot.ankle.position), turn * foot.ankle.rotation};
    if (pose.heel != 0.0) {
      const Vec3 ball = pose.base.apply(foot.ball);
      const Quat roll = rollOf(foot, target, ball, pose.heel);
      target.position = ball + roll * (target.position - ball);
      target.rotation = roll * target.rotation;
    }
    target.position.y() += pose.lift;
    return target;
  }

  /// Lifts the ankle over the ball of the foot.
  static Quat rollOf(const StandingFoot& foot, const AnkleTarget& flat, const Vec3& ball, double radians) {
    const Vec3 side = flat.rotation * foot.foot.sideInAnkle;
    const Vec3 level = Vec3(side.x(), 0.0, side.z()).normalized();
    const Vec3 arm = flat.position - ball;
    const double rises = level.cross(arm).y() >= 0.0 ? 1.0 : -1.0;
    return Quat(Eigen::AngleAxisd(rises * radians, level));
  }

  /// Where in the library the body stands: it goes to and fro through the stand, never faster than captured.
  double standingFrame(std::size_t frame) const {
    const double span = body_.lastFrame - body_.firstFrame;
    if (span < kLeastSpan) return static_cast<double>(body_.frame.value);
    const double phase = 2.0 * static_cast<double>(frame) / span;
    return body_.firstFrame + 0.5 * span * (1.0 - std::cos(phase));
  }

  /// The root over a placement, as the library's frame has it.
  Pose poseAt(std::size_t frame) const {
    const double at = standingFrame(frame);
    const auto first = static_cast<std::size_t>(at);
    Pose pose = capturedPose(first, walk_.placements[frame]);
    const double share = at - static_cast<double>(first);
    if (share <= 0.0) return pose;
    const Pose next = capturedPose(first + 1, walk_.placements[frame]);
    pose.rootPosition += share * (next.rootPosition - pose.rootPosition);
    for (std::size_t j = 0; j < pose.rotations.size(); ++j)
      pose.rotations[j] = pose.rotations[j].slerp(share, next.rotations[j]);
    return pose;
  }

  /// A captured pose moved to a placement.
  Pose capturedPose(std::size_t captured, const FloorTransform& placement) const {
    const PoseView view = library_.frames.pose(captured);
    const FloorTransform roomFromLibrary = placement * library_.placementAt(FrameIndex(captured)).inverse();
    Pose pose{roomFromLibrary.apply(view.rootPosition), {view.rotations.begin(), view.rotations.end()}};
    pose.rotations[0] = (roomFromLibrary.heading.rotation() * pose.rotations[0]).normalized();
    return pose;
  }

  /// Turns a leg from the hip as far as its foot is turned from where the body faces, so that the knee goes
  /// with the foot.
  void turnLeg(const StandingFoot& foot, const FootPose& at, const Heading& facing, Pose& pose) const {
    const JointIndex hip = foot.foot.leg.hip;
    const std::optional<JointIndex>& parent = library_.skeleton.joints[hip.value].parent;
    const Quat above = placeJoint(library_.skeleton, pose.view(), *parent).rotation;
    const Quat turn = (at.base.heading - facing).rotation();
    Quat& rotation = pose.rotations[hip.value];
    rotation = (above.conjugate() * turn * above * rotation).normalized();
  }

  /// How far the hips must come down so that both legs reach.
  void lowerHips() {
    lowering_.assign(frames_, 0.0);
    for (std::size_t f = 0; f < frames_; ++f) {
      const Pose pose = poseAt(f);
      for (std::size_t i = 0; i < 2; ++i) {
        const StandingFoot& foot = body_.feet[i];
        const Vec3 hip = placeJoint(library_.skeleton, pose.view(), foot.foot.leg.hip).position;
        const Vec3 ankle = targetOf(foot, footAt(i, static_cast<double>(f))).position;
        const double across = (onFloor(ankle) - onFloor(hip)).norm();
        const double up = std::sqrt(std::max(0.0, foot.reachMetres * foot.reachMetres - across * across));
        lowering_[f] = std::max(lowering_[f], hip.y() - ankle.y() - up);
      }
      if (lowering_[f] < 1e-9) lowering_[f] = 0.0;
    }
    lowering_ = smoothEnvelope(lowering_,
                               static_cast<std::size_t>(std::max(1.0, std::round(kLoweringSeconds * fps_))));
  }

  void append(std::size_t frame) {
    Pose pose = poseAt(frame);
    swingArms(frame, pose);
    pose.rootPosition.y() -= lowering_[frame];
    unsigned contacts = 0;
    bool down = true;
    for (std::size_t i = 0; i < 2; ++i) {
      const StandingFoot& foot = body_.feet[i];
      const FootPose at = footAt(i, static_cast<double>(frame));
      const AnkleTarget target = targetOf(foot, at);
      turnLeg(foot, at, walk_.placements[frame].heading, pose);
      solveLeg(library_.skeleton, foot.foot.leg, target,
               std::min(1.0, foot.reachMetres / foot.foot.legMetres), pose.rootPosition, pose.rotations);
      if (foot.toes) {
        const Quat wanted = at.base.heading.rotation() * foot.toesRotation;
        pose.rotations[foot.toes->value] = (target.rotation.conjugate() * wanted).normalized();
      }
      if (at.down) contacts |= foot.contacts;
      down = down && at.down && at.heel == 0.0;
    }
    walk_.clip.append(pose.view());
    walk_.contacts.push_back(static_cast<ContactMask>(contacts));
    walk_.frameKinds.push_back(down ? EdgeKind::kClipPiece : EdgeKind::kTransition);
    walk_.accelerations.emplace_back(Vec2::Zero());
  }

  const MotionLibrary& library_;
  const StandingBody& body_;
  const StepPlan& plan_;
  const SteppedWalkParams& params_;
  double fps_;
  std::vector<TimedStep> steps_;
  std::size_t smoothing_ = 1;
  std::size_t frames_ = 0;
  std::vector<double> lowering_;
  std::vector<double> swing_;  ///< For each frame how much the upper body moves as in a walk, 0..1.
  SynthesisedWalk walk_;
};

}  // namespace

SynthesisedWalk stepWalk(const MotionLibrary& library, const StandingBody& body, const StepPlan& plan,
                         const SteppedWalkParams& params) {
  return SteppedWalk(library, body, plan, params).make();
}

}  // namespace stridegraph
