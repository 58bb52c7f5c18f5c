#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "motion/skeleton.h"

namespace stridegraph::testing {

inline Joint below(std::size_t parent, std::string name, const Vec3& offset, bool isEndSite = false) {
  return {std::move(name), JointIndex(parent), offset, isEndSite};
}

/// Skeletons that are no bodies, but that files hold.
inline std::vector<Skeleton> oddSkeletons() {
  std::vector<Skeleton> odd;
  odd.push_back({{{"alone", {}, {0, 0, 0}}}});
  odd.push_back({{{"root", {}, {0, 0, 0}}, below(0, "root#end", {0, 1, 0}, true)}});
  odd.push_back({{{"root", {}, {0, 0, 0}}, below(0, "root#end", {0, 0, 0}, true)}});
  odd.push_back({{{"same", {}, {0, 0, 0}},
                  below(0, "same", {0, 0.5, 0}),
                  below(1, "same", {0.2, 0, 0}),
                  below(0, "body", {0, -0.5, 0}),
                  below(3, "", {0, -0.5, 0}),
                  below(4, "\xFF\x01{}", {0, 0, 0.1})}});
  Skeleton still{{{"root", {}, {0, 0, 0}}}};
  for (std::size_t j = 0; j < 10; ++j) still.joints.push_back(below(j, fmt::format("still{}", j), {0, 0, 0}));
  odd.push_back(still);
  Skeleton chain{{{"root", {}, {0, 0, 0}}}};
  for (std::size_t j = 0; j < 300; ++j)
    chain.joints.push_back(below(j, fmt::format("link{}", j), {0, 0.01, 0.002}));
  odd.push_back(chain);
  Skeleton star{{{"root", {}, {0, 0, 0}}}};
  for (std::size_t j = 0; j < 300; ++j) {
    const auto turn = static_cast<double>(j);
    star.joints.push_back(below(0, fmt::format("ray{}", j), {std::sin(turn), std::cos(turn), 0.1}));
  }
  odd.push_back(star);
  Skeleton huge{{{"root", {}, {0, 0, 0}}, below(0, "far", {0, 1e7, 0}), below(1, "farther", {1e7, 0, 0})}};
  odd.push_back(huge);
  return odd;
}

}  // namespace stridegraph::testing
