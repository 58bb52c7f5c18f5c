#include "motion/glb_body.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "motion/test_characters.h"
#include "motion/two_arms.h"

namespace stridegraph {
namespace {

using testing::oneLeg;

Vec3 toVec3(const std::array<float, 3>& v) {
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

TEST(BuildBodyMesh, givesEachBoneACapsuleThatItsUpperJointCarries) {
  const BodyMesh mesh = buildBodyMesh(oneLeg());
  std::vector<std::uint16_t> carriers = mesh.joints;
  carriers.erase(std::unique(carriers.begin(), carriers.end()), carriers.end());
  EXPECT_EQ(carriers, (std::vector<std::uint16_t>{0, 1, 2}));
  EXPECT_EQ(mesh.positions.size(), mesh.joints.size());
  EXPECT_EQ(mesh.normals.size(), mesh.joints.size());
}

TEST(BuildBodyMesh, enclosesTheBonesOfTheRestPose) {
  Vec3 low = Vec3::Constant(1e9);
  Vec3 high = -low;
  for (const auto& position : buildBodyMesh(oneLeg()).positions) {
    low = low.cwiseMin(toVec3(position));
    high = high.cwiseMax(toVec3(position));
  }
  // The hip's capsule is 7 cm thick; the foot's, 20 cm long, begins 3.2 and ends 2.4 cm thick.
  EXPECT_NEAR(high.y(), 0.07, 1e-6);
  EXPECT_NEAR(low.y(), -1.0 - 0.75 * 0.07, 1e-6);
  EXPECT_NEAR(high.z(), 0.2 + 0.75 * 0.032, 1e-6);
  EXPECT_NEAR(high.x(), 0.07, 1e-3);
}

TEST(BuildBodyMesh, turnsNormalsAndTrianglesOutward) {
  const BodyMesh mesh = buildBodyMesh(testing::twoArms());
  ASSERT_FALSE(mesh.indices.empty());
  ASSERT_EQ(mesh.indices.size() % 3, 0U);
  for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
    const std::uint32_t a = mesh.indices[t];
    const std::uint32_t b = mesh.indices[t + 1];
    const std::uint32_t c = mesh.indices[t + 2];
    const Vec3 first = toVec3(mesh.positions[b]) - toVec3(mesh.positions[a]);
    const Vec3 second = toVec3(mesh.positions[c]) - toVec3(mesh.positions[a]);
    const Vec3 outward = toVec3(mesh.normals[a]) + toVec3(mesh.normals[b]) + toVec3(mesh.normals[c]);
    EXPECT_GT(first.cross(second).dot(outward), 0.0);
    EXPECT_NEAR(toVec3(mesh.normals[a]).norm(), 1.0, 1e-6);
  }
}

TEST(BuildBodyMesh, putsABallWhereTheSkeletonEndsWithoutABone) {
  Skeleton skeleton = oneLeg();
  skeleton.joints[3].offset = Vec3::Zero();
  const BodyMesh mesh = buildBodyMesh(skeleton);
  EXPECT_EQ(mesh.joints.back(), 2);
  EXPECT_NEAR((toVec3(mesh.positions.back()) - Vec3(0, -1, 0)).norm(), 0.035, 1e-6);
}

}  // namespace
}  // namespace stridegraph
