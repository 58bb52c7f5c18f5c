#pragma once

#include "motion/bvh_layout.h"
#include "motion/clip.h"

namespace stridegraph {

/// World axes of core from those of a file: nothing for y up, a quarter turn about x for z up.
Vec3 coreFromFile(UpAxis up, const Vec3& vector);
Quat coreFromFile(UpAxis up, const Quat& rotation);
Vec3 fileFromCore(UpAxis up, const Vec3& vector);
Quat fileFromCore(UpAxis up, const Quat& rotation);

/// Turns and scales a skeleton and its clip, read in a file's unit and axes, to metres and y up.
void convertToMetresYUp(UpAxis up, double unitsPerMetre, Skeleton& skeleton, Clip& clip);

}  // namespace stridegraph
