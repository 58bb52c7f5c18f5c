#pragma once

#include "motion/mirror_map.h"

namespace stridegraph {

/// The reflection of a vector or rotation in the world's plane x = 0.
Vec3 mirrored(const Vec3& vector);
Quat mirrored(const Quat& rotation);

/// The clip as seen in a mirror, danced by the same skeleton: left and right change places and every joint
/// lies where its partner's reflection in the plane x = 0 lies, exactly for symmetric skeletons, else as near
/// as bones of different lengths allow. `map` must be of this skeleton.
Clip mirrored(const Skeleton& skeleton, const MirrorMap& map, const Clip& clip);

}  // namespace stridegraph
