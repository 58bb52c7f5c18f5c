#include "graph/skeleton_comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace stridegraph {
namespace {

/// Bones differ by a scale when each is within this share of it.
constexpr double kScaleTolerance = 0.01;
/// Shorter bones say nothing about a scale, metres.
constexpr double kLeastBoneMetres = 0.01;
/// A scale needs so many bones that agree on it.
constexpr std::size_t kLeastScaledBones = 3;

using Matches = std::vector<std::optional<std::size_t>>;

/// Finds for each joint of one skeleton the joint of the other that it is.
class JointMatcher {
 public:
  JointMatcher(const Skeleton& expected, const Skeleton& found, double toleranceMetres)
      : expected_(expected),
        found_(found),
        toleranceMetres_(toleranceMetres),
        expectedOf_(found.size()),
        foundOf_(expected.size()) {
    matchNames();
    matchPlaces();
  }

  /// For each joint found, the expected one.
  const Matches& expectedOf() const { return expectedOf_; }
  /// For each expected joint, the one found.
  const Matches& foundOf() const { return foundOf_; }

 private:
  void match(std::size_t e, std::size_t f) {
    expectedOf_[f] = e;
    foundOf_[e] = f;
  }

  void matchNames() {
    std::multimap<std::string, std::size_t> byName;
    for (std::size_t e = 0; e < expected_.size(); ++e) byName.emplace(expected_.joints[e].name, e);
    for (std::size_t f = 0; f < found_.size(); ++f) {
      const auto named = byName.find(found_.joints[f].name);
      if (named == byName.end()) continue;
      match(named->second, f);
      byName.erase(named);
    }
  }

  /// Parents come before their children, so that a whole tree of other names is matched from its root on.
  void matchPlaces() {
    if (!expected_.joints.empty() && !found_.joints.empty() && !expectedOf_[0] && !foundOf_[0]) match(0, 0);
    std::map<std::size_t, std::vector<std::size_t>> unmatchedChildren;
    for (std::size_t e = 1; e < expected_.size(); ++e) {
      if (!foundOf_[e]) unmatchedChildren[expected_.joints[e].parent->value].push_back(e);
    }
    for (std::size_t f = 1; f < found_.size(); ++f) {
      const std::optional<std::size_t> parent = expectedOf_[found_.joints[f].parent->value];
      if (expectedOf_[f] || !parent) continue;
      std::vector<std::size_t>& siblings = unmatchedChildren[*parent];
      const auto same =
          std::find_if(siblings.begin(), siblings.end(), [&](std::size_t e) { return isAlike(e, f); });
      if (same == siblings.end()) continue;
      match(*same, f);
      siblings.erase(same);
    }
  }

  bool isAlike(std::size_t e, std::size_t f) const {
    const Joint& one = expected_.joints[e];
    const Joint& other = found_.joints[f];
    return one.isEndSite == other.isEndSite && (one.offset - other.offset).norm() <= toleranceMetres_;
  }

  const Skeleton& expected_;
  const Skeleton& found_;
  double toleranceMetres_;
  Matches expectedOf_;
  Matches foundOf_;
};

std::string parentName(const Skeleton& skeleton, std::size_t joint) {
  const std::optional<JointIndex> parent = skeleton.joints[joint].parent;
  return parent ? skeleton.joints[parent->value].name : std::string();
}

void compareParents(const Skeleton& expected, const Skeleton& found, const JointMatcher& matcher,
                    SkeletonDifferences& differences) {
  for (std::size_t f = 0; f < found.size(); ++f) {
    const std::optional<std::size_t> e = matcher.expectedOf()[f];
    if (!e) continue;
    const std::optional<JointIndex> parent = found.joints[f].parent;
    const std::optional<JointIndex> expectedParent = expected.joints[*e].parent;
    if (!parent && !expectedParent) continue;
    if (parent && expectedParent && matcher.expectedOf()[parent->value] == std::size_t{expectedParent->value})
      continue;
    differences.parents.push_back({found.joints[f].name, parentName(expected, *e), parentName(found, f)});
  }
}

/// The factor between all bones, where there is one.
std::optional<double> scaleOf(const Skeleton& expected, const Skeleton& found, const Matches& expectedOf) {
  std::vector<double> ratios;
  for (std::size_t f = 0; f < found.size(); ++f) {
    if (!expectedOf[f]) continue;
    const double length = expected.joints[*expectedOf[f]].offset.norm();
    if (length > kLeastBoneMetres) ratios.push_back(found.joints[f].offset.norm() / length);
  }
  if (ratios.size() < kLeastScaledBones) return {};
  const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
  std::nth_element(ratios.begin(), middle, ratios.end());
  const double scale = *middle;
  if (!(scale > 0.0) || std::abs(scale - 1.0) <= kScaleTolerance) return {};
  for (std::size_t f = 0; f < found.size(); ++f) {
    if (!expectedOf[f]) continue;
    const Vec3 scaled = scale * expected.joints[*expectedOf[f]].offset;
    const double tolerance = kScaleTolerance * std::max(scaled.norm(), kLeastBoneMetres);
    if ((found.joints[f].offset - scaled).norm() > tolerance) return {};
  }
  return scale;
}

void compareOffsets(const Skeleton& expected, const Skeleton& found, const Matches& expectedOf,
                    double toleranceMetres, SkeletonDifferences& differences) {
  differences.scale = scaleOf(expected, found, expectedOf);
  for (std::size_t f = 0; f < found.size(); ++f) {
    if (!expectedOf[f]) continue;
    const Joint& joint = found.joints[f];
    const Joint& other = expected.joints[*expectedOf[f]];
    if (joint.isEndSite != other.isEndSite) differences.kinds.push_back(joint.name);
    if (!differences.scale && (joint.offset - other.offset).norm() > toleranceMetres)
      differences.offsets.push_back({joint.name, other.offset, joint.offset});
  }
  const auto apart = [](const auto& one) { return (one.found - one.expected).norm(); };
  std::stable_sort(differences.offsets.begin(), differences.offsets.end(),
                   [&](const auto& a, const auto& b) { return apart(a) > apart(b); });
}

/// The first joint found that comes before one that it should come after.
std::optional<std::string> firstOutOfOrder(const Skeleton& found, const Matches& expectedOf) {
  for (std::size_t f = 0; f < found.size(); ++f) {
    if (expectedOf[f] != f) return found.joints[f].name;
  }
  return {};
}

/// Of skeletons that are alike but for names of end sites.
std::vector<SkeletonDifferences::Renamed> renamedEndSites(const Skeleton& expected, const Skeleton& found) {
  std::vector<SkeletonDifferences::Renamed> renamed;
  for (std::size_t j = 0; j < found.size(); ++j) {
    if (expected.joints[j].name != found.joints[j].name)
      renamed.push_back({expected.joints[j].name, found.joints[j].name});
  }
  return renamed;
}

std::string listed(const std::vector<std::string>& items, std::size_t most) {
  const std::size_t count = std::min(items.size(), std::max<std::size_t>(most, 1));
  std::string text =
      fmt::format("{}", fmt::join(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(count), ", "));
  if (count < items.size()) text += fmt::format(" and {} more joints", items.size() - count);
  return text;
}

template <typename Item, typename Text>
std::vector<std::string> textsOf(const std::vector<Item>& items, const Text& text) {
  std::vector<std::string> texts;
  for (const Item& item : items) texts.push_back(text(item));
  return texts;
}

/// What stands before every expected name, or before every name found instead.
std::string renamedText(const std::vector<SkeletonDifferences::Renamed>& renamed, std::size_t mostJoints) {
  const auto& first = renamed.front();
  const bool longer = first.found.size() > first.expected.size();
  const std::string& with = longer ? first.found : first.expected;
  const std::string& without = longer ? first.expected : first.found;
  if (renamed.size() >= 3 && with.ends_with(without)) {
    const std::string prefix = with.substr(0, with.size() - without.size());
    const bool all = std::all_of(renamed.begin(), renamed.end(), [&](const auto& one) {
      return longer ? one.found == prefix + one.expected : one.expected == prefix + one.found;
    });
    if (all)
      return fmt::format("the names of {} joints {} \"{}\"", renamed.size(),
                         longer ? "begin with" : "lack the beginning", prefix);
  }
  return listed(
      textsOf(renamed,
              [](const auto& one) { return fmt::format("{} is called {}", one.expected, one.found); }),
      mostJoints);
}

std::string parentText(const SkeletonDifferences::OtherParent& one) {
  if (one.found.empty()) return fmt::format("{} is the root, expected below {}", one.joint, one.expected);
  if (one.expected.empty()) return fmt::format("{} hangs on {}, expected as the root", one.joint, one.found);
  return fmt::format("{} hangs on {}, expected {}", one.joint, one.found, one.expected);
}

std::string offsetText(const SkeletonDifferences::OtherOffset& one) {
  constexpr double kCentimetres = 100.0;
  const double found = kCentimetres * one.found.norm();
  const double expected = kCentimetres * one.expected.norm();
  // Lengths that read alike would not tell how bones differ that point elsewhere.
  if (std::abs(found - expected) >= 0.1)
    return fmt::format("{} {:.1f} cm, expected {:.1f} cm", one.joint, found, expected);
  const auto vector = [](const Vec3& v) {
    return fmt::format("({:.1f}, {:.1f}, {:.1f}) cm", kCentimetres * v.x(), kCentimetres * v.y(),
                       kCentimetres * v.z());
  };
  return fmt::format("{} at {}, expected {}", one.joint, vector(one.found), vector(one.expected));
}

}  // namespace

bool SkeletonDifferences::empty() const {
  return missing.empty() && added.empty() && renamed.empty() && parents.empty() && kinds.empty() &&
         offsets.empty() && !scale && !outOfOrder;
}

SkeletonDifferences differencesOf(const Skeleton& expected, const Skeleton& found, double toleranceMetres) {
  SkeletonDifferences differences;
  if (differenceBetween(expected, found, toleranceMetres).empty()) return differences;
  const JointMatcher matcher(expected, found, toleranceMetres);
  for (std::size_t e = 0; e < expected.size(); ++e) {
    if (!matcher.foundOf()[e]) differences.missing.push_back(expected.joints[e].name);
  }
  for (std::size_t f = 0; f < found.size(); ++f) {
    const std::optional<std::size_t> e = matcher.expectedOf()[f];
    if (!e) {
      differences.added.push_back(found.joints[f].name);
    } else if (expected.joints[*e].name != found.joints[f].name && !found.joints[f].isEndSite) {
      // End sites are named after their parents.
      differences.renamed.push_back({expected.joints[*e].name, found.joints[f].name});
    }
  }
  compareParents(expected, found, matcher, differences);
  compareOffsets(expected, found, matcher.expectedOf(), toleranceMetres, differences);
  if (differences.empty()) differences.outOfOrder = firstOutOfOrder(found, matcher.expectedOf());
  if (differences.empty()) differences.renamed = renamedEndSites(expected, found);
  return differences;
}

std::string describe(const SkeletonDifferences& differences, std::size_t mostJoints) {
  std::vector<std::string> parts;
  if (!differences.missing.empty()) parts.push_back("lacks " + listed(differences.missing, mostJoints));
  if (!differences.added.empty()) parts.push_back("also has " + listed(differences.added, mostJoints));
  if (!differences.renamed.empty()) parts.push_back(renamedText(differences.renamed, mostJoints));
  if (!differences.parents.empty())
    parts.push_back(listed(textsOf(differences.parents, parentText), mostJoints));
  if (!differences.kinds.empty())
    parts.push_back(fmt::format("a joint in one and an end site in the other: {}",
                                listed(differences.kinds, mostJoints)));
  if (differences.scale)
    parts.push_back(fmt::format("all bones are {:.3g} times as long: another unit, or a body of another size",
                                *differences.scale));
  if (!differences.offsets.empty())
    parts.push_back(listed(textsOf(differences.offsets, offsetText), mostJoints));
  if (differences.outOfOrder)
    parts.push_back(fmt::format("its joints come in another order from {} on", *differences.outOfOrder));
  return fmt::format("{}", fmt::join(parts, "; "));
}

}  // namespace stridegraph
