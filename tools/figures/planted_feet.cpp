#include "figures/planted_feet.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "motion/kinematics.h"
#include "motion/transition_blend.h"

namespace stridegraph::figures {
namespace {

constexpr double kHeelRadiusMetres = 0.034;
constexpr double kBallRadiusMetres = 0.045;
constexpr double kBehindAnkleMetres = 0.04;
constexpr std::size_t kFewestFrames = 3;  ///< Shorter touches are no step.

bool hangsOn(const Skeleton& skeleton, std::size_t joint, std::size_t ancestor) {
  for (std::optional<JointIndex> up = skeleton.joints[joint].parent; up;
       up = skeleton.joints[up->value].parent) {
    if (up->value == ancestor) return true;
  }
  return false;
}

/// How far left of the root a joint is on average, metres, seen along the way it faces.
double leftness(const MotionLibrary& library, const Clip& clip, JointIndex joint) {
  double sum = 0.0;
  for (std::size_t f = 0; f < clip.frameCount(); ++f) {
    FloorTransform root = rootPlacement(clip.pose(f));
    root.heading = root.heading - library.facingOffset;
    sum += (root.inverse() * onFloor(jointPositions(library.skeleton, clip.pose(f))[joint.value])).x();
  }
  return sum;
}

PlantedFoot placed(const MotionLibrary& library, const Clip& clip, std::span<const ContactMask> contacts,
                   const Foot& foot, std::size_t first) {
  PlantedFoot planted{foot.left, first, first, Vec2::Zero(), Vec2::Zero()};
  int most = 0;
  int count = 0;
  for (std::size_t f = first; f < contacts.size() && (contacts[f] & foot.mask) != 0; ++f) {
    planted.lastFrame = f;
    const int touching = std::popcount(static_cast<unsigned>(contacts[f] & foot.mask));
    if (touching < most) continue;
    if (touching > most) {
      most = touching;
      count = 0;
      planted.heel = planted.toe = Vec2::Zero();
    }
    const std::vector<Vec3> joints = jointPositions(library.skeleton, clip.pose(f));
    planted.heel += onFloor(joints[foot.ankle.value]);
    planted.toe += onFloor(joints[foot.toe.value]);
    ++count;
  }
  planted.heel /= count;
  planted.toe /= count;
  return planted;
}

}  // namespace

std::vector<Foot> feetOf(const MotionLibrary& library, const Clip& clip) {
  std::vector<Foot> feet;
  for (std::size_t k = 0; k < library.contactJoints.size(); ++k) {
    const JointIndex joint = library.contactJoints[k];
    const auto bit = static_cast<ContactMask>(1U << k);
    const auto above = std::find_if(feet.begin(), feet.end(), [&](const Foot& foot) {
      return hangsOn(library.skeleton, joint.value, foot.ankle.value);
    });
    if (above == feet.end()) {
      feet.push_back({leftness(library, clip, joint) > 0.0, bit, joint, joint});
    } else {
      above->mask = static_cast<ContactMask>(above->mask | bit);
      above->toe = joint;
    }
  }
  return feet;
}

std::vector<PlantedFoot> plantedFeet(const MotionLibrary& library, const Clip& clip,
                                     std::span<const ContactMask> contacts) {
  std::vector<PlantedFoot> planted;
  for (const Foot& foot : feetOf(library, clip)) {
    for (std::size_t f = 0; f < contacts.size(); ++f) {
      if ((contacts[f] & foot.mask) == 0) continue;
      const PlantedFoot next = placed(library, clip, contacts, foot, f);
      if (next.lastFrame + 1 >= next.firstFrame + kFewestFrames) planted.push_back(next);
      f = next.lastFrame;
    }
  }
  std::stable_sort(planted.begin(), planted.end(),
                   [](const PlantedFoot& a, const PlantedFoot& b) { return a.firstFrame < b.firstFrame; });
  return planted;
}

std::vector<Vec2> soleOutline(const PlantedFoot& foot) {
  constexpr std::size_t kPointsOfEnd = 9;
  const Vec2 along = foot.toe - foot.heel;
  const Vec2 forward = along.norm() > 1e-6 ? Vec2(along.normalized()) : Vec2(0.0, 1.0);
  const Vec2 across(-forward.y(), forward.x());
  std::vector<Vec2> outline;
  const auto addEnd = [&](const Vec2& centre, double radius, double fromAngle) {
    for (std::size_t i = 0; i < kPointsOfEnd; ++i) {
      const double angle =
          fromAngle + std::numbers::pi * static_cast<double>(i) / static_cast<double>(kPointsOfEnd - 1);
      outline.emplace_back(centre + radius * (std::cos(angle) * across + std::sin(angle) * forward));
    }
  };
  addEnd(foot.toe - 0.03 * forward, kBallRadiusMetres, 0.0);
  addEnd(foot.heel - kBehindAnkleMetres * forward, kHeelRadiusMetres, std::numbers::pi);
  return outline;
}

}  // namespace stridegraph::figures
