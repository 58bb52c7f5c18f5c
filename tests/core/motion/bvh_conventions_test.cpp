#include "motion/bvh_conventions.h"

#include <gtest/gtest.h>

#include "motion/bvh_texts.h"
#include "motion/kinematics.h"

namespace stridegraph {
namespace {

using testing::kBodyText;
using testing::read;
using testing::replaced;
using testing::replacedAll;
using testing::warningsOf;

TEST(ReadBvh, turnsZUpFilesToYUp) {
  // The body lying on its back in a file with z up: y becomes z, z becomes -y.
  std::string text = replacedAll(kBodyText, "0 50 0", "0 0 50");
  text = replaced(text, "0 30 0", "0 0 30");
  text = replaced(text, "0 -90 0", "0 0 -90");
  text = replaced(text, "0 0 20", "0 -20 0");
  text = replaced(text, "0 90 0 10 20 30 40 50 60 70 80 85", "3 4 90 30 0 0 0 0 0 0 0 0");
  text = replaced(text, "1 90 0 10 20 30 40 50 60 70 80 85", "3 4 90 30 0 0 0 0 0 0 0 0");
  const BvhDocument body = read(text);
  EXPECT_EQ(body.layout.up, UpAxis::kZ);
  EXPECT_EQ(warningsOf(body),
            "body.bvh: z is understood as up: the body reaches 170 units along z and 17.32 along y\n");
  EXPECT_TRUE(body.clip.rootPositions[0].isApprox(Vec3(0.03, 0.9, -0.04), 1e-12));
  // A turn about the file's z is a turn about y; the foot points along -y there and along +z here.
  EXPECT_LT(angleBetween(body.clip.rotations[0], axisRotation(Axis::kY, Angle::degrees(30))).degrees(), 1e-6);
  const std::vector<Vec3> positions = jointPositions(body.skeleton, body.clip.pose(0));
  EXPECT_TRUE(positions[1].isApprox(Vec3(0.03, 1.4, -0.04), 1e-9));
  EXPECT_TRUE(positions[4].isApprox(Vec3(0.03 + 0.2 * 0.5, 0.0, -0.04 + 0.2 * std::sqrt(0.75)), 1e-9));
}

TEST(ReadBvh, obeysForcedUnitsAndAxis) {
  BvhReadParams params;
  params.unitsPerMetre = 50.0;
  params.up = UpAxis::kZ;
  const BvhDocument body = read(kBodyText, params);
  EXPECT_EQ(warningsOf(body), "");
  EXPECT_EQ(body.confidence.up, 1.0);
  EXPECT_EQ(body.confidence.unit, 1.0);
  EXPECT_EQ(body.layout.unitsPerMetre, 50.0);
  EXPECT_TRUE(body.skeleton.joints[1].offset.isApprox(Vec3(0, 0, -1.0), 1e-12));
}

TEST(CoreFromFile, undoesFileFromCore) {
  const Vec3 v(1, 2, 3);
  const Quat q(0.1, 0.2, 0.3, 0.4);
  for (const UpAxis up : {UpAxis::kY, UpAxis::kZ}) {
    EXPECT_EQ(coreFromFile(up, fileFromCore(up, v)), v);
    EXPECT_EQ(coreFromFile(up, fileFromCore(up, q)).coeffs(), q.coeffs());
    EXPECT_TRUE((coreFromFile(up, q) * coreFromFile(up, v)).isApprox(coreFromFile(up, q * v), 1e-12));
  }
}

}  // namespace
}  // namespace stridegraph
