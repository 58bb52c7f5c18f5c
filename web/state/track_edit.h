#pragma once

#include "scene/scene.h"

namespace stridegraph {

inline constexpr double kUsualTrackSpeed = 0.8;  ///< Metres per second, of blocks that begin to move.
inline constexpr double kSlowestTrackSpeed = 0.1;
inline constexpr double kFastestTrackSpeed = 3.0;
/// Width and depth of a moving block that is drawn by its way alone.
inline constexpr double kMovingBlockMetres = 1.0;

/// A block that goes from where it stands to a place and back, again and again.
MovingObstacle backAndForth(const Rectangle& block, const Vec2& to, double metresPerSecond);

/// The way along the whole track over its time, metres per second; 0 for a track of one place.
double trackSpeed(const MovingObstacle& obstacle);

/// The same way at another speed; waits along it shrink or grow alike. The first time stays.
MovingObstacle withTrackSpeed(MovingObstacle obstacle, double metresPerSecond);

/// With one point of the track elsewhere; to and from there it goes as fast as before.
MovingObstacle withTrackPoint(MovingObstacle obstacle, std::size_t point, const Vec2& position);

/// With the whole track moved, as far as it stays in a room of this size.
MovingObstacle withTrackMoved(MovingObstacle obstacle, const Vec2& by, const Vec2& roomSize);

/// The scene with a block made to move to where most room is beside it, as the last of Scene::moving.
Scene withBlockMoving(const Scene& scene, std::size_t block);

/// The scene with a moving block made to stand where its track begins, as the last of Scene::obstacles.
Scene withBlockStanding(const Scene& scene, std::size_t moving);

}  // namespace stridegraph
