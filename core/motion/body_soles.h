#pragma once

#include <vector>

#include "motion/body_anatomy.h"
#include "motion/round_body.h"

namespace stridegraph {

/// Behind each ankle the heel, and what joins it to the ankle and to the ball of the foot: as far behind as
/// the body's heel strikes allow. `scale` is 1 for a body 1.75 m tall.
void addHeels(const BodyAnatomy& body, double scale, std::vector<BodyPart>& parts);

/// Makes the ends of the feet's parts as thick as they lie over the floor y = 0 when they are down, so that
/// planted feet touch the floor: between half and twice the radius that they have. Other parts
/// of legs become no thicker.
void fitSoles(const BodyAnatomy& body, std::vector<BodyPart>& parts);

}  // namespace stridegraph
