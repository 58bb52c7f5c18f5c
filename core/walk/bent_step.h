#pragma once

#include "math/floor_transform.h"

namespace stridegraph {

/// A step of the root over the floor, given relative to the placement before it, with a turn added for each
/// metre that it goes. The turn comes first, so that it bends this step too. What does not move does not
/// turn.
inline FloorTransform bentStep(const FloorTransform& step, Angle turnPerMetre) {
  const Heading turn = Heading::fromAngle(turnPerMetre * step.translation.norm());
  return {turn.rotate(step.translation), turn + step.heading};
}

}  // namespace stridegraph
