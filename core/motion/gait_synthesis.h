#pragma once

#include "base/result.h"
#include "motion/clip.h"
#include "motion/gait_track.h"

namespace stridegraph {

/// A walk or jog made from the gait model: joints of gaitSkeleton(), metres, the first frame over the origin
/// and facing +z, feet planted. A body at 0 m/s stands (with both feet down) or, where the turn rate is not
/// 0, turns on the spot with small steps. Mirrored requests (turn rates negated, phases moved by pi) give
/// mirrored clips. Fails with kInvalidArgument as layTrack() does.
Result<Clip> synthesiseGait(const GaitRequest& request);

}  // namespace stridegraph
