#include "state/track_edit.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace stridegraph {

namespace {

constexpr double kShortestLegSeconds = 0.1;
constexpr double kFarthestFirstWayMetres = 3.0;

/// Milliseconds keep drawn scenes short as text and links.
double roundedSeconds(double seconds) {
  return std::round(seconds * 1e3) / 1e3;
}

/// The times of the points after the first, from what each leg takes.
template <typename LegSeconds>
void setLegs(MovingObstacle& obstacle, const LegSeconds& legSeconds) {
  for (std::size_t i = 1; i < obstacle.track.size(); ++i) {
    const double seconds = std::max(legSeconds(i), kShortestLegSeconds);
    obstacle.track[i].seconds = roundedSeconds(obstacle.track[i - 1].seconds + seconds);
  }
}

double legMetres(const MovingObstacle& obstacle, std::size_t leg) {
  return (obstacle.track[leg].position - obstacle.track[leg - 1].position).norm();
}

double legSeconds(const MovingObstacle& obstacle, std::size_t leg) {
  return obstacle.track[leg].seconds - obstacle.track[leg - 1].seconds;
}

}  // namespace

MovingObstacle backAndForth(const Rectangle& block, const Vec2& to, double metresPerSecond) {
  MovingObstacle obstacle;
  obstacle.size = block.size;
  obstacle.repeat = TrackRepeat::kPingPong;
  obstacle.track = {{0.0, block.centre}, {0.0, to}};
  setLegs(obstacle, [&](std::size_t leg) { return legMetres(obstacle, leg) / metresPerSecond; });
  return obstacle;
}

double trackSpeed(const MovingObstacle& obstacle) {
  double metres = 0.0;
  for (std::size_t leg = 1; leg < obstacle.track.size(); ++leg) metres += legMetres(obstacle, leg);
  return metres > 0.0 ? metres / (obstacle.track.back().seconds - obstacle.track.front().seconds) : 0.0;
}

MovingObstacle withTrackSpeed(MovingObstacle obstacle, double metresPerSecond) {
  const double factor = trackSpeed(obstacle) / metresPerSecond;
  if (!(factor > 0.0)) return obstacle;
  const MovingObstacle before = obstacle;
  setLegs(obstacle, [&](std::size_t leg) { return legSeconds(before, leg) * factor; });
  return obstacle;
}

MovingObstacle withTrackPoint(MovingObstacle obstacle, std::size_t point, const Vec2& position) {
  const MovingObstacle before = obstacle;
  obstacle.track[point].position = position;
  setLegs(obstacle, [&](std::size_t leg) {
    const double old = legMetres(before, leg);
    const double share = old > 0.0 ? legMetres(obstacle, leg) / old : 1.0;
    return legSeconds(before, leg) * share;
  });
  return obstacle;
}

MovingObstacle withTrackMoved(MovingObstacle obstacle, const Vec2& by, const Vec2& roomSize) {
  Vec2 low = obstacle.track.front().position, high = low;
  for (const TrackPoint& point : obstacle.track) {
    low = low.cwiseMin(point.position);
    high = high.cwiseMax(point.position);
  }
  const Vec2 allowed = by.cwiseMin(roomSize - high).cwiseMax(-low);
  for (TrackPoint& point : obstacle.track) point.position += allowed;
  return obstacle;
}

Scene withBlockMoving(const Scene& scene, std::size_t block) {
  const Rectangle rectangle = scene.obstacles[block];
  const Vec2 room(scene.widthMetres, scene.depthMetres);
  Vec2 way = Vec2::Zero();
  double most = -1.0;
  for (int axis = 0; axis < 2; ++axis) {
    const double before = rectangle.centre[axis] - rectangle.size[axis] / 2;
    const double behind = room[axis] - rectangle.centre[axis] - rectangle.size[axis] / 2;
    for (const auto& [space, sign] : {std::pair(behind, 1.0), std::pair(before, -1.0)}) {
      if (space <= most) continue;
      most = space;
      way = Vec2::Zero();
      way[axis] = sign * std::clamp(std::floor(space * 10.0) / 10.0, 0.5, kFarthestFirstWayMetres);
    }
  }
  Scene changed = scene;
  changed.obstacles.erase(changed.obstacles.begin() + static_cast<std::ptrdiff_t>(block));
  changed.moving.push_back(backAndForth(rectangle, rectangle.centre + way, kUsualTrackSpeed));
  return changed;
}

Scene withBlockStanding(const Scene& scene, std::size_t moving) {
  const MovingObstacle& obstacle = scene.moving[moving];
  Scene changed = scene;
  changed.obstacles.push_back({obstacle.track.front().position, obstacle.size});
  changed.moving.erase(changed.moving.begin() + static_cast<std::ptrdiff_t>(moving));
  return changed;
}

}  // namespace stridegraph
