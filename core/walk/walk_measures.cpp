#include "walk/walk_measures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "math/percentile.h"
#include "motion/kinematics.h"

namespace stridegraph {
namespace {

constexpr double kFootHeightMetres = 0.025;
constexpr double kRoundingMetres = 1e-9;

/// What all but 2 % of the heights lie above.
double floorLevel(const std::vector<Vec3>& path) {
  std::vector<double> heights;
  for (const Vec3& place : path) heights.push_back(place.y());
  return percentile(std::move(heights), 0.02);
}

/// Skate of one joint; negative when it is never down.
double skateOf(const std::vector<Vec3>& positions, double framesPerSecond) {
  const double floor = floorLevel(positions);
  double sum = 0.0;
  std::size_t down = 0;
  for (std::size_t f = 0; f + 1 < positions.size(); ++f) {
    if (positions[f].y() - floor >= kFootHeightMetres || positions[f + 1].y() - floor >= kFootHeightMetres)
      continue;
    const double height = std::max(0.0, positions[f].y() - floor);
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

double wayLength(std::span<const FloorTransform> way) {
  double length = 0.0;
  for (std::size_t f = 1; f < way.size(); ++f) length += (way[f].translation - way[f - 1].translation).norm();
  return length;
}

double smallestClearance(const FloorPlan& plan, const Clip& walk) {
  double smallest = std::numeric_limits<double>::infinity();
  Vec2 looked = Vec2::Zero();
  double there = 0.0;
  for (const Vec3& root : walk.rootPositions) {
    const Vec2 point = onFloor(root);
    // Clearance changes by no more than the way gone since it was looked at.
    if (there - (point - looked).norm() > smallest + kRoundingMetres) continue;
    looked = point;
    there = plan.clearance(point);
    smallest = std::min(smallest, there);
  }
  return smallest;
}

FootPaths footPaths(const Skeleton& skeleton, const ClipSpan& span, std::span<const JointIndex> feet) {
  const JointChains chains(skeleton, feet);
  std::vector<JointPlacement> joints(chains.size());
  std::vector<std::size_t> slots;
  for (const JointIndex foot : feet) slots.push_back(chains.slotOf(foot));
  FootPaths paths(feet.size(), std::vector<Vec3>(span.last - span.first + 1));
  for (std::size_t f = span.first; f <= span.last; ++f) {
    chains.place(span.clip->pose(f), joints);
    for (std::size_t i = 0; i < feet.size(); ++i) paths[i][f - span.first] = joints[slots[i]].position;
  }
  return paths;
}

std::vector<double> footFloors(const FootPaths& paths) {
  std::vector<double> floors;
  for (const std::vector<Vec3>& path : paths) floors.push_back(floorLevel(path));
  return floors;
}

double footSkate(const FootPaths& paths, double framesPerSecond) {
  double sum = 0.0;
  std::size_t touching = 0;
  for (const std::vector<Vec3>& path : paths) {
    const double skate = skateOf(path, framesPerSecond);
    if (skate < 0.0) continue;
    sum += skate;
    ++touching;
  }
  return touching == 0 ? 0.0 : sum / static_cast<double>(touching);
}

double footPenetration(const FootPaths& paths, std::span<const double> floorsMetres) {
  double deepest = 0.0;
  for (std::size_t k = 0; k < paths.size(); ++k)
    for (const Vec3& place : paths[k]) deepest = std::max(deepest, floorsMetres[k] - place.y());
  return deepest;
}

}  // namespace stridegraph
