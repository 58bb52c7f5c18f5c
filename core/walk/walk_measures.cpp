#include "walk/walk_measures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "motion/kinematics.h"

namespace stridegraph {
namespace {

constexpr double kFootHeightMetres = 0.025;

/// A foot joint's level on the floor: what it stays above in all but 2 % of the frames, with linear
/// interpolation between the two nearest ranks.
double floorLevel(std::vector<double> heights) {
  std::sort(heights.begin(), heights.end());
  const double rank = 0.02 * static_cast<double>(heights.size() - 1);
  const auto below = static_cast<std::size_t>(rank);
  const std::size_t above = std::min(below + 1, heights.size() - 1);
  return heights[below] + (rank - static_cast<double>(below)) * (heights[above] - heights[below]);
}

/// Skate of one joint; negative when it is never down.
double skateOf(const std::vector<Vec3>& positions, double framesPerSecond) {
  std::vector<double> heights;
  for (const Vec3& position : positions) heights.push_back(position.y());
  const double floor = floorLevel(heights);
  double sum = 0.0;
  std::size_t down = 0;
  for (std::size_t f = 0; f + 1 < positions.size(); ++f) {
    if (heights[f] - floor >= kFootHeightMetres || heights[f + 1] - floor >= kFootHeightMetres) continue;
    const double height = std::max(0.0, heights[f] - floor);
    const double speed = (onFloor(positions[f + 1]) - onFloor(positions[f])).norm() * framesPerSecond * 100.0;
    sum += speed * (2.0 - std::exp2(height / kFootHeightMetres));
    ++down;
  }
  return down == 0 ? -1.0 : sum / static_cast<double>(down);
}

}  // namespace

double rootPathLength(const Clip& walk) {
  double length = 0.0;
  for (std::size_t f = 1; f < walk.frameCount(); ++f) {
    length += (onFloor(walk.rootPositions[f]) - onFloor(walk.rootPositions[f - 1])).norm();
  }
  return length;
}

double smallestClearance(const FloorPlan& plan, const Clip& walk) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const Vec3& root : walk.rootPositions) smallest = std::min(smallest, plan.clearance(onFloor(root)));
  return smallest;
}

double footSkate(const Skeleton& skeleton, const Clip& walk, std::span<const JointIndex> feet) {
  if (walk.frameCount() < 2) return 0.0;
  std::vector<std::vector<Vec3>> positions(feet.size());
  for (std::size_t f = 0; f < walk.frameCount(); ++f) {
    const std::vector<Vec3> joints = jointPositions(skeleton, walk.pose(f));
    for (std::size_t i = 0; i < feet.size(); ++i) positions[i].push_back(joints[feet[i].value]);
  }
  double sum = 0.0;
  std::size_t touching = 0;
  for (const std::vector<Vec3>& foot : positions) {
    const double skate = skateOf(foot, walk.framesPerSecond);
    if (skate < 0.0) continue;
    sum += skate;
    ++touching;
  }
  return touching == 0 ? 0.0 : sum / static_cast<double>(touching);
}

}  // namespace stridegraph
