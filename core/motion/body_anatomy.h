#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "motion/clip.h"
#include "motion/kinematics.h"

namespace stridegraph {

enum class Limb { kTorso, kLeg, kArm, kHead };

/// Which joint of a skeleton belongs to which limb, told from how high joints are while the body moves: legs
/// are the chains that end lowest, the head is the chain that ends highest, arms are what else hangs on the
/// trunk. So it works for any names and any number of spine joints. Borrows the skeleton.
struct BodyAnatomy {
  const Skeleton& skeleton;
  std::vector<Pose> samples = {};           ///< Evenly spread over the motion; one at least.
  Pose standing = {};                       ///< One of them that is on its feet, moved to the floor's origin.
  std::vector<JointPlacement> placed = {};  ///< Every joint in that pose, world.
  std::vector<std::vector<std::size_t>> children = {};
  std::vector<double> heights = {};  ///< Of each joint over the lowest one, metres: the median over time.
  std::vector<double> reach = {};    ///< Of the longest chain of bones below each joint, metres.
  std::vector<Limb> limb = {};
  std::vector<int> depthInLimb = {};  ///< Long bones since the joint where a limb begins; of legs, the hip.
  /// What poses of the motion are to be raised by, so that feet stand on the floor y = 0: 0 where their
  /// joints already lie as high over it as in a foot, and for bodies without legs.
  double liftMetres = 0.0;
  double floorMetres = 0.0;   ///< Height of the lowest joint while standing, world.
  double heightMetres = 0.3;  ///< From the lowest joint to the highest one while standing, 0.3 or more.

  const Vec3& at(std::size_t joint) const { return placed[joint].position; }
  /// How far a joint is from its parent.
  double boneMetres(std::size_t joint) const { return skeleton.joints[joint].offset.norm(); }
  /// A point given in the world at the standing pose, as an offset in a joint's axes.
  Vec3 offsetIn(std::size_t joint, const Vec3& point) const {
    return placed[joint].rotation.conjugate() * (point - at(joint));
  }
  /// The joints where limbs of a kind begin, ascending.
  std::vector<std::size_t> rootsOf(Limb kind) const;
  /// The two of them with the longest chains, ascending; all where they are fewer.
  std::vector<std::size_t> mainRootsOf(Limb kind) const;
};

/// The anatomy of a skeleton that moves as in `frames`. Without a frame, the rest pose stands on the floor.
BodyAnatomy bodyAnatomy(const Skeleton& skeleton, const Clip& frames);

}  // namespace stridegraph
