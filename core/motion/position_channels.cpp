#include "motion/position_channels.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <tuple>

#include "motion/bvh_channels.h"
#include "motion/quoted_names.h"

namespace stridegraph {
namespace {

/// Lengths below this share of the longest OFFSET are nothing.
constexpr double kNothing = 1e-6;
/// Nearer to a value than this share of a bone is on it.
constexpr double kNear = 0.25;
constexpr std::size_t kFewestEqual = 3;
/// Bones that are OFFSETs times one factor leave no more than this share unexplained.
constexpr double kUnexplained = 0.05;

/// What is known of the position channels of one joint, along the axes that have one.
struct ChannelFacts {
  std::size_t joint = 0;
  Vec3 offset = Vec3::Zero();
  Vec3 first = Vec3::Zero();  ///< In the first row.
  Vec3 mean = Vec3::Zero();
  double farthest = 0.0;   ///< Largest length in any row.
  double deviation = 0.0;  ///< Largest distance from the mean.

  bool isNearOffset() const { return (mean - offset).norm() <= kNear * offset.norm(); }
  bool isNearZero() const { return mean.norm() < kNear * offset.norm(); }
  /// ROOT, and joints that go about, are where they are whatever their OFFSETs.
  bool isBone() const { return joint != 0 && deviation < offset.norm(); }
};

class MeaningJudge {
 public:
  MeaningJudge(const BvhHierarchy& hierarchy, const BvhMotion& motion)
      : hierarchy_(hierarchy), motion_(motion), meanings_(hierarchy.joints.size()) {}

  std::vector<PositionMeaning> judge(Warnings& warnings) {
    for (const BvhJoint& joint : hierarchy_.joints)
      nothing_ = std::max(nothing_, kNothing * joint.offset.norm());
    for (std::size_t j = 0; j < hierarchy_.joints.size(); ++j) {
      if (!hasPositionChannels(hierarchy_.joints[j])) continue;
      const ChannelFacts facts = factsOf(j);
      // Without an OFFSET along its channels a joint has nothing else to hold to.
      if (facts.offset.norm() > nothing_) facts_.push_back(facts);
    }
    judgeZeros(warnings);
    judgeEqualTracks(warnings);
    judgeShifts(warnings);
    return std::move(meanings_);
  }

 private:
  std::span<const double> row(std::size_t frame) const {
    return std::span(motion_.values).subspan(frame * motion_.columns, motion_.columns);
  }

  ChannelFacts factsOf(std::size_t j) const {
    const BvhJoint& joint = hierarchy_.joints[j];
    ChannelFacts facts{j, alongChannels(joint, joint.offset)};
    facts.first = positionIn(joint, row(0));
    for (std::size_t f = 0; f < motion_.frameCount; ++f) {
      const Vec3 position = positionIn(joint, row(f));
      facts.mean += position / static_cast<double>(motion_.frameCount);
      facts.farthest = std::max(facts.farthest, position.norm());
    }
    for (std::size_t f = 0; f < motion_.frameCount; ++f)
      facts.deviation = std::max(facts.deviation, (positionIn(joint, row(f)) - facts.mean).norm());
    return facts;
  }

  /// Gives the joints that `belongs` picks a meaning, takes them off the list and returns their names.
  template <typename Predicate>
  std::vector<std::string> settle(PositionMeaning meaning, Predicate belongs) {
    std::vector<std::string> names;
    std::erase_if(facts_, [&](const ChannelFacts& facts) {
      if (!belongs(facts)) return false;
      meanings_[facts.joint] = meaning;
      names.push_back(hierarchy_.joints[facts.joint].name);
      return true;
    });
    return names;
  }

  void judgeZeros(Warnings& warnings) {
    const std::vector<std::string> names =
        settle(PositionMeaning::kHoldsNothing,
               [&](const ChannelFacts& facts) { return facts.farthest <= nothing_; });
    if (names.empty()) return;
    warnings.push_back(
        {fmt::format("the position channels of {} are 0 in every row: {} in force", quotedNames(names),
                     names.size() == 1 ? "its OFFSET stays" : "their OFFSETs stay"),
         {},
         WarningTopic::kSkeleton});
  }

  bool haveEqualTracks(const ChannelFacts& a, const ChannelFacts& b) const {
    for (std::size_t f = 0; f < motion_.frameCount; ++f) {
      if (positionIn(hierarchy_.joints[a.joint], row(f)) != positionIn(hierarchy_.joints[b.joint], row(f)))
        return false;
    }
    return true;
  }

  /// The joint whose position in the first row the most joints share.
  const ChannelFacts* mostShared() const {
    std::map<std::tuple<double, double, double>, std::size_t> counts;
    const ChannelFacts* most = nullptr;
    std::size_t greatest = 0;
    for (const ChannelFacts& facts : facts_) {
      const std::size_t count = ++counts[{facts.first.x(), facts.first.y(), facts.first.z()}];
      if (count <= greatest) continue;
      greatest = count;
      most = &facts;
    }
    return most;
  }

  void judgeEqualTracks(Warnings& warnings) {
    const ChannelFacts* const most = mostShared();
    if (most == nullptr) return;
    const ChannelFacts shared = *most;
    const auto belongs = [&](const ChannelFacts& facts) {
      return facts.joint != 0 && haveEqualTracks(facts, shared);
    };
    std::size_t equal = 0;
    std::size_t offTheirOffsets = 0;
    for (const ChannelFacts& facts : facts_) {
      if (!belongs(facts)) continue;
      ++equal;
      offTheirOffsets += facts.isNearOffset() ? 0 : 1;
    }
    if (equal < kFewestEqual || 2 * equal < facts_.size() || 4 * offTheirOffsets < 3 * equal) return;
    const std::vector<std::string> names = settle(PositionMeaning::kHoldsNothing, belongs);
    warnings.push_back({fmt::format("the position channels of {} hold the same numbers, which cannot be "
                                    "bones: their OFFSETs stay in force",
                                    quotedNames(names)),
                        {},
                        WarningTopic::kSkeleton});
  }

  /// Whether the positions are the OFFSETs times one factor: a skeleton of another size, which is whole.
  bool isScaledSkeleton() const {
    double products = 0.0;
    double offsets = 0.0;
    double means = 0.0;
    std::size_t joints = 0;
    for (const ChannelFacts& facts : facts_) {
      if (!facts.isBone()) continue;
      ++joints;
      products += facts.mean.dot(facts.offset);
      offsets += facts.offset.squaredNorm();
      means += facts.mean.squaredNorm();
    }
    if (joints < kFewestEqual || products <= 0.0) return false;
    return means - products * products / offsets <= kUnexplained * means;
  }

  void judgeShifts(Warnings& warnings) {
    double nearOffset = 0.0;
    double nearZero = 0.0;
    for (const ChannelFacts& facts : facts_) {
      if (!facts.isBone()) continue;
      if (facts.isNearOffset()) nearOffset += facts.offset.norm();
      if (facts.isNearZero()) nearZero += facts.offset.norm();
    }
    if (nearZero <= nearOffset || isScaledSkeleton()) return;
    const std::vector<std::string> names =
        settle(PositionMeaning::kAddsToOffset,
               [](const ChannelFacts& facts) { return facts.isBone() && !facts.isNearOffset(); });
    warnings.push_back(
        {fmt::format("the positions of {} are near 0, which would leave no bones: they are added to {}",
                     quotedNames(names), names.size() == 1 ? "its OFFSET" : "their OFFSETs"),
         {},
         WarningTopic::kSkeleton});
  }

  const BvhHierarchy& hierarchy_;
  const BvhMotion& motion_;
  std::vector<PositionMeaning> meanings_;
  std::vector<ChannelFacts> facts_;  ///< Of joints that are not judged yet.
  double nothing_ = 1e-12;           ///< In file units.
};

}  // namespace

JointTranslations::JointTranslations(const BvhHierarchy& hierarchy, const BvhMotion& motion,
                                     Warnings& warnings)
    : hierarchy_(hierarchy), motion_(motion), meanings_(MeaningJudge(hierarchy, motion).judge(warnings)) {}

std::span<const double> JointTranslations::row(std::size_t frame) const {
  return std::span(motion_.values).subspan(frame * motion_.columns, motion_.columns);
}

Vec3 JointTranslations::at(std::size_t j, std::size_t frame) const {
  const BvhJoint& joint = hierarchy_.joints[j];
  switch (meanings_[j]) {
    case PositionMeaning::kHoldsNothing:
      return joint.offset;
    case PositionMeaning::kAddsToOffset:
      return joint.offset + positionIn(joint, row(frame));
    case PositionMeaning::kReplacesOffset:
      break;
  }
  return joint.offset - alongChannels(joint, joint.offset) + positionIn(joint, row(frame));
}

JointTranslations::Spread JointTranslations::spreadOf(std::size_t joint) const {
  Spread spread;
  if (!hasPositionChannels(hierarchy_.joints[joint]) || meanings_[joint] == PositionMeaning::kHoldsNothing) {
    spread.mean = hierarchy_.joints[joint].offset;
    return spread;
  }
  const auto count = static_cast<double>(frameCount());
  for (std::size_t f = 0; f < frameCount(); ++f) spread.mean += at(joint, f) / count;
  for (std::size_t f = 0; f < frameCount(); ++f)
    spread.deviation = std::max(spread.deviation, (at(joint, f) - spread.mean).norm());
  return spread;
}

}  // namespace stridegraph
