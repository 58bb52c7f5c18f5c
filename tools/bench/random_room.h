#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "scene/scene.h"

namespace stridegraph::bench {

/// What random rooms are like. Lengths in metres.
struct RandomRoomParams {
  double leastSideMetres = 12.0;  ///< Width and depth are drawn apart, between these.
  double mostSideMetres = 40.0;
  double leastClutter = 0.05;  ///< Share of the floor under rectangles.
  double mostClutter = 0.25;
  std::optional<std::size_t> rectangles;  ///< That many instead of a share of the floor.
  double mostBlockMetres = 3.0;           ///< Sides of blocks, from 0.5.
  double mostWallMetres = 8.0;            ///< Length of walls, from 2; 0 for no walls.
  double radiusMetres = 0.4;              ///< Of the body's disc.
  double spareMetres = 0.25;  ///< That the disc has at start and goal, and along some way between them.
};

/// Room `number` of a seed: a third of its rectangles are walls. Start and goal lie at least half a diagonal
/// apart; the start has a heading, drawn without a look at walls, the goal has none. That a disc with
/// `spareMetres` more can get from one to the other is decided exactly. A layout without such a way is drawn
/// anew, with a little less in it the more often that happens, but never under the least clutter. The same
/// numbers give the same room everywhere.
Scene randomRoom(std::uint64_t seed, std::uint64_t number, const RandomRoomParams& params = {});

/// Share of the room's floor under rectangles, by points 0.1 m apart.
double clutterOf(const Scene& scene);

}  // namespace stridegraph::bench
