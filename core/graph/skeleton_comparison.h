#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "motion/skeleton.h"

namespace stridegraph {

/// How a skeleton that was found differs from the one expected, joint by joint. Joints are matched by name,
/// and those of other names by their place below joints that match.
struct SkeletonDifferences {
  struct Renamed {
    std::string expected;
    std::string found;
  };
  struct OtherParent {
    std::string joint;
    std::string expected;  ///< Name of the parent; empty for a root.
    std::string found;
  };
  struct OtherOffset {
    std::string joint;
    Vec3 expected = Vec3::Zero();  ///< Metres.
    Vec3 found = Vec3::Zero();
  };

  std::vector<std::string> missing;  ///< Expected, and not there.
  std::vector<std::string> added;    ///< There, and not expected.
  std::vector<Renamed> renamed;
  std::vector<OtherParent> parents;
  std::vector<std::string> kinds;    ///< A joint in the one and an end site in the other.
  std::vector<OtherOffset> offsets;  ///< The largest difference first; empty where `scale` tells all.
  /// All bones are so many times as long as expected, to within a hundredth.
  std::optional<double> scale;
  /// The first joint that comes at another place in the file, where nothing else differs.
  std::optional<std::string> outOfOrder;

  bool empty() const;
};

/// Empty exactly when differenceBetween() is.
SkeletonDifferences differencesOf(const Skeleton& expected, const Skeleton& found,
                                  double toleranceMetres = 1e-3);

/// The differences as part of a sentence, such as "lacks LeftToe; LeftLeg 41.2 cm, expected 43.0 cm". Of each
/// kind it names `mostJoints` joints and counts the others. Lengths are in centimetres.
std::string describe(const SkeletonDifferences& differences, std::size_t mostJoints);

}  // namespace stridegraph
