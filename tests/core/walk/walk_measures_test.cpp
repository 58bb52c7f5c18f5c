#include "walk/walk_measures.h"

#include <gtest/gtest.h>

#include "walk/test_library.h"

namespace stridegraph {
namespace {

/// A stiff body whose foot stays on the floor while it slides 1 cm a frame along x.
Clip slidingBody(const Skeleton& skeleton, double stepMetres) {
  Clip clip;
  clip.jointCount = skeleton.size();
  const std::vector<Quat> rotations(skeleton.size(), Quat::Identity());
  for (int f = 0; f < 60; ++f) clip.append({Vec3(1.0 + stepMetres * f, 1.0, 2.0), rotations});
  return clip;
}

FootPaths pathsOf(const MotionLibrary& library, const Clip& clip) {
  return footPaths(library.skeleton, wholeOf(clip), library.contactJoints);
}

double skateOf(const MotionLibrary& library, const Clip& clip) {
  return footSkate(pathsOf(library, clip), clip.framesPerSecond);
}

TEST(FootSkate, isTheSpeedOfAFootThatStaysDown) {
  const MotionLibrary library = testing::threeArcs();
  EXPECT_NEAR(skateOf(library, slidingBody(library.skeleton, 0.01)), 30.0, 1e-6);
}

TEST(FootSkate, isZeroForAFootThatStands) {
  const MotionLibrary library = testing::threeArcs();
  EXPECT_EQ(skateOf(library, slidingBody(library.skeleton, 0.0)), 0.0);
}

TEST(FootSkate, leavesOutAFootInTheAir) {
  const MotionLibrary library = testing::threeArcs();
  Clip clip = slidingBody(library.skeleton, 0.01);
  for (std::size_t f = 10; f < 60; ++f) clip.rootPositions[f].y() += 0.1;
  for (std::size_t f = 10; f < 60; ++f) clip.rootPositions[f].x() += 5.0;
  EXPECT_NEAR(skateOf(library, clip), 30.0, 1e-6);
}

TEST(FootPenetration, isWhatTheLowestFrameLiesBelowTheFloor) {
  const MotionLibrary library = testing::threeArcs();
  Clip clip = slidingBody(library.skeleton, 0.01);
  const std::vector<double> floors = footFloors(pathsOf(library, clip));
  ASSERT_EQ(floors.size(), 1U);
  EXPECT_NEAR(floors[0], 0.0, 1e-9) << "the foot hangs 1 m below a root that is 1 m up";
  EXPECT_NEAR(footPenetration(pathsOf(library, clip), floors), 0.0, 1e-9);
  clip.rootPositions[7].y() -= 0.03;
  EXPECT_NEAR(footPenetration(pathsOf(library, clip), floors), 0.03, 1e-9);
  clip.rootPositions[7].y() += 0.5;
  EXPECT_NEAR(footPenetration(pathsOf(library, clip), floors), 0.0, 1e-9);
}

TEST(RootPathLength, addsUpStepsOnTheFloor) {
  const MotionLibrary library = testing::threeArcs();
  Clip clip = slidingBody(library.skeleton, 0.02);
  clip.rootPositions[5].y() = 3.0;
  EXPECT_NEAR(rootPathLength(clip), 59 * 0.02, 1e-9);
}

TEST(SmallestClearance, isMeasuredFromTheRimOfTheDisc) {
  Scene scene;
  scene.widthMetres = scene.depthMetres = 20.0;
  scene.obstacles = {{{1.0, 4.0}, {0.5, 2.0}}};
  const MotionLibrary library = testing::threeArcs();
  EXPECT_NEAR(smallestClearance(FloorPlan(scene, 0.4), slidingBody(library.skeleton, 0.0)), 3.0 - 2.0 - 0.4,
              1e-9);
  scene.obstacles[0].centre.y() = 3.2;
  EXPECT_NEAR(smallestClearance(FloorPlan(scene, 0.4), slidingBody(library.skeleton, 0.0)), -0.2, 1e-9);
}

}  // namespace
}  // namespace stridegraph
