#include "motion/mirror_pairs.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "motion/mirror_names.h"

namespace stridegraph {
namespace {

constexpr double kSymmetricShareOfExtent = 0.05;
using Pairs = std::vector<JointIndex>;

/// True when `pairs` is an involution that keeps parents and kinds and pairs at least two joints.
bool fitsTheTree(const Skeleton& skeleton, const Pairs& pairs) {
  bool hasPair = false;
  for (std::size_t j = 0; j < skeleton.size(); ++j) {
    const std::size_t other = pairs[j].value;
    const Joint& a = skeleton.joints[j];
    const Joint& b = skeleton.joints[other];
    if (pairs[other] != JointIndex(j) || a.isEndSite != b.isEndSite || !a.parent != !b.parent) return false;
    if (a.parent && pairs[a.parent->value] != *b.parent) return false;
    hasPair = hasPair || other != j;
  }
  return hasPair;
}

std::optional<JointIndex> partnerByName(const Skeleton& skeleton, std::size_t j) {
  for (const std::string& name : mirroredNames(skeleton.joints[j].name)) {
    const std::optional<JointIndex> other = skeleton.find(name);
    if (other && !skeleton.joints[other->value].isEndSite) return other;
  }
  return std::nullopt;
}

std::vector<std::vector<std::size_t>> childLists(const Skeleton& skeleton) {
  std::vector<std::vector<std::size_t>> children(skeleton.size());
  for (std::size_t j = 0; j < skeleton.size(); ++j) {
    if (skeleton.joints[j].parent) children[skeleton.joints[j].parent->value].push_back(j);
  }
  return children;
}

/// End sites have no names of their own: the first of a joint belongs to the first of its partner, and so on.
void pairEndSites(const Skeleton& skeleton, Pairs& pairs) {
  const std::vector<std::vector<std::size_t>> children = childLists(skeleton);
  const auto endSitesOf = [&](std::size_t joint) {
    std::vector<std::size_t> ends;
    for (const std::size_t child : children[joint]) {
      if (skeleton.joints[child].isEndSite) ends.push_back(child);
    }
    return ends;
  };
  for (std::size_t j = 0; j < skeleton.size(); ++j) {
    const std::vector<std::size_t> mine = endSitesOf(j);
    const std::vector<std::size_t> others = endSitesOf(pairs[j].value);
    for (std::size_t i = 0; i < std::min(mine.size(), others.size()); ++i) {
      pairs[mine[i]] = JointIndex(others[i]);
    }
  }
}

/// A branch of the rest pose: where it begins, where its joints lie in the mean, and how many they are.
struct Branch {
  Vec3 position = Vec3::Zero();
  Vec3 sum = Vec3::Zero();
  double count = 1.0;

  Vec3 centre() const { return sum / count; }
};

std::vector<Branch> branchesOf(const Skeleton& skeleton) {
  std::vector<Branch> branches(skeleton.size());
  for (std::size_t j = 0; j < skeleton.size(); ++j) {
    const Joint& joint = skeleton.joints[j];
    if (joint.parent) branches[j].position = branches[joint.parent->value].position + joint.offset;
    branches[j].sum = branches[j].position;
  }
  for (std::size_t j = skeleton.size(); j-- > 1;) {
    Branch& parent = branches[skeleton.joints[j].parent->value];
    parent.sum += branches[j].sum;
    parent.count += branches[j].count;
  }
  return branches;
}

double extentOf(const std::vector<Branch>& branches) {
  double farthest = 0.0;
  for (const Branch& branch : branches) farthest = std::max(farthest, branch.position.norm());
  return farthest;
}

}  // namespace

Pairs pairJointsByName(const Skeleton& skeleton) {
  Pairs pairs;
  for (std::size_t j = 0; j < skeleton.size(); ++j) {
    const bool isEndSite = skeleton.joints[j].isEndSite;
    pairs.push_back(isEndSite ? JointIndex(j) : partnerByName(skeleton, j).value_or(JointIndex(j)));
  }
  pairEndSites(skeleton, pairs);
  return fitsTheTree(skeleton, pairs) ? pairs : Pairs{};
}

Pairs pairJointsByRestPose(const Skeleton& skeleton, const Vec3& planeNormal) {
  const std::vector<Branch> branches = branchesOf(skeleton);
  const std::vector<std::vector<std::size_t>> children = childLists(skeleton);
  const double tolerance = kSymmetricShareOfExtent * extentOf(branches);
  const auto reflected = [&](const Vec3& v) { return Vec3(v - 2.0 * v.dot(planeNormal) * planeNormal); };

  Pairs pairs(skeleton.size());
  std::vector<bool> isTaken(skeleton.size(), false);
  for (std::size_t j = 1; j < skeleton.size(); ++j) {
    double nearest = std::numeric_limits<double>::max();
    std::optional<std::size_t> partner;
    for (const std::size_t other : children[pairs[skeleton.joints[j].parent->value].value]) {
      if (isTaken[other] || branches[other].count != branches[j].count) continue;
      const double apart = std::max((reflected(branches[j].position) - branches[other].position).norm(),
                                    (reflected(branches[j].centre()) - branches[other].centre()).norm());
      if (apart < nearest) {
        nearest = apart;
        partner = other;
      }
    }
    if (!partner || nearest > tolerance) return {};
    pairs[j] = JointIndex(*partner);
    isTaken[*partner] = true;
  }
  return fitsTheTree(skeleton, pairs) ? pairs : Pairs{};
}

}  // namespace stridegraph
