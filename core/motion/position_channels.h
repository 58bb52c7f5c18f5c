#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/error.h"
#include "motion/bvh_hierarchy.h"
#include "motion/bvh_motion.h"

namespace stridegraph {

/// What the position channels of a joint mean.
enum class PositionMeaning {
  kReplacesOffset,  ///< The numbers are the joint's place at its parent. The rule.
  kAddsToOffset,    ///< The numbers are a shift from OFFSET.
  kHoldsNothing,    ///< The numbers are no places: OFFSET stays in force.
};

/// The translation of every joint in every row, in file units and axes.
class JointTranslations {
 public:
  /// Decides for each joint from OFFSET and all rows what its position channels mean, and says in `warnings`
  /// where they do not replace OFFSET, naming the joints:
  /// - all zero, with an OFFSET that is not: OFFSET stays in force;
  /// - the same numbers at many joints of different OFFSETs: OFFSET stays in force;
  /// - most bones (by length) nearer to zero than a quarter of OFFSET: the numbers of all bones that do not
  ///   repeat OFFSET add to it, unless all bones are their OFFSETs times one factor, another size of body.
  /// ROOT and joints that move farther than OFFSET is long are no bones: of them only zeros are looked at.
  /// Keeps references.
  JointTranslations(const BvhHierarchy& hierarchy, const BvhMotion& motion, Warnings& warnings);

  PositionMeaning meaningOf(std::size_t joint) const { return meanings_[joint]; }
  Vec3 at(std::size_t joint, std::size_t frame) const;
  std::span<const double> row(std::size_t frame) const;
  std::size_t frameCount() const { return motion_.frameCount; }

  /// Mean translation of a joint, and the farthest that it comes from it.
  struct Spread {
    Vec3 mean = Vec3::Zero();
    double deviation = 0.0;
  };
  Spread spreadOf(std::size_t joint) const;

 private:
  const BvhHierarchy& hierarchy_;
  const BvhMotion& motion_;
  std::vector<PositionMeaning> meanings_;  ///< One for each joint.
};

}  // namespace stridegraph
