#include "motion/body_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "motion/odd_skeletons.h"
#include "motion/two_arms.h"

namespace stridegraph {
namespace {

using testing::oddSkeletons;
using testing::twoArms;
using testing::waving;

Vec3 toVec3(const std::array<float, 3>& v) {
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

/// A round cone that hangs on two joints, along a slanted axis.
RoundBody onTwoJoints(const Skeleton& skeleton) {
  RoundBody body;
  body.standing = {{0, 1, 0}, std::vector<Quat>(skeleton.size(), Quat::Identity())};
  body.parts = {
      {{JointIndex(std::size_t{0}), {0.1, 0, 0}, 0.1}, {JointIndex(std::size_t{1}), {0, 0, 0.2}, 0.05}}};
  return body;
}

TEST(BuildBodyMesh, closesTheSurfaceOfEveryPart) {
  const Skeleton skeleton = twoArms();
  for (const RoundBody& body : {roundBody(skeleton, waving(skeleton, 20, 3)), onTwoJoints(skeleton)}) {
    const BodyMesh mesh = buildBodyMesh(skeleton, body);
    ASSERT_FALSE(mesh.indices.empty());
    ASSERT_EQ(mesh.indices.size() % 3, 0U);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (std::size_t i = 0; i < mesh.indices.size(); ++i)
      ++edges[{mesh.indices[i], mesh.indices[i % 3 == 2 ? i - 2 : i + 1]}];
    for (const auto& [edge, count] : edges) {
      EXPECT_EQ(count, 1);
      EXPECT_EQ(edges.count({edge.second, edge.first}), 1U);
    }
  }
}

TEST(BuildBodyMesh, turnsNormalsAndTrianglesOutward) {
  const Skeleton skeleton = twoArms();
  for (const RoundBody& body : {roundBody(skeleton, waving(skeleton, 20, 3)), onTwoJoints(skeleton)}) {
    const BodyMesh mesh = buildBodyMesh(skeleton, body);
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
}

TEST(BuildBodyMesh, liesOnTheRoundConesOfTheStandingBody) {
  const Skeleton skeleton = twoArms();
  const RoundBody body = onTwoJoints(skeleton);
  const Capsule cone = placeParts(body, skeleton, body.standing.view()).front();
  for (const auto& position : buildBodyMesh(skeleton, body).positions) {
    double distance = 1e9;
    for (int i = 0; i <= 1000; ++i) {
      const double share = i / 1000.0;
      const double radius = cone.fromRadius + (cone.toRadius - cone.fromRadius) * share;
      const Vec3 centre = cone.from + (cone.to - cone.from) * share;
      distance = std::min(distance, (toVec3(position) - centre).norm() - radius);
    }
    EXPECT_NEAR(distance, 0.0, 1e-5);
  }
}

TEST(BuildBodyMesh, goesOverFromOneJointToTheOther) {
  const Skeleton skeleton = twoArms();
  const RoundBody body = onTwoJoints(skeleton);
  const BodyMesh mesh = buildBodyMesh(skeleton, body);
  ASSERT_EQ(mesh.carriers.size(), mesh.positions.size());
  EXPECT_EQ(mesh.carriers.front().joints[0], 0);
  EXPECT_EQ(mesh.carriers.back().joints[0], 1);
  std::size_t shared = 0;
  for (const VertexCarriers& each : mesh.carriers) {
    EXPECT_GE(each.secondShare, 0.0);
    EXPECT_LT(each.secondShare, 1.0);
    if (each.secondShare == 0.0) {
      EXPECT_EQ(each.joints[1], 0);
    }
    if (each.secondShare > 0.0) ++shared;
  }
  EXPECT_GT(shared, 0U);
}

TEST(BuildBodyMesh, isThereForAnySkeleton) {
  for (const Skeleton& skeleton : oddSkeletons()) {
    for (const std::size_t frames : {0U, 1U, 40U}) {
      const RoundBody body = roundBody(skeleton, waving(skeleton, frames, 7));
      const BodyMesh mesh = buildBodyMesh(skeleton, body);
      EXPECT_FALSE(mesh.indices.empty());
      for (const auto& position : mesh.positions) EXPECT_TRUE(toVec3(position).allFinite());
      for (const VertexCarriers& each : mesh.carriers) {
        ASSERT_LT(each.joints[0], skeleton.size());
        EXPECT_FALSE(skeleton.joints[each.joints[0]].isEndSite);
        ASSERT_LT(each.joints[1], skeleton.size());
        EXPECT_FALSE(skeleton.joints[each.joints[1]].isEndSite);
      }
    }
  }
}

}  // namespace
}  // namespace stridegraph
