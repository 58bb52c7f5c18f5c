#pragma once

#include <vector>

#include "render/palette.h"
#include "state/app_state.h"

namespace stridegraph {

enum class MarkKind {
  kDisc = 0,
  kRing = 1,
  kArrow = 2,
  kFootprint = 3,
  kContactShade = 4,
  kOutline = 5,
  kHatch = 6
};

/// A flat mark on the floor (see the mark shader for what `parameter` means to each kind).
struct Mark {
  MarkKind kind = MarkKind::kDisc;
  Vec2 centre = Vec2::Zero();
  Vec2 halfSize = Vec2::Ones();
  Heading heading = {};
  Colour colour;
  double parameter = 0.0;
};

struct Line {
  Vec2 from = Vec2::Zero();
  Vec2 to = Vec2::Zero();
  Colour colour;
  double widthMetres = 0.0;
  double leastPoints = 1.0;  ///< Never thinner than this on screen.
};

/// What lies flat on the floor, in the order of drawing.
struct FloorMarks {
  std::vector<Mark> under;
  std::vector<Line> lines;
  std::vector<Mark> over;
};

/// A foot's stay on the floor.
struct Footprint {
  Vec2 centre = Vec2::Zero();
  Heading heading;
  bool left = false;
  std::size_t firstFrame = 0;
  double lengthMetres = 0.27;
};

/// Feet as the library's contact joints fall into legs: one group of joints (and contact bits) for each foot.
std::vector<std::vector<std::size_t>> feetOf(const MotionLibrary& library);

/// Every stay of every foot during a walk, in order of time for each foot.
std::vector<Footprint> footprintsOf(const MotionLibrary& library, const Plan& plan);

/// Every block where it is at the time on screen: those that stand, then those that move.
std::vector<Rectangle> shownBlocks(const AppState& state);

/// All marks at the time on screen.
FloorMarks marksOf(const AppState& state, const std::vector<Footprint>& footprints);

}  // namespace stridegraph
