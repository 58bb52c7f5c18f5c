#include "walk/traffic.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "scene/track.h"

namespace stridegraph {
namespace {

/// Places are worked out in blocks of so many frames.
constexpr std::size_t kBlockFrames = 64;

/// Tracks are followed no farther than this into the future of who stays at a place.
constexpr double kForesightSeconds = 600.0;

}  // namespace

void Traffic::addObstacle(const MovingObstacle& obstacle, std::string name) {
  Mover mover;
  mover.name = std::move(name);
  mover.obstacle = obstacle;
  mover.halfSize = 0.5 * obstacle.size;
  mover.roundMetres = radiusMetres_;
  mover.reachMetres = mover.halfSize.norm() + radiusMetres_;
  for (std::size_t i = 1; i < obstacle.track.size(); ++i) {
    const TrackPoint& before = obstacle.track[i - 1];
    const TrackPoint& point = obstacle.track[i];
    const double frames = (point.seconds - before.seconds) * framesPerSecond_;
    mover.metresPerFrame = std::max(mover.metresPerFrame, (point.position - before.position).norm() / frames);
  }
  if (obstacle.track.size() > 1) {
    // A loop jumps from its last point to its first, in no time.
    if (obstacle.repeat == TrackRepeat::kLoop) {
      mover.metresPerFrame += (obstacle.track.front().position - obstacle.track.back().position).norm();
    }
  }
  movers_.push_back(std::move(mover));
}

void Traffic::addBody(std::span<const Vec2> way, std::uint32_t goneFrom, std::string name) {
  Mover mover;
  mover.name = std::move(name);
  mover.way.assign(way.begin(), way.end());
  mover.goneFrom = goneFrom;
  mover.roundMetres = 2.0 * radiusMetres_;
  mover.reachMetres = mover.roundMetres;
  for (std::size_t f = 1; f < way.size(); ++f)
    mover.metresPerFrame = std::max(mover.metresPerFrame, (way[f] - way[f - 1]).norm());
  movers_.push_back(std::move(mover));
}

Vec2 Traffic::placeOf(Mover& mover, std::uint32_t frame) const {
  if (mover.way.size() <= frame) {
    if (mover.obstacle.track.empty()) return mover.way.back();
    workOut(mover, frame);
  }
  return mover.way[frame];
}

void Traffic::workOut(Mover& mover, std::uint32_t frame) const {
  const std::size_t until = (frame / kBlockFrames + 1) * kBlockFrames;
  for (std::size_t f = mover.way.size(); f < until; ++f)
    mover.way.push_back(trackPosition(mover.obstacle, static_cast<double>(f) / framesPerSecond_));
}

double Traffic::distance(Mover& mover, const Vec2& point, std::uint32_t frame) const {
  if (frame >= mover.goneFrom) return std::numeric_limits<double>::infinity();
  const Vec2 apart = (point - placeOf(mover, frame)).cwiseAbs() - mover.halfSize;
  const double outside = apart.cwiseMax(0.0).norm();
  return (outside > 0.0 ? outside : std::min(apart.maxCoeff(), 0.0)) - mover.roundMetres;
}

double Traffic::clearance(const Vec2& point, std::uint32_t frame) {
  double nearest = std::numeric_limits<double>::infinity();
  for (Mover& mover : movers_) nearest = std::min(nearest, distance(mover, point, frame));
  return nearest;
}

std::string Traffic::nearestName(const Vec2& point, std::uint32_t frame) {
  std::string name = "something that moves";
  double nearest = std::numeric_limits<double>::infinity();
  for (Mover& mover : movers_) {
    const double metres = distance(mover, point, frame);
    if (metres >= nearest) continue;
    nearest = metres;
    name = mover.name;
  }
  return name;
}

bool Traffic::isFree(const FloorTransform& from, std::span<const Eigen::Vector2f> samples,
                     std::uint32_t firstFrame) {
  if (movers_.empty() || samples.empty()) return true;
  // All samples lie around the one in the middle, at most as far as the farthest.
  const std::size_t middle = samples.size() / 2;
  const Vec2 centre = from * Vec2(samples[middle].cast<double>());
  double reach = 0.0;
  for (const Eigen::Vector2f& sample : samples)
    reach = std::max(reach, static_cast<double>((sample - samples[middle]).norm()));
  const auto later = static_cast<std::uint32_t>(samples.size() - middle);
  for (Mover& mover : movers_) {
    const double bound = reach + mover.reachMetres + kMarginMetres + mover.metresPerFrame * later;
    const auto frame = static_cast<std::uint32_t>(firstFrame + middle);
    if ((centre - placeOf(mover, frame)).squaredNorm() > bound * bound) continue;
    for (std::size_t s = 0; s < samples.size(); ++s) {
      const Vec2 point = from * Vec2(samples[s].cast<double>());
      if (distance(mover, point, static_cast<std::uint32_t>(firstFrame + s)) < kMarginMetres) return false;
    }
  }
  return true;
}

bool Traffic::isFree(std::span<const FloorTransform> way, std::uint32_t firstFrame) {
  for (std::size_t f = 0; f < way.size(); ++f) {
    for (Mover& mover : movers_) {
      if (distance(mover, way[f].translation, static_cast<std::uint32_t>(firstFrame + f)) < kMarginMetres)
        return false;
    }
  }
  return true;
}

bool Traffic::staysClearOfBodies(const Vec2& place, std::uint32_t fromFrame, double metres) {
  return std::all_of(movers_.begin(), movers_.end(), [&](Mover& mover) {
    if (!mover.obstacle.track.empty() || mover.goneFrom != kForEver) return true;
    return !nearerThan(metres, mover, place, fromFrame, allSeenAt(mover, fromFrame));
  });
}

std::optional<std::uint32_t> Traffic::touchedFrom(const Vec2& place, std::uint32_t fromFrame) {
  std::optional<std::uint32_t> first;
  for (Mover& mover : movers_) {
    if (mover.obstacle.track.empty()) continue;
    const std::uint32_t until = std::min(allSeenAt(mover, fromFrame), first.value_or(kForEver));
    if (const auto touch = nearerThan(0.0, mover, place, fromFrame, until)) first = touch;
  }
  return first;
}

bool Traffic::isNeverFree(const Vec2& place, double metres, std::uint32_t fromFrame) {
  std::uint32_t until = fromFrame;
  for (const Mover& mover : movers_) until = std::max(until, allSeenAt(mover, fromFrame));
  for (std::uint32_t frame = fromFrame; frame <= until; ++frame)
    if (clearance(place, frame) >= metres) return false;
  return true;
}

/// The frame by which a mover has been everywhere where it will be from a frame on.
std::uint32_t Traffic::allSeenAt(const Mover& mover, std::uint32_t fromFrame) const {
  const std::vector<TrackPoint>& track = mover.obstacle.track;
  if (track.empty()) return std::max(fromFrame, static_cast<std::uint32_t>(mover.way.size()));
  const double period = track.back().seconds - track.front().seconds;
  const double rounds = mover.obstacle.repeat == TrackRepeat::kPingPong ? 2.0 : 1.0;
  const double from = std::max(fromFrame / framesPerSecond_, track.front().seconds);
  const double until = std::min(from + rounds * period, fromFrame / framesPerSecond_ + kForesightSeconds);
  return static_cast<std::uint32_t>(std::ceil(until * framesPerSecond_));
}

/// The first of some frames at which a mover is nearer to a disc that stays; both frames count.
std::optional<std::uint32_t> Traffic::nearerThan(double metres, Mover& mover, const Vec2& place,
                                                 std::uint32_t fromFrame, std::uint32_t untilFrame) const {
  for (std::uint32_t frame = fromFrame; frame <= untilFrame;) {
    const double apart = distance(mover, place, frame) - metres;
    if (apart < 0.0) return frame;
    // It takes so long to come here.
    const double frames = apart / std::max(mover.metresPerFrame, 1e-9);
    if (frames > static_cast<double>(untilFrame - frame)) return std::nullopt;
    frame += std::max<std::uint32_t>(1, static_cast<std::uint32_t>(frames));
  }
  return std::nullopt;
}

}  // namespace stridegraph
