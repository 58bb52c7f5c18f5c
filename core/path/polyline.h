#pragma once

#include <span>
#include <vector>

#include "math/types.h"

namespace stridegraph {

/// Length of a path given by its points, metres; 0 for fewer than two points.
double polylineLength(std::span<const Vec2> path);

/// The point at an arc length from the path's beginning, clamped to its ends. The path has at least one
/// point.
Vec2 pointAtLength(std::span<const Vec2> path, double lengthMetres);

/// Points evenly spaced along the path, as near to `spacingMetres` apart as an even division allows (section
/// 5.5 of the thesis): the last is the goal, the start is not among them. One for a path of zero length, none
/// for an empty path. spacingMetres > 0.
std::vector<Vec2> subgoals(std::span<const Vec2> path, double spacingMetres);

/// The path without points that repeat the one before.
std::vector<Vec2> withoutRepeats(std::span<const Vec2> path);

}  // namespace stridegraph
