#pragma once

#include <string>

#include "figures/room_view.h"
#include "graph/library.h"
#include "walk/plan.h"

namespace stridegraph::figures {

/// The way of the root, by what the frames are, with a tick that shows where the body faces every half
/// second, and the footprints under it.
void drawWalk(Svg& svg, const RoomView& view, const MotionLibrary& library, const Plan& plan);

/// The colours of drawWalk() and of the planned path.
void drawWalkLegend(Svg& svg, const Vec2& at);

/// What a walk's figures are, in one line: length, time, clearance, transitions.
std::string figuresOf(const Plan& plan);

}  // namespace stridegraph::figures
