#include "motion/contacts.h"

#include <algorithm>
#include <limits>

#include "base/check.h"
#include "motion/kinematics.h"

namespace stridegraph {
namespace {

/// The value at `share` of the sorted ones; the lower of two.
double quantile(std::vector<double> values, double share) {
  STRIDEGRAPH_CHECK(!values.empty());
  const double place = static_cast<double>(values.size() - 1) * share;
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(place);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// How far above its clip's lowest joint each joint's level lies, in the clip where that is least.
std::vector<double> heightsAboveFloor(std::span<const std::vector<double>> clipLevels,
                                      std::size_t jointCount) {
  std::vector<double> least(jointCount, std::numeric_limits<double>::infinity());
  for (const std::vector<double>& levels : clipLevels) {
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

/// Lowest height of a track within `reach` frames of frame f.
double lowestAround(const std::vector<Vec3>& track, std::size_t f, std::size_t reach) {
  double lowest = track[f].y();
  const std::size_t last = std::min(track.size() - 1, f + reach);
  for (std::size_t g = f - std::min(f, reach); g <= last; ++g) lowest = std::min(lowest, track[g].y());
  return lowest;
}

/// When one foot joint of this level stands.
std::vector<bool> contactsOf(const std::vector<Vec3>& track, double levelMetres, double framesPerSecond,
                             const ContactParams& params) {
  const auto reach = static_cast<std::size_t>(params.strideSeconds * framesPerSecond);
  std::vector<bool> contacts(track.size());
  bool planted = false;
  for (std::size_t f = 0; f < track.size(); ++f) {
    const double floor = std::min(lowestAround(track, f, reach), levelMetres + params.warpMetres);
    const double height = track[f].y() - floor;
    const double speed = speedAt(track, f, framesPerSecond);
    planted = planted ? height <= params.endHeightMetres && speed <= params.endSpeedMetresPerSecond
                      : height <= params.beginHeightMetres && speed <= params.beginSpeedMetresPerSecond;
    contacts[f] = planted;
  }
  return contacts;
}

}  // namespace

std::vector<double> jointLevelsMetres(const Skeleton& skeleton, const Clip& clip) {
  std::vector<std::vector<double>> heights(skeleton.size());
  for (std::size_t f = 0; f < clip.frameCount(); ++f) {
    const std::vector<Vec3> positions = jointPositions(skeleton, clip.pose(f));
    for (std::size_t j = 0; j < skeleton.size(); ++j) heights[j].push_back(positions[j].y());
  }
  std::vector<double> levels;
  for (std::vector<double>& ofJoint : heights) levels.push_back(quantile(std::move(ofJoint), 0.02));
  return levels;
}

FootJoints findFootJoints(const Skeleton& skeleton, std::span<const std::vector<double>> clipLevels,
                          const ContactParams& params) {
  if (clipLevels.empty()) return {};
  const std::vector<double> height = heightsAboveFloor(clipLevels, skeleton.size());
  std::vector<std::size_t> candidates;
  for (std::size_t j = 0; j < skeleton.size(); ++j) {
    if (height[j] <= params.footReachMetres) candidates.push_back(j);
  }
  FootJoints feet;
  for (const std::size_t j : lowestOfEveryFoot(skeleton, candidates, height)) {
    std::vector<double> levels;
    for (const std::vector<double>& ofClip : clipLevels) levels.push_back(ofClip[j]);
    feet.joints.emplace_back(j);
    feet.levelsMetres.push_back(quantile(std::move(levels), 0.5));
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
    const std::vector<bool> contacts =
        contactsOf(tracks[k], feet.levelsMetres[k], clip.framesPerSecond, params);
    for (std::size_t f = 0; f < masks.size(); ++f) {
      if (contacts[f]) masks[f] = static_cast<std::uint8_t>(masks[f] | (1U << k));
    }
  }
  return masks;
}

double floorLevelMetres(const Skeleton& skeleton, const Clip& clip, std::span<const JointIndex> feet) {
  STRIDEGRAPH_CHECK(!feet.empty());
  std::vector<double> lowest;
  for (std::size_t f = 0; f < clip.frameCount(); ++f) {
    const std::vector<Vec3> positions = jointPositions(skeleton, clip.pose(f));
    double height = std::numeric_limits<double>::infinity();
    for (const JointIndex foot : feet) height = std::min(height, positions[foot.value].y());
    lowest.push_back(height);
  }
  return quantile(std::move(lowest), 0.25);
}

}  // namespace stridegraph
