#include "walk/standing_body.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/rotation.h"
#include "motion/leg_ik.h"
#include "walk/standing.h"

namespace stridegraph {
namespace {

/// A leg may be stretched so far, or as far as it is where the body stands.
constexpr double kUsualReach = 0.985;

/// Who stands turns no joint faster than this, in a second.
constexpr Angle kCalmPerSecond = Angle::degrees(50.0);

/// Feet that stand are at least so far apart from side to side, as a share of the leg.
constexpr double kLeastApart = 0.08;

ContactMask contactsOf(const WalkFoot& foot) {
  unsigned mask = 0;
  for (const std::size_t k : foot.contacts) mask |= 1U << k;
  return static_cast<ContactMask>(mask);
}

/// Of a library's frame, where an ankle is relative to the body's placement.
JointPlacement placedInBody(const MotionLibrary& library, FrameIndex frame, JointIndex joint) {
  const FloorTransform bodyFromRoom = library.placementAt(frame).inverse();
  const JointPlacement world = placeJoint(library.skeleton, library.frames.pose(frame.value), joint);
  return {bodyFromRoom.heading.rotation() * world.rotation, bodyFromRoom.apply(world.position)};
}

/// How far from a stand with feet side by side a frame is, metres; infinite where it does not stand on both.
double unrest(const MotionLibrary& library, FrameIndex frame, const std::array<WalkFoot, 2>& feet) {
  for (const WalkFoot& foot : feet)
    if ((library.contacts[frame.value] & contactsOf(foot)) == 0)
      return std::numeric_limits<double>::infinity();
  const Vec3 a = placedInBody(library, frame, feet[0].leg.ankle).position;
  const Vec3 b = placedInBody(library, frame, feet[1].leg.ankle).position;
  return std::abs(a.z() - b.z()) + 0.5 * std::abs(a.x() + b.x()) + 0.5 * std::abs(a.z() + b.z());
}

/// The joint next to the ankle that the foot can bend at: a contact joint that hangs on the ankle.
std::optional<JointIndex> toesOf(const MotionLibrary& library, const WalkFoot& foot) {
  const JointIndex tip = library.contactJoints[foot.contacts.back()];
  const Joint& joint = library.skeleton.joints[tip.value];
  if (joint.isEndSite || !joint.parent || joint.parent->value != foot.leg.ankle.value) return std::nullopt;
  return tip;
}

StandingFoot standingFoot(const MotionLibrary& library, FrameIndex frame, const WalkFoot& foot) {
  StandingFoot standing;
  standing.foot = foot;
  standing.ankle = placedInBody(library, frame, foot.leg.ankle);
  const JointPlacement tip = placedInBody(library, frame, library.contactJoints[foot.contacts.back()]);
  standing.ball = tip.position;
  standing.toes = toesOf(library, foot);
  standing.toesRotation = tip.rotation;
  const Vec3 hip = placedInBody(library, frame, foot.leg.hip).position;
  standing.reachMetres = std::max(kUsualReach * foot.legMetres, (standing.ankle.position - hip).norm());
  standing.contacts = contactsOf(foot);
  return standing;
}

/// Whether no joint turns faster between a frame and the next than who stands moves: a slip of capture does.
bool isCalm(const Clip& frames, std::uint32_t frame) {
  const std::span<const Quat> before = frames.rotationsOf(frame);
  const std::span<const Quat> after = frames.rotationsOf(frame + 1);
  const double most = kCalmPerSecond.radians() / frames.framesPerSecond;
  for (std::size_t j = 0; j < before.size(); ++j)
    if (angleBetween(before[j], after[j]).radians() > most) return false;
  return true;
}

/// The frames around one through which the body stands on both feet.
void extend(const MotionLibrary& library, const std::vector<Standing>& standing,
            const std::array<WalkFoot, 2>& feet, StandingBody& body) {
  const LibraryClip& clip = library.clipOf(body.frame);
  const auto stands = [&](std::uint32_t f) {
    return standing[f] != Standing::kNo && std::isfinite(unrest(library, FrameIndex(std::size_t{f}), feet));
  };
  body.firstFrame = body.lastFrame = static_cast<std::uint32_t>(body.frame.value);
  while (body.firstFrame > clip.firstFrame && stands(body.firstFrame - 1) &&
         isCalm(library.frames, body.firstFrame - 1))
    --body.firstFrame;
  while (body.lastFrame + 1 < clip.firstFrame + clip.frameCount && stands(body.lastFrame + 1) &&
         isCalm(library.frames, body.lastFrame))
    ++body.lastFrame;
}

}  // namespace

std::optional<StandingBody> standingBody(const MotionLibrary& library, const WalkFeet& feet) {
  if (feet.feet.size() != 2) return std::nullopt;
  const std::array<WalkFoot, 2> both = {feet.feet[0], feet.feet[1]};
  const std::vector<Standing> standing = standingFrames(library);
  StandingBody body;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t f = 0; f < standing.size(); ++f) {
    if (standing[f] == Standing::kNo) continue;
    const double far = unrest(library, FrameIndex(f), both);
    if (far >= least) continue;
    least = far;
    body.frame = FrameIndex(f);
  }
  if (!std::isfinite(least)) return std::nullopt;
  extend(library, standing, both, body);
  for (std::size_t i = 0; i < 2; ++i) {
    body.feet[i] = standingFoot(library, body.frame, both[i]);
    body.apart.leftMetres[i] = body.feet[i].ankle.position.x();
  }
  body.steps.legMetres = 0.5 * (both[0].legMetres + both[1].legMetres);
  if (body.apart.metres() < kLeastApart * body.steps.legMetres) return std::nullopt;
  body.upper = upperJoints(library.skeleton, both);
  body.cycle = steadiestCycle(library, both, body.upper);
  return body;
}

}  // namespace stridegraph
