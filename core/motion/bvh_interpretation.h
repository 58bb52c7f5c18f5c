#pragma once

#include <string_view>

#include "base/result.h"
#include "motion/bvh_hierarchy.h"
#include "motion/bvh_motion.h"
#include "motion/bvh_reader.h"

namespace stridegraph {

/// What a parsed BVH means: the joint that travels becomes the root (findTravellingRoot) and what stands
/// above it part of the layout, position channels become the root's path or a joint's constant offset
/// (JointTranslations), Euler angles become quaternions, file unit and axes, as given or inferred
/// (inferUpAxis, inferUnit), become metres with y up. `name` becomes the clip's name. Fails with kBvhValue
/// when joints times frames are more than memory should hold (20 million).
Result<BvhDocument> interpretBvh(BvhHierarchy hierarchy, BvhMotion motion, std::string_view name,
                                 const BvhReadParams& params);

}  // namespace stridegraph
