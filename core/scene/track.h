#pragma once

#include "scene/scene.h"

namespace stridegraph {

/// Where a moving obstacle's centre is this long after the walk begins, metres. Straight and at an even speed
/// from each point of the track to the next; before the first point's time at the first. From the last
/// point's time on kLoop begins again at the first, kPingPong goes back along the track and forth again, and
/// kOnce stays. The track must have a point, and its times must grow, as checkScene asks.
Vec2 trackPosition(const MovingObstacle& obstacle, double seconds);

/// The part of the floor that the obstacle takes up then.
Rectangle rectangleAt(const MovingObstacle& obstacle, double seconds);

}  // namespace stridegraph
