#include "scene/track.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "base/check.h"

namespace stridegraph {

namespace {

/// The time on the track itself, between its first and last point's.
double secondsOnTrack(const MovingObstacle& obstacle, double seconds) {
  const double first = obstacle.track.front().seconds;
  const double last = obstacle.track.back().seconds;
  if (!(seconds > first)) return first;
  if (seconds < last) return seconds;
  const double period = last - first;
  if (obstacle.repeat == TrackRepeat::kOnce || !(period > 0.0)) return last;
  if (obstacle.repeat == TrackRepeat::kLoop) return first + std::fmod(seconds - first, period);
  const double there = std::fmod(seconds - first, 2.0 * period);
  return there > period ? last - (there - period) : first + there;
}

}  // namespace

Vec2 trackPosition(const MovingObstacle& obstacle, double seconds) {
  STRIDEGRAPH_CHECK(!obstacle.track.empty());
  const double time = secondsOnTrack(obstacle, seconds);
  const auto next =
      std::upper_bound(obstacle.track.begin(), obstacle.track.end(), time,
                       [](double value, const TrackPoint& point) { return value < point.seconds; });
  if (next == obstacle.track.begin()) return next->position;
  const TrackPoint& from = *std::prev(next);
  if (next == obstacle.track.end()) return from.position;
  const double share = (time - from.seconds) / (next->seconds - from.seconds);
  return from.position + share * (next->position - from.position);
}

Rectangle rectangleAt(const MovingObstacle& obstacle, double seconds) {
  return {trackPosition(obstacle, seconds), obstacle.size};
}

}  // namespace stridegraph
