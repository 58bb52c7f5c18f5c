#pragma once

#include "base/error.h"
#include "motion/bvh_layout.h"
#include "motion/clip.h"

namespace stridegraph {

/// How far a body reaches along x, y and z, in whatever unit its skeleton has.
struct BodyExtents {
  Vec3 posed = Vec3::Zero();  ///< Median over frames spread over the clip.
  Vec3 rest = Vec3::Zero();   ///< With all rotations zero.
};
BodyExtents measureExtents(const Skeleton& skeleton, const Clip& clip);

/// Which axis is up: the one along which the posed body reaches further, y or z; where they are about
/// equal (a body that lies or crawls) the rest pose decides. Warns when it is z or cannot be told.
UpAxis inferUpAxis(const BodyExtents& extents, Warnings& warnings);

/// File units in a metre, from the body's height along `up`: metres, CMU units of 5.6444 cm (0.45 of
/// them in an inch), inches, centimetres or millimetres, whichever brings the body nearest to 1.5 m. Warns
/// when it is not centimetres, or the body is not 0.9 to 2.4 m tall even so.
double inferUnitsPerMetre(const BodyExtents& extents, UpAxis up, Warnings& warnings);

/// World axes of core from those of a file: nothing for y up, a quarter turn about x for z up.
Vec3 coreFromFile(UpAxis up, const Vec3& vector);
Quat coreFromFile(UpAxis up, const Quat& rotation);
Vec3 fileFromCore(UpAxis up, const Vec3& vector);
Quat fileFromCore(UpAxis up, const Quat& rotation);

/// Turns and scales a skeleton and its clip, read in a file's unit and axes, to metres and y up.
void convertToMetresYUp(UpAxis up, double unitsPerMetre, Skeleton& skeleton, Clip& clip);

}  // namespace stridegraph
