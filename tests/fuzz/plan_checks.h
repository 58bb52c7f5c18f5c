#pragma once

#include "walk/plan.h"

namespace stridegraph::fuzz {

/// What every plan promises, all walkers of it: a status with a reason; of a walk that arrives finite frames
/// of unit rotations, figures that agree with it, and, of a search that looks at obstacles, a disc that
/// touches nothing that stands. Rotations are as exact as the library's.
void requireSound(const Plan& plan, const Scene& scene, double rotationTolerance = 1e-6);

/// A clock that goes on by a millisecond whenever it is asked, so that a budget ends a search at the same
/// state everywhere.
MillisecondClock countingClock();

}  // namespace stridegraph::fuzz
