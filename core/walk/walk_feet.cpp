#include "walk/walk_feet.h"

#include <algorithm>

#include "base/check.h"

namespace stridegraph {
namespace {

/// Where a planted joint is taken to have let go: between what the planted toe does while the foot rolls and
/// what it does once it swings.
constexpr double kLetGoMetresPerSecond = 0.6;
constexpr double kLargestBoneRatio = 2.0;

/// Sum of how the knee is bent over all frames, in the hip's axes.
Vec3 bendAxisOf(const MotionLibrary& library, const Leg& leg) {
  const Vec3& thigh = library.skeleton.joints[leg.knee.value].offset;
  const Vec3& shin = library.skeleton.joints[leg.ankle.value].offset;
  Vec3 axis = Vec3::Zero();
  for (std::size_t f = 0; f < library.frames.frameCount(); ++f)
    axis += thigh.cross(library.frames.pose(f).rotations[leg.knee.value] * shin);
  const double length = axis.norm();
  return length > 1e-9 ? Vec3(axis / length) : thigh.unitOrthogonal();
}

/// Square to the foot's mean direction of up while it stands, and to where its farthest contact joint lies.
Vec3 sideOf(const MotionLibrary& library, const WalkFoot& foot) {
  Vec3 up = Vec3::Zero();
  Vec3 forward = Vec3::Zero();
  for (std::size_t f = 0; f < library.frames.frameCount(); ++f) {
    if (((library.contacts[f] >> foot.contacts.front()) & 1U) == 0) continue;
    const PoseView pose = library.frames.pose(f);
    const JointPlacement ankle = placeJoint(library.skeleton, pose, foot.leg.ankle);
    const JointIndex tip = library.contactJoints[foot.contacts.back()];
    up += ankle.rotation.conjugate() * Vec3::UnitY();
    forward +=
        ankle.rotation.conjugate() * (placeJoint(library.skeleton, pose, tip).position - ankle.position);
  }
  const Vec3 side = up.cross(forward);
  const double length = side.norm();
  if (length > 1e-6 * up.norm()) return side / length;
  // A foot of a single point: any level axis tells how it turns.
  return up.norm() > 1e-9 ? up.unitOrthogonal() : Vec3::UnitX();
}

double speedAt(const std::vector<Vec3>& track, std::size_t frame, double framesPerSecond) {
  const std::size_t before = frame == 0 ? 0 : frame - 1;
  const std::size_t after = std::min(frame + 1, track.size() - 1);
  if (after == before) return 0.0;
  return (track[after] - track[before]).norm() * framesPerSecond / static_cast<double>(after - before);
}

std::vector<double> holdsOf(const std::vector<Vec3>& track, std::span<const ContactMask> masks,
                            std::size_t bit, double framesPerSecond) {
  std::vector<double> holds(track.size(), 0.0);
  for (std::size_t f = 0; f < track.size(); ++f) {
    if (((masks[f] >> bit) & 1U) == 0) continue;
    const double share = 1.0 - speedAt(track, f, framesPerSecond) / kLetGoMetresPerSecond;
    holds[f] = share > 0.0 ? share * share : 0.0;
  }
  return holds;
}

}  // namespace

std::optional<Leg> legAbove(const Skeleton& skeleton, JointIndex contactJoint) {
  std::optional<Leg> best;
  double longest = 0.0;
  JointIndex ankle = contactJoint;
  while (skeleton.joints[ankle.value].parent) {
    const JointIndex knee = *skeleton.joints[ankle.value].parent;
    const std::optional<JointIndex>& hip = skeleton.joints[knee.value].parent;
    if (!hip || !skeleton.joints[hip->value].parent) break;
    const double shin = skeleton.joints[ankle.value].offset.norm();
    const double thigh = skeleton.joints[knee.value].offset.norm();
    if (std::min(shin, thigh) > longest &&
        std::max(shin, thigh) <= kLargestBoneRatio * std::min(shin, thigh)) {
      longest = std::min(shin, thigh);
      best = Leg{*hip, knee, ankle};
    }
    ankle = knee;
  }
  return best;
}

WalkFeet findWalkFeet(const MotionLibrary& library) {
  WalkFeet found;
  for (std::size_t k = 0; k < library.contactJoints.size(); ++k) {
    const std::optional<Leg> leg = legAbove(library.skeleton, library.contactJoints[k]);
    if (!leg) {
      found.withoutLeg.push_back(library.skeleton.joints[library.contactJoints[k].value].name);
      continue;
    }
    const auto same = std::find_if(found.feet.begin(), found.feet.end(),
                                   [&](const WalkFoot& foot) { return foot.leg.ankle == leg->ankle; });
    if (same == found.feet.end()) {
      found.feet.push_back({*leg, legLengths(library.skeleton, *leg).whole(), {k}});
    } else {
      same->contacts.push_back(k);
    }
  }
  for (WalkFoot& foot : found.feet) {
    foot.leg.bendAxis = bendAxisOf(library, foot.leg);
    foot.sideInAnkle = sideOf(library, foot);
  }
  return found;
}

FootTrack trackFoot(const MotionLibrary& library, const WalkFoot& foot, const Clip& clip,
                    std::span<const ContactMask> masks) {
  STRIDEGRAPH_CHECK(masks.size() == clip.frameCount());
  const std::size_t frameCount = clip.frameCount();
  std::vector<JointIndex> joints = {foot.leg.hip, foot.leg.ankle};
  for (const std::size_t contact : foot.contacts) joints.push_back(library.contactJoints[contact]);
  const JointChains chains(library.skeleton, joints);
  std::vector<std::size_t> slots;
  for (const JointIndex joint : joints) slots.push_back(chains.slotOf(joint));
  std::vector<JointPlacement> placements(chains.size());
  FootTrack track;
  track.ankles.resize(frameCount);
  track.hips.resize(frameCount);
  track.hipRotations.resize(frameCount);
  track.headings.resize(frameCount);
  track.points.assign(foot.contacts.size(), std::vector<Vec3>(frameCount));
  for (std::size_t f = 0; f < frameCount; ++f) {
    chains.place(clip.pose(f), placements);
    track.hips[f] = placements[slots[0]].position;
    track.hipRotations[f] = placements[slots[0]].rotation;
    track.ankles[f] = placements[slots[1]];
    const Vec3 side = track.ankles[f].rotation * foot.sideInAnkle;
    track.headings[f] = Heading::alongDirection({-side.z(), side.x()});
    for (std::size_t i = 0; i < foot.contacts.size(); ++i)
      track.points[i][f] = placements[slots[2 + i]].position;
  }
  for (std::size_t i = 0; i < foot.contacts.size(); ++i)
    track.holds.push_back(holdsOf(track.points[i], masks, foot.contacts[i], clip.framesPerSecond));
  return track;
}

}  // namespace stridegraph
