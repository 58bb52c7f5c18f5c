#pragma once

#include <span>
#include <vector>

#include "math/floor_transform.h"

namespace stridegraph::figures {

/// How far each step of a root goes across its heading midway in the step, metres, left positive; one fewer
/// than frames. `facingOffset` is the root's heading less the way the body faces.
std::vector<double> sidewaysSteps(std::span<const FloorTransform> track, const Heading& facingOffset = {});

/// How far a blended root slips sideways: what its steps go across its heading beyond what either clip does
/// at that moment, summed. Bodies sway and lean into turns by themselves, which is no slip. Metres; all three
/// tracks have as many frames.
double sidewaysSlip(std::span<const FloorTransform> blended, std::span<const FloorTransform> source,
                    std::span<const FloorTransform> target, const Heading& facingOffset = {});

}  // namespace stridegraph::figures
