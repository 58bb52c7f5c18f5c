#include "walk/walk_cycle.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/rotation.h"
#include "motion/gait_curves.h"

namespace stridegraph {
namespace {

/// Durations of a swing, seconds: shorter ones are stumbles, longer ones stand on one foot.
constexpr double kShortestSwing = 0.2;
constexpr double kLongestSwing = 0.8;
/// Speeds of an unhurried walk, metres per second.
constexpr double kSlowest = 0.6;
constexpr double kFastest = 1.5;
constexpr Angle kMostTurn = Angle::degrees(12.0);

/// Frames [lift, land) in which a foot is in the air.
struct Swing {
  std::size_t foot = 0;
  std::size_t lift = 0;
  std::size_t land = 0;
};

bool isDown(const MotionLibrary& library, const WalkFoot& foot, std::size_t frame) {
  return std::any_of(foot.contacts.begin(), foot.contacts.end(),
                     [&](std::size_t k) { return ((library.contacts[frame] >> k) & 1U) != 0; });
}

/// The swings of a clip in the order in which they begin.
std::vector<Swing> swingsOf(const MotionLibrary& library, const LibraryClip& clip,
                            const std::array<WalkFoot, 2>& feet) {
  std::vector<Swing> swings;
  const std::size_t end = std::size_t{clip.firstFrame} + clip.frameCount;
  for (std::size_t foot = 0; foot < 2; ++foot) {
    for (std::size_t f = clip.firstFrame + 1U; f < end; ++f) {
      if (isDown(library, feet[foot], f) || !isDown(library, feet[foot], f - 1)) continue;
      Swing swing{foot, f, f};
      while (swing.land < end && !isDown(library, feet[foot], swing.land)) ++swing.land;
      if (swing.land < end) swings.push_back(swing);
    }
  }
  std::sort(swings.begin(), swings.end(), [](const Swing& a, const Swing& b) { return a.lift < b.lift; });
  return swings;
}

/// The middle of the time in which both feet are down.
double between(const Swing& before, const Swing& after) {
  return 0.5 * static_cast<double>(before.land + after.lift);
}

FrameIndex nearestFrame(double frame) {
  return FrameIndex(static_cast<std::size_t>(std::lround(frame)));
}

bool isStraightWalk(const MotionLibrary& library, const WalkCycle& cycle) {
  const FloorTransform gone =
      library.placementAt(nearestFrame(cycle.begin)).inverse() * library.placementAt(nearestFrame(cycle.end));
  const double speed = gone.translation.norm() * library.frames.framesPerSecond / (cycle.end - cycle.begin);
  return speed >= kSlowest && speed <= kFastest && gone.heading.cos >= Heading::fromAngle(kMostTurn).cos;
}

/// The mean angle by which joints differ at the end from what they were at the beginning, radians.
double mismatch(const MotionLibrary& library, const WalkCycle& cycle, const std::vector<JointIndex>& joints) {
  const std::span<const Quat> first = library.frames.rotationsOf(nearestFrame(cycle.begin).value);
  const std::span<const Quat> last = library.frames.rotationsOf(nearestFrame(cycle.end).value);
  double sum = 0.0;
  for (const JointIndex joint : joints) sum += angleBetween(first[joint.value], last[joint.value]).radians();
  return sum / static_cast<double>(joints.size());
}

/// Four swings in turn, of which the two in the middle make a cycle.
bool areSteps(const MotionLibrary& library, std::span<const Swing> swings) {
  const double fps = library.frames.framesPerSecond;
  for (std::size_t i = 0; i < swings.size(); ++i) {
    const auto seconds = static_cast<double>(swings[i].land - swings[i].lift) / fps;
    if (seconds < kShortestSwing || seconds > kLongestSwing) return false;
    if (i == 0) continue;
    if (swings[i].foot == swings[i - 1].foot || swings[i].lift < swings[i - 1].land) return false;
  }
  return true;
}

Quat rotationAt(const MotionLibrary& library, JointIndex joint, double frame) {
  const double whole = std::floor(frame);
  const auto first = static_cast<std::size_t>(whole);
  const std::size_t next = std::min(first + 1, library.frames.frameCount() - 1);
  return library.frames.rotationsOf(first)[joint.value].slerp(frame - whole,
                                                              library.frames.rotationsOf(next)[joint.value]);
}

}  // namespace

std::vector<JointIndex> upperJoints(const Skeleton& skeleton, const std::array<WalkFoot, 2>& feet) {
  std::vector<bool> lower(skeleton.size(), false);
  lower[0] = true;
  for (const WalkFoot& foot : feet) {
    for (std::optional<JointIndex> at = foot.leg.hip; at; at = skeleton.joints[at->value].parent)
      lower[at->value] = true;
  }
  std::vector<bool> ofLeg(skeleton.size(), false);
  for (const WalkFoot& foot : feet) ofLeg[foot.leg.hip.value] = true;
  std::vector<JointIndex> upper;
  for (std::size_t j = 1; j < skeleton.size(); ++j) {
    const Joint& joint = skeleton.joints[j];
    ofLeg[j] = ofLeg[j] || ofLeg[joint.parent->value];
    if (!lower[j] && !ofLeg[j] && !joint.isEndSite) upper.emplace_back(j);
  }
  return upper;
}

std::optional<WalkCycle> steadiestCycle(const MotionLibrary& library, const std::array<WalkFoot, 2>& feet,
                                        const std::vector<JointIndex>& joints) {
  if (joints.empty()) return std::nullopt;
  std::optional<WalkCycle> best;
  double least = std::numeric_limits<double>::infinity();
  for (const LibraryClip& clip : library.clips) {
    const std::vector<Swing> swings = swingsOf(library, clip, feet);
    for (std::size_t i = 0; i + 4 < swings.size(); ++i) {
      const std::span<const Swing> steps = std::span(swings).subspan(i, 5);
      if (!areSteps(library, steps)) continue;
      const WalkCycle cycle{steps[2].foot, between(steps[1], steps[2]), between(steps[2], steps[3]),
                            between(steps[3], steps[4]), between(steps[0], steps[1])};
      if (!isStraightWalk(library, cycle)) continue;
      const double off = mismatch(library, cycle, joints);
      if (off >= least) continue;
      least = off;
      best = cycle;
    }
  }
  return best;
}

Quat rotationInCycle(const MotionLibrary& library, const WalkCycle& cycle, JointIndex joint, std::size_t foot,
                     double share) {
  if (foot == cycle.firstFoot) return rotationAt(library, joint, std::lerp(cycle.begin, cycle.middle, share));
  const Quat second = rotationAt(library, joint, std::lerp(cycle.middle, cycle.end, share));
  const Quat before = rotationAt(library, joint, std::lerp(cycle.before, cycle.begin, share));
  return second.slerp(smoothStep(share), before);
}

}  // namespace stridegraph
