#pragma once

#include <span>

#include "walk/footprints.h"

namespace stridegraph {

/// Where a stance rests on ball and tip alone, pitches the pinned foot about them so that hip and ankle stay
/// as far from each other as in the clip, whatever the pins and the root's rise (`hipRisesMetres`, for each
/// frame of the clip) would make of it: the knee of a leg that pushes off, often all but straight, is then
/// the clip's. At most about ten degrees; a foot that touches the floor at one joint alone is left alone.
void rollOverToes(const FootTrack& track, const WalkFoot& foot, std::span<const double> hipRisesMetres,
                  PinnedStance& pinned);

}  // namespace stridegraph
