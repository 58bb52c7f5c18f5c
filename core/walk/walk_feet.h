#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "graph/library.h"
#include "motion/leg_ik.h"

namespace stridegraph {

/// A foot of a library's body: the leg that it hangs on and where it can touch the floor.
struct WalkFoot {
  Leg leg;
  double legMetres = 0.0;             ///< Thigh and shin.
  std::vector<std::size_t> contacts;  ///< Indices into MotionLibrary::contactJoints, the ankle's side first.
  /// Level and across the foot while it stands, in the ankle's own axes: tells its yaw however it is pitched.
  Vec3 sideInAnkle = Vec3::UnitX();
};

/// All feet of a body.
struct WalkFeet {
  std::vector<WalkFoot> feet;
  std::vector<std::string> withoutLeg;  ///< Contact joints above which no leg can be made out.
};

/// The leg that ends in a foot with this joint: of all three joints in a row on the way to the root (which is
/// none of them) those whose shorter bone is longest. Empty where there are none, or where thigh and shin
/// differ by more than twofold. The bend axis is left to be measured.
std::optional<Leg> legAbove(const Skeleton& skeleton, JointIndex contactJoint);

/// Makes out the feet from the contact joints, and measures on the library's frames how their knees bend and
/// how they stand.
WalkFeet findWalkFeet(const MotionLibrary& library);

/// A foot through a clip.
struct FootTrack {
  std::vector<JointPlacement> ankles;      ///< World, frame by frame.
  std::vector<Vec3> hips;                  ///< World, metres,
  std::vector<Quat> hipRotations;          ///< and how they are turned.
  std::vector<Heading> headings;           ///< Of the foot.
  std::vector<std::vector<Vec3>> points;   ///< For each of WalkFoot::contacts, where it is.
  std::vector<std::vector<double>> holds;  ///< And how much it stands, 0..1: 1 when it does not move.

  std::size_t frameCount() const { return ankles.size(); }
};

/// Follows a foot through a clip. A contact joint holds while its mask says so and it is slower than 0.6 m/s,
/// the more the slower.
FootTrack trackFoot(const MotionLibrary& library, const WalkFoot& foot, const Clip& clip,
                    std::span<const ContactMask> masks);

}  // namespace stridegraph
