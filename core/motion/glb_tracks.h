#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "motion/clip.h"

namespace stridegraph {

/// The numbers of a clip as glTF has them: single precision, finite.

/// Seconds of each frame: from 0 on, each later than the one before.
std::vector<float> keyTimes(const Clip& clip);
/// x, y, z of the root, raised by `liftMetres`, frame by frame, metres.
std::vector<float> rootKeys(const Clip& clip, double liftMetres);
/// x, y, z, w of unit length; no turn for what is none.
std::array<float, 4> rotationKey(const Quat& rotation);
/// rotationKey() of a joint, frame by frame, no two neighbours with a negative dot product.
std::vector<float> rotationKeys(const Clip& clip, std::size_t joint);

/// The number in single precision, 0 for what is not a number, and the largest for what is too large.
float finiteFloat(double value);

}  // namespace stridegraph
