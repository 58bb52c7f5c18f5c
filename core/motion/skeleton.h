#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "math/typed_index.h"
#include "math/types.h"

namespace stridegraph {

using JointIndex = TypedIndex<struct JointTag>;

/// A joint, or the end of a bone that has no further joint.
struct Joint {
  std::string name;                  ///< As in the file. An end site is named after its parent: "lhand#end".
  std::optional<JointIndex> parent;  ///< Empty for the root alone.
  Vec3 offset = Vec3::Zero();        ///< From the parent, in the parent's axes, metres. Zero for the root.
  bool isEndSite = false;            ///< Never rotates; its rotation in a pose is the identity.
};

/// A tree of rigid bones. Joint 0 is the root; every parent comes before its children (the order of the
/// file). Where the root starts (a BVH's ROOT OFFSET) is not part of a skeleton.
struct Skeleton {
  std::vector<Joint> joints;

  std::size_t size() const { return joints.size(); }
  std::optional<JointIndex> find(std::string_view name) const;
  /// Joints whose parent is `joint`, in order.
  std::vector<JointIndex> childrenOf(JointIndex joint) const;
};

/// How two skeletons differ, as a sentence; empty when they are the same: equal names, parents and kinds, and
/// offsets within `toleranceMetres` of each other.
std::string differenceBetween(const Skeleton& a, const Skeleton& b, double toleranceMetres = 1e-3);

}  // namespace stridegraph
