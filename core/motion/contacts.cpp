#include "motion/contacts.h"

#include <algorithm>
#include <limits>

#include "base/check.h"
#include "motion/kinematics.h"

namespace stridegraph {
namespace {

using Heights = std::vector<double>;

/// The height that is undercut in 2 % of the frames.
double levelOf(Heights heights) {
  STRIDEGRAPH_CHECK(!heights.empty());
  const auto place = heights.begin() + static_cast<std::ptrdiff_t>((heights.size() - 1) / 50);
  std::nth_element(heights.begin(), place, heights.end());
  return *place;
}

/// For each joint its heights in every frame of the clip.
std::vector<Heights> heightsOf(const Skeleton& skeleton, const Clip& clip) {
  std::vector<Heights> heights(skeleton.size());
  for (std::size_t f = 0; f < clip.frameCount(); ++f) {
    const std::vector<Vec3> positions = jointPositions(skeleton, clip.pose(f));
    for (std::size_t j = 0; j < skeleton.size(); ++j) heights[j].push_back(positions[j].y());
  }
  return heights;
}

/// How far above its clip's lowest joint each joint's level lies, in the clip where that is least.
std::vector<double> heightsAboveFloor(const std::vector<std::vector<Heights>>& clipHeights,
                                      std::size_t jointCount) {
  std::vector<double> least(jointCount, std::numeric_limits<double>::infinity());
  for (const std::vector<Heights>& heights : clipHeights) {
    std::vector<double> levels;
    for (const Heights& ofJoint : heights) levels.push_back(levelOf(ofJoint));
    const double floor = *std::min_element(levels.begin(), levels.end());
    for (std::size_t j = 0; j < jointCount; ++j) least[j] = std::min(least[j], levels[j] - floor);
  }
  return least;
}

/// Takes the lowest joint of every foot in turn until enough are chosen. A foot is a chain of candidates.
std::vector<std::size_t> lowestOfEveryFoot(const Skeleton& skeleton,
                                           const std::vector<std::size_t>& candidates,
                                           const std::vector<double>& height) {
  std::vector<std::vector<std::size_t>> feet;
  std::vector<std::size_t> footOf(skeleton.size(), skeleton.size());
  for (const std::size_t j : candidates) {
    const std::optional<JointIndex>& parent = skeleton.joints[j].parent;
    if (parent && footOf[parent->value] < skeleton.size()) {
      footOf[j] = footOf[parent->value];
    } else {
      footOf[j] = feet.size();
      feet.emplace_back();
    }
    feet[footOf[j]].push_back(j);
  }
  for (std::vector<std::size_t>& foot : feet) {
    std::stable_sort(foot.begin(), foot.end(),
                     [&](std::size_t a, std::size_t b) { return height[a] < height[b]; });
  }
  std::vector<std::size_t> chosen;
  for (std::size_t round = 0; chosen.size() < std::min(candidates.size(), kMaxFootJoints); ++round) {
    for (const std::vector<std::size_t>& foot : feet) {
      if (round < foot.size() && chosen.size() < kMaxFootJoints) chosen.push_back(foot[round]);
    }
  }
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

/// Speed of a point at frame f by central difference, one-sided at the ends.
double speedAt(const std::vector<Vec3>& track, std::size_t f, double framesPerSecond) {
  const std::size_t before = f == 0 ? 0 : f - 1;
  const std::size_t after = std::min(f + 1, track.size() - 1);
  if (after == before) return 0.0;
  return (track[after] - track[before]).norm() * framesPerSecond / static_cast<double>(after - before);
}

}  // namespace

FootJoints findFootJoints(const Skeleton& skeleton, std::span<const Clip> clips,
                          const ContactParams& params) {
  std::vector<std::vector<Heights>> clipHeights;
  for (const Clip& clip : clips) {
    if (clip.frameCount() > 0) clipHeights.push_back(heightsOf(skeleton, clip));
  }
  if (clipHeights.empty()) return {};
  const std::vector<double> height = heightsAboveFloor(clipHeights, skeleton.size());
  std::vector<std::size_t> candidates;
  for (std::size_t j = 0; j < skeleton.size(); ++j) {
    if (height[j] <= params.footReachMetres) candidates.push_back(j);
  }
  FootJoints feet;
  for (const std::size_t j : lowestOfEveryFoot(skeleton, candidates, height)) {
    Heights all;
    for (const std::vector<Heights>& heights : clipHeights)
      all.insert(all.end(), heights[j].begin(), heights[j].end());
    feet.joints.emplace_back(j);
    feet.levelsMetres.push_back(levelOf(std::move(all)));
  }
  return feet;
}

std::vector<std::uint8_t> footContacts(const Skeleton& skeleton, const Clip& clip, const FootJoints& feet,
                                       const ContactParams& params) {
  STRIDEGRAPH_CHECK(feet.joints.size() <= kMaxFootJoints && feet.levelsMetres.size() == feet.joints.size());
  std::vector<std::vector<Vec3>> tracks(feet.joints.size());
  for (std::size_t f = 0; f < clip.frameCount(); ++f) {
    const std::vector<Vec3> positions = jointPositions(skeleton, clip.pose(f));
    for (std::size_t k = 0; k < tracks.size(); ++k) tracks[k].push_back(positions[feet.joints[k].value]);
  }
  std::vector<std::uint8_t> masks(clip.frameCount(), 0);
  for (std::size_t k = 0; k < tracks.size(); ++k) {
    bool planted = false;
    for (std::size_t f = 0; f < masks.size(); ++f) {
      const double height = tracks[k][f].y() - feet.levelsMetres[k];
      const double speed = speedAt(tracks[k], f, clip.framesPerSecond);
      planted = planted ? height <= params.endHeightMetres && speed <= params.endSpeedMetresPerSecond
                        : height <= params.beginHeightMetres && speed <= params.beginSpeedMetresPerSecond;
      if (planted) masks[f] = static_cast<std::uint8_t>(masks[f] | (1U << k));
    }
  }
  return masks;
}

double floorLevelMetres(const Skeleton& skeleton, const Clip& clip, std::span<const JointIndex> feet) {
  STRIDEGRAPH_CHECK(!feet.empty());
  Heights lowest;
  for (std::size_t f = 0; f < clip.frameCount(); ++f) {
    const std::vector<Vec3> positions = jointPositions(skeleton, clip.pose(f));
    double height = std::numeric_limits<double>::infinity();
    for (const JointIndex foot : feet) height = std::min(height, positions[foot.value].y());
    lowest.push_back(height);
  }
  return levelOf(std::move(lowest));
}

}  // namespace stridegraph
