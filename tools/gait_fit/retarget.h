#pragma once

#include <span>
#include <vector>

#include "base/result.h"
#include "motion/clip.h"
#include "motion/gait_table.h"

namespace stridegraph::gait_fit {

/// Clips of any one actor, moved by the gait body, at 30 frames a second and cut where a capture jumps;
/// pieces too short to fit are left out. Clips
/// of the gait body's own skeleton stay as they are. Others are scaled to the length of its legs and brought
/// to its floor; thigh, shin, upper arm and forearm point as the actor's do, while the mean twist of each and
/// the mean bearing of pelvis, trunk, head, hands and feet, which rest axes of files do not tell, are those
/// of the shipped table of `gait`. Fails with kSkeletonMismatch when the skeleton has no legs and arms to
/// tell apart, with kClipTooShort when nobody goes anywhere.
Result<std::vector<Clip>> onGaitBody(const Skeleton& skeleton, std::span<const Clip> clips, Gait gait);

}  // namespace stridegraph::gait_fit
