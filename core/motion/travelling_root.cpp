#include "motion/travelling_root.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

#include "motion/bvh_channels.h"
#include "motion/quoted_names.h"

namespace stridegraph {
namespace {

/// Shares of the body's size. Joints below a parent that stands still move when they come this far from
/// their mean place: more than rounding.
constexpr double kMoves = 1e-3;
/// Joints below a parent that travels: more than what skeletons are stretched by marker noise.
constexpr double kMovesOnItsOwn = 1e-2;
/// No joint of a body goes as far against its parent.
constexpr double kTravels = 0.25;
/// Branches of as many joints in a row may be limbs.
constexpr std::size_t kLimb = 3;

/// Whether no channel of the joint ever changes.
bool standsStill(const BvhJoint& joint, const JointTranslations& translations) {
  const std::span<const double> first = valuesIn(joint, translations.row(0));
  for (std::size_t f = 1; f < translations.frameCount(); ++f) {
    const std::span<const double> values = valuesIn(joint, translations.row(f));
    if (!std::equal(values.begin(), values.end(), first.begin())) return false;
  }
  return true;
}

class TravelFinder {
 public:
  TravelFinder(const BvhHierarchy& hierarchy, const JointTranslations& translations)
      : hierarchy_(hierarchy), translations_(translations) {
    const std::size_t count = hierarchy.joints.size();
    children_.resize(count);
    branchSizes_.assign(count, 0);
    branchDepths_.assign(count, 0);
    for (std::size_t j = 0; j < count; ++j) spreads_.push_back(translations.spreadOf(j));
    for (std::size_t j = count; j-- > 0;) {
      const BvhJoint& joint = hierarchy.joints[j];
      if (joint.isEndSite) continue;
      ++branchSizes_[j];
      ++branchDepths_[j];
      if (!joint.parent) continue;
      branchSizes_[*joint.parent] += branchSizes_[j];
      branchDepths_[*joint.parent] = std::max(branchDepths_[*joint.parent], branchDepths_[j]);
      children_[*joint.parent].push_back(j);
    }
    for (auto& children : children_) std::reverse(children.begin(), children.end());
    measureSize();
  }

  std::size_t find() const {
    std::optional<std::size_t> mover;
    if (moves(0, kMoves)) mover = 0;
    std::size_t joint = 0;
    while (const std::optional<std::size_t> next = nextOf(joint, mover.has_value())) {
      joint = *next;
      if (moves(joint, mover ? kMovesOnItsOwn : kMoves)) mover = joint;
    }
    return mover.value_or(firstPlaced());
  }

 private:
  /// The length of the bones along the largest branches, from where limbs part. Joints that go about count
  /// with their OFFSETs.
  void measureSize() {
    bool limbsPart = false;
    for (std::size_t joint = 0; !children_[joint].empty();) {
      const auto isLimb = [&](std::size_t child) { return branchDepths_[child] >= kLimb; };
      if (!limbsPart && std::count_if(children_[joint].begin(), children_[joint].end(), isLimb) > 1) {
        limbsPart = true;
        size_ = 0.0;
      }
      joint = largestBranch(joint);
      const double mean = spreads_[joint].mean.norm();
      const bool goesAbout = spreads_[joint].deviation > kTravels * mean;
      size_ += goesAbout ? hierarchy_.joints[joint].offset.norm() : mean;
    }
  }

  std::size_t largestBranch(std::size_t parent) const {
    return *std::max_element(children_[parent].begin(), children_[parent].end(),
                             [&](std::size_t a, std::size_t b) { return branchSizes_[a] < branchSizes_[b]; });
  }

  /// In a motion that stands still: the first joint that position channels put anywhere, with all others
  /// below.
  std::size_t firstPlaced() const {
    std::size_t joint = 0;
    while (!isPlaced(joint)) {
      if (children_[joint].size() != 1) return 0;
      joint = children_[joint].front();
    }
    return joint;
  }

  bool isPlaced(std::size_t j) const {
    return hasPositionChannels(hierarchy_.joints[j]) && spreads_[j].mean.norm() > kMoves * size_;
  }

  bool moves(std::size_t j, double share) const { return spreads_[j].deviation > share * size_; }

  /// Whether no channel of the joint, or of any below it, ever changes.
  bool branchStandsStill(std::size_t j) const {
    std::vector<std::size_t> open = {j};
    while (!open.empty()) {
      const std::size_t joint = open.back();
      open.pop_back();
      if (!standsStill(hierarchy_.joints[joint], translations_)) return false;
      open.insert(open.end(), children_[joint].begin(), children_[joint].end());
    }
    return true;
  }

  /// The largest branch below `parent`; of those at least half as large, one that travels comes first.
  std::size_t mainBranch(std::size_t parent) const {
    const std::size_t largest = largestBranch(parent);
    std::optional<std::size_t> traveller;
    for (const std::size_t child : children_[parent]) {
      if (2 * branchSizes_[child] < branchSizes_[largest] || !moves(child, kTravels)) continue;
      if (!traveller || branchSizes_[*traveller] < branchSizes_[child]) traveller = child;
    }
    return traveller.value_or(largest);
  }

  /// Whether a branch is no part of the body that its neighbours belong to.
  bool isApart(std::size_t branch, bool parentTravels, bool parentStandsStill) const {
    if (branchDepths_[branch] >= kLimb) return !parentTravels && moves(branch, kTravels);
    if (moves(branch, parentTravels ? kMovesOnItsOwn : kMoves)) return true;
    return parentStandsStill && branchStandsStill(branch);
  }

  /// The child to descend into from `parent`; nothing where the body begins at `parent`.
  std::optional<std::size_t> nextOf(std::size_t parent, bool parentTravels) const {
    if (children_[parent].empty()) return {};
    const std::size_t main = mainBranch(parent);
    if (moves(main, kTravels)) return main;
    const bool parentStandsStill = !parentTravels && standsStill(hierarchy_.joints[parent], translations_);
    for (const std::size_t child : children_[parent]) {
      if (child != main && !isApart(child, parentTravels, parentStandsStill)) return {};
    }
    return main;
  }

  const BvhHierarchy& hierarchy_;
  const JointTranslations& translations_;
  std::vector<std::vector<std::size_t>> children_;  ///< Without end sites.
  std::vector<std::size_t> branchSizes_;            ///< Joints from each on down, without end sites.
  std::vector<std::size_t> branchDepths_;           ///< Longest row of joints from each on down.
  std::vector<JointTranslations::Spread> spreads_;
  double size_ = 0.0;  ///< Of the body, in file units.
};

TravellingRoot takenApartAt(const BvhHierarchy& hierarchy, std::size_t root) {
  TravellingRoot parts{root, {}, {}, {}};
  for (std::optional<std::size_t> j = hierarchy.joints[root].parent; j; j = hierarchy.joints[*j].parent)
    parts.above.push_back(*j);
  std::reverse(parts.above.begin(), parts.above.end());
  std::vector<bool> isBody(hierarchy.joints.size(), false);
  isBody[root] = true;
  for (std::size_t j = 0; j < hierarchy.joints.size(); ++j) {
    const std::optional<std::size_t> parent = hierarchy.joints[j].parent;
    if (parent && isBody[*parent]) isBody[j] = true;
    if (isBody[j]) {
      parts.body.push_back(j);
    } else if (!std::binary_search(parts.above.begin(), parts.above.end(), j)) {
      parts.beside.push_back(j);
    }
  }
  return parts;
}

std::vector<std::string> namesOf(const BvhHierarchy& hierarchy, const std::vector<std::size_t>& joints) {
  std::vector<std::string> names;
  for (const std::size_t j : joints) {
    if (!hierarchy.joints[j].isEndSite) names.push_back(hierarchy.joints[j].name);
  }
  return names;
}

void warnOf(const BvhHierarchy& hierarchy, const JointTranslations& translations, const TravellingRoot& parts,
            Warnings& warnings) {
  if (parts.above.empty()) return;
  const std::string& root = hierarchy.joints[parts.root].name;
  const std::vector<std::string> above = namesOf(hierarchy, parts.above);
  const bool isStill = std::all_of(parts.above.begin(), parts.above.end(), [&](std::size_t j) {
    return standsStill(hierarchy.joints[j], translations);
  });
  const std::string_view verb = above.size() == 1 ? "stands" : "stand";
  warnings.push_back(
      {isStill
           ? fmt::format("joint \"{}\" is taken as the root of the motion: it travels, and {} above it {} "
                         "still",
                         root, quotedNames(above), verb)
           : fmt::format("joint \"{}\" is taken as the root of the motion: it moves against {} above it, and "
                         "both movements together are its path",
                         root, quotedNames(above)),
       {},
       WarningTopic::kTravel});
  const std::vector<std::string> beside = namesOf(hierarchy, parts.beside);
  if (beside.empty()) return;
  warnings.push_back(
      {fmt::format("{} beside \"{}\" {} not part of the body: left out, and still in BVH files "
                   "that are written",
                   quotedNames(beside), root, beside.size() == 1 ? "is" : "are"),
       {},
       WarningTopic::kTravel});
}

}  // namespace

TravellingRoot findTravellingRoot(const BvhHierarchy& hierarchy, const JointTranslations& translations,
                                  Warnings& warnings) {
  TravellingRoot parts = takenApartAt(hierarchy, TravelFinder(hierarchy, translations).find());
  warnOf(hierarchy, translations, parts, warnings);
  return parts;
}

}  // namespace stridegraph
