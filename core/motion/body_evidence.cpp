#include "motion/body_evidence.h"

#include <algorithm>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "math/percentile.h"
#include "motion/kinematics.h"

namespace stridegraph {
namespace {

constexpr std::size_t kMostMeasuredFrames = 101;
constexpr double kLeastSizesPerSecond = 0.15;
constexpr std::size_t kFewestMovingFrames = 5;

Vec3 extentOf(const std::vector<Vec3>& positions) {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::max());
  Vec3 high = -low;
  for (const Vec3& position : positions) {
    low = low.cwiseMin(position);
    high = high.cwiseMax(position);
  }
  return high - low;
}

double medianOf(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

Vec3 medianOf(const std::vector<Vec3>& values) {
  Vec3 median;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    std::vector<double> coordinates;
    coordinates.reserve(values.size());
    for (const Vec3& value : values) coordinates.push_back(value[axis]);
    median[axis] = medianOf(std::move(coordinates));
  }
  return median;
}

Pose restPoseOf(const Skeleton& skeleton) {
  return {Vec3::Zero(), std::vector<Quat>(skeleton.size(), Quat::Identity())};
}

/// Frames spread over a clip, from the first on.
std::vector<std::size_t> measuredFrames(const Clip& clip) {
  const std::size_t count = std::min(clip.frameCount(), kMostMeasuredFrames);
  std::vector<std::size_t> frames;
  for (std::size_t i = 0; i < count; ++i) frames.push_back(i * clip.frameCount() / count);
  return frames;
}

bool holdsAny(std::string_view name, std::initializer_list<std::string_view> words) {
  std::string lower(name);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return std::any_of(words.begin(), words.end(),
                     [&](std::string_view word) { return lower.find(word) != std::string::npos; });
}

/// Joints that are called head or foot.
struct NamedJoints {
  std::vector<std::size_t> heads;
  std::vector<std::size_t> feet;

  explicit NamedJoints(const Skeleton& skeleton) {
    for (std::size_t j = 0; j < skeleton.size(); ++j) {
      if (skeleton.joints[j].isEndSite) continue;
      const std::string& name = skeleton.joints[j].name;
      if (holdsAny(name, {"head"})) heads.push_back(j);
      if (holdsAny(name, {"foot", "ankle", "toe"})) feet.push_back(j);
    }
  }

  bool areKnown() const { return !heads.empty() && !feet.empty(); }

  Vec3 feetToHead(const std::vector<Vec3>& positions) const {
    return meanOf(positions, heads) - meanOf(positions, feet);
  }

 private:
  static Vec3 meanOf(const std::vector<Vec3>& positions, const std::vector<std::size_t>& joints) {
    Vec3 sum = Vec3::Zero();
    for (const std::size_t j : joints) sum += positions[j];
    return sum / static_cast<double>(joints.size());
  }
};

std::size_t lowestAlong(const std::vector<Vec3>& positions, const Vec3& up) {
  const auto isLower = [&](const Vec3& a, const Vec3& b) { return a.dot(up) < b.dot(up); };
  return static_cast<std::size_t>(std::min_element(positions.begin(), positions.end(), isLower) -
                                  positions.begin());
}

/// Gathers what the poses of a clip tell, frame by frame.
class PoseSurvey {
 public:
  PoseSurvey(const Skeleton& skeleton, const Clip& clip)
      : skeleton_(skeleton), clip_(clip), named_(skeleton) {}

  void look(std::size_t frame, double size) {
    const std::vector<Vec3> positions = jointPositions(skeleton_, clip_.pose(frame));
    if (named_.areKnown()) feetToHead_.push_back(named_.feetToHead(positions));
    for (std::size_t d = 0; d < kDirections; ++d) {
      const Vec3 up = directionVector(d);
      levels_[d].push_back(positions[lowestAlong(positions, up)].dot(up));
    }
    if (frame + 1 < clip_.frameCount()) lookAtSteps(frame, positions, size);
  }

  void report(BodyEvidence& evidence) const {
    evidence.hasHead = !named_.heads.empty();
    evidence.hasFeet = !named_.feet.empty();
    if (!feetToHead_.empty()) evidence.feetToHead = medianOf(feetToHead_);
    if (named_.areKnown())
      evidence.feetToHeadAtRest = named_.feetToHead(jointPositions(skeleton_, restPoseOf(skeleton_).view()));
    if (clip_.frameCount() < kFewestMovingFrames) return;
    evidence.rootRange = extentOf(clip_.rootPositions);
    for (std::size_t d = 0; d < kDirections; ++d)
      evidence.levelSpread[d] = percentile(levels_[d], 0.95) - percentile(levels_[d], 0.05);
    if (rootSteps_.size() < kFewestMovingFrames) return;
    evidence.slip.emplace();
    for (std::size_t d = 0; d < kDirections; ++d)
      (*evidence.slip)[d] = medianOf(lowestSteps_[d]) / medianOf(rootSteps_);
  }

 private:
  void lookAtSteps(std::size_t frame, const std::vector<Vec3>& positions, double size) {
    const double rootStep = (clip_.rootPositions[frame + 1] - clip_.rootPositions[frame]).norm();
    if (rootStep * clip_.framesPerSecond <= kLeastSizesPerSecond * size) return;
    const std::vector<Vec3> next = jointPositions(skeleton_, clip_.pose(frame + 1));
    rootSteps_.push_back(rootStep);
    for (std::size_t d = 0; d < kDirections; ++d) {
      const std::size_t lowest = lowestAlong(positions, directionVector(d));
      lowestSteps_[d].push_back((next[lowest] - positions[lowest]).norm());
    }
  }

  const Skeleton& skeleton_;
  const Clip& clip_;
  NamedJoints named_;
  std::vector<Vec3> feetToHead_;
  std::array<std::vector<double>, kDirections> levels_;
  std::array<std::vector<double>, kDirections> lowestSteps_;
  std::vector<double> rootSteps_;
};

}  // namespace

BodyExtents measureExtents(const Skeleton& skeleton, const Clip& clip) {
  BodyExtents extents;
  extents.rest = extentOf(jointPositions(skeleton, restPoseOf(skeleton).view()));
  std::vector<Vec3> posed;
  for (const std::size_t frame : measuredFrames(clip))
    posed.push_back(extentOf(jointPositions(skeleton, clip.pose(frame))));
  if (!posed.empty()) extents.posed = medianOf(posed);
  return extents;
}

Vec3 directionVector(std::size_t direction) {
  Vec3 vector = Vec3::Zero();
  vector[static_cast<Eigen::Index>(direction / 2)] = direction % 2 == 0 ? 1.0 : -1.0;
  return vector;
}

BodyEvidence gatherEvidence(const Skeleton& skeleton, const Clip& clip) {
  BodyEvidence evidence;
  evidence.extents = measureExtents(skeleton, clip);
  evidence.size = std::max(evidence.extents.posed.maxCoeff(), evidence.extents.rest.maxCoeff());
  if (clip.frameCount() == 0) return evidence;
  PoseSurvey survey(skeleton, clip);
  for (const std::size_t frame : measuredFrames(clip)) survey.look(frame, evidence.size);
  survey.report(evidence);
  return evidence;
}

}  // namespace stridegraph
