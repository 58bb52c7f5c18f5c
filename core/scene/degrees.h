#pragma once

#include "math/angle.h"

namespace stridegraph {

/// The number of degrees with the fewest digits that Angle::degrees turns into this angle, bit for bit; where
/// there is none, the nearest. 45 rather than 45.00000000000001.
double degreesThatGive(Angle angle);

}  // namespace stridegraph
