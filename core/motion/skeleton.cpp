#include "motion/skeleton.h"

#include <fmt/format.h>

namespace stridegraph {

std::optional<JointIndex> Skeleton::find(std::string_view name) const {
  for (std::size_t j = 0; j < joints.size(); ++j) {
    if (joints[j].name == name) return JointIndex(j);
  }
  return std::nullopt;
}

std::vector<JointIndex> Skeleton::childrenOf(JointIndex joint) const {
  std::vector<JointIndex> children;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    if (joints[j].parent == joint) children.emplace_back(j);
  }
  return children;
}

std::string differenceBetween(const Skeleton& a, const Skeleton& b, double toleranceMetres) {
  if (a.size() != b.size()) return fmt::format("{} joints against {}", a.size(), b.size());
  for (std::size_t j = 0; j < a.size(); ++j) {
    const Joint& first = a.joints[j];
    const Joint& second = b.joints[j];
    if (first.name != second.name)
      return fmt::format("joint {} is {} in one and {} in the other", j, first.name, second.name);
    if (first.parent != second.parent) return fmt::format("joint {} hangs on different parents", first.name);
    if (first.isEndSite != second.isEndSite)
      return fmt::format("joint {} is an end site in one only", first.name);
    const double apart = (first.offset - second.offset).norm();
    if (apart > toleranceMetres) {
      return fmt::format("joint {} is offset {:.4f} m differently (at most {:.4f} m expected)", first.name,
                         apart, toleranceMetres);
    }
  }
  return {};
}

}  // namespace stridegraph
