#include "motion/skeleton.h"

#include <gtest/gtest.h>

#include "motion/test_characters.h"

namespace stridegraph {
namespace {

using testing::oneLeg;

TEST(Skeleton, findsJointsByName) {
  EXPECT_EQ(oneLeg().find("ankle"), JointIndex(std::size_t{2}));
  EXPECT_EQ(oneLeg().find("elbow"), std::nullopt);
}

TEST(DifferenceBetween, isEmptyForEqualSkeletonsWithinTheTolerance) {
  Skeleton other = oneLeg();
  other.joints[1].offset.x() += 5e-4;
  EXPECT_EQ(differenceBetween(oneLeg(), other), "");
}

TEST(DifferenceBetween, namesTheJointThatDiffers) {
  Skeleton longer = oneLeg();
  longer.joints[1].offset.y() -= 0.02;
  EXPECT_EQ(differenceBetween(oneLeg(), longer),
            "joint knee is offset 0.0200 m differently (at most 0.0010 m expected)");
  Skeleton renamed = oneLeg();
  renamed.joints[2].name = "foot";
  EXPECT_EQ(differenceBetween(oneLeg(), renamed), "joint 2 is ankle in one and foot in the other");
}

}  // namespace
}  // namespace stridegraph
