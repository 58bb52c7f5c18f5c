#include "motion/bvh_texts.h"

#include <algorithm>

#include "motion/kinematics.h"

namespace stridegraph::testing {

double greatestDistance(const BvhDocument& a, const BvhDocument& b) {
  EXPECT_EQ(a.clip.frameCount(), b.clip.frameCount());
  EXPECT_EQ(a.skeleton.size(), b.skeleton.size());
  double greatest = 0.0;
  for (std::size_t f = 0; f < std::min(a.clip.frameCount(), b.clip.frameCount()); ++f) {
    const std::vector<Vec3> first = jointPositions(a.skeleton, a.clip.pose(f));
    const std::vector<Vec3> second = jointPositions(b.skeleton, b.clip.pose(f));
    for (std::size_t j = 0; j < std::min(first.size(), second.size()); ++j) {
      greatest = std::max(greatest, (first[j] - second[j]).norm());
    }
  }
  return greatest;
}

double greatestAngleDegrees(const Clip& a, const Clip& b) {
  EXPECT_EQ(a.rotations.size(), b.rotations.size());
  double greatest = 0.0;
  for (std::size_t i = 0; i < std::min(a.rotations.size(), b.rotations.size()); ++i) {
    greatest = std::max(greatest, angleBetween(a.rotations[i], b.rotations[i]).degrees());
  }
  return greatest;
}

}  // namespace stridegraph::testing
