#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "math/floor_transform.h"
#include "scene/scene.h"

namespace stridegraph {

/// What moves in a room, and where it is when: obstacles with known tracks, and bodies whose walks are known.
/// Times are frames of the walk that is sought, from 0. Answers are worked out when they are asked for and
/// kept, so questions are not const.
class Traffic {
 public:
  /// A body keeps this far from what moves, beyond what touches: between two frames both go on.
  static constexpr double kMarginMetres = 0.03;
  static constexpr std::uint32_t kForEver = std::numeric_limits<std::uint32_t>::max();
  /// When all bodies stay where they are.
  static constexpr std::uint32_t kInTheEnd = kForEver - 1;

  /// radiusMetres: of the disc that asks.
  Traffic(double radiusMetres, double framesPerSecond)
      : radiusMetres_(radiusMetres), framesPerSecond_(framesPerSecond) {}

  /// The name is what people are told: "moving block 2".
  void addObstacle(const MovingObstacle& obstacle, std::string name = "something that moves");
  /// A disc of the same radius that is at way[f] at frame f, stays where the way ends, and is gone from a
  /// frame on. The name is what people are told: "walker 2".
  void addBody(std::span<const Vec2> way, std::uint32_t goneFrom = kForEver,
               std::string name = "another walker");

  bool empty() const { return movers_.empty(); }
  std::size_t size() const { return movers_.size(); }
  /// Distance of the disc's rim at the point to the nearest thing that is there at that frame, metres;
  /// negative when it touches it, infinite when nothing moves.
  double clearance(const Vec2& point, std::uint32_t frame);
  /// The name of what that nearest thing is; "something that moves" where there is none.
  std::string nearestName(const Vec2& point, std::uint32_t frame);
  /// Whether a disc that goes along the samples of a way from a placement touches nothing; sample s is shown
  /// at firstFrame + s.
  bool isFree(const FloorTransform& from, std::span<const Eigen::Vector2f> samples, std::uint32_t firstFrame);
  /// The same for a way in the room.
  bool isFree(std::span<const FloorTransform> way, std::uint32_t firstFrame);
  /// Whether no body whose way is known to its end comes nearer than this to a disc that stays at a place
  /// from a frame on, metres. Obstacles, most of which come again and again, are not asked.
  bool staysClearOfBodies(const Vec2& place, std::uint32_t fromFrame, double metres = kMarginMetres);
  /// The first frame, from one on, at which an obstacle touches a disc that stays at a place; nothing where
  /// none does within once along its track and back, or ten minutes.
  std::optional<std::uint32_t> touchedFrom(const Vec2& place, std::uint32_t fromFrame);
  /// Whether something is nearer to a place than this at every frame from one on, metres.
  bool isNeverFree(const Vec2& place, double metres, std::uint32_t fromFrame);

 private:
  /// A disc, or a rectangle that does not turn.
  struct Mover {
    MovingObstacle obstacle;  ///< Without a track for a body.
    std::vector<Vec2> way;    ///< As far as it is worked out, frame by frame.
    std::uint32_t goneFrom = kForEver;
    std::string name;
    Vec2 halfSize = Vec2::Zero();
    double reachMetres = 0.0;     ///< Nearer than this, and the margin, its middle may touch.
    double roundMetres = 0.0;     ///< Radius of its corners, grown by the one who asks.
    double metresPerFrame = 0.0;  ///< Its greatest speed.
  };

  Vec2 placeOf(Mover& mover, std::uint32_t frame) const;
  void workOut(Mover& mover, std::uint32_t frame) const;
  std::optional<std::uint32_t> nearerThan(double metres, Mover& mover, const Vec2& place,
                                          std::uint32_t fromFrame, std::uint32_t untilFrame) const;
  std::uint32_t allSeenAt(const Mover& mover, std::uint32_t fromFrame) const;
  double distance(Mover& mover, const Vec2& point, std::uint32_t frame) const;

  double radiusMetres_;
  double framesPerSecond_;
  std::vector<Mover> movers_;
};

}  // namespace stridegraph
