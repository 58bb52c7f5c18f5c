#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"
#include "motion/bvh_layout.h"
#include "motion/clip.h"

namespace stridegraph {

/// How to understand a file's numbers; what is empty is inferred and reported as a warning where it is odd.
struct BvhReadParams {
  std::optional<double> unitsPerMetre;  ///< 1e-6 to 1e9. Inferred from the skeleton's height.
  std::optional<UpAxis> up;             ///< Inferred from where the body extends.
};

/// A guess of less confidence is doubtful: clients name it or ask about it.
inline constexpr double kDoubtfulConfidence = 0.8;

/// How surely the unit and the up axis of a file were inferred. Both values themselves are in the layout.
struct BvhConfidence {
  double unit = 1.0;  ///< 0..1; 1 when the unit was given.
  double up = 1.0;    ///< 0..1; 1 when the up axis was given.
};

/// A BVH file, understood: metres, y up, rotations as quaternions.
struct BvhDocument {
  Skeleton skeleton;
  BvhLayout layout;
  Clip clip;
  Warnings warnings;
  BvhConfidence confidence = {};
};

/// Reads the bytes of a BVH file as tools really write it: UTF-8, UTF-16 or Windows-1252, any line ends,
/// blanks in names, channels in any order and number, numbers glued by a minus sign, rows wrapped or a few
/// too many (docs/motion-files.md). `name` becomes the clip's name and the file in messages; all strings of
/// the result are UTF-8. Position channels replace a joint's OFFSET; where a joint below the root really
/// moves against its parent, its mean offset is taken, with a warning. Fails with kBvhSyntax or kBvhValue and
/// the place: line and column of what was found, and what was expected; the limits are in
/// motion/bvh_limits.h.
Result<BvhDocument> readBvh(std::string_view bytes, std::string_view name, const BvhReadParams& params = {});

}  // namespace stridegraph
