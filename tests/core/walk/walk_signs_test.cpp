// Quaternions of walks: one that stands for a turn and its negative are the same rotation, but whoever blends
// neighbouring frames component by component needs the nearer of both.
#include <gtest/gtest.h>

#include "math/random.h"
#include "walk/test_gait_library.h"

namespace stridegraph {
namespace {

void expectContinuousSigns(const Plan& plan) {
  const Clip& walk = plan.walk;
  std::size_t turns = 0;
  for (std::size_t i = walk.jointCount; i < walk.rotations.size(); ++i) {
    const Eigen::Vector4f before = walk.rotations[i - walk.jointCount].coeffs().cast<float>();
    const Eigen::Vector4f after = walk.rotations[i].coeffs().cast<float>();
    if (before.cast<double>().dot(after.cast<double>()) < 0.0) ++turns;
  }
  EXPECT_EQ(turns, 0U);
  for (const Plan& other : plan.others) expectContinuousSigns(other);
}

/// Three walls to be passed in turn: a way that turns past 180 degrees.
Scene slalom() {
  Scene scene;
  scene.widthMetres = 12.0;
  scene.depthMetres = 9.0;
  scene.obstacles = {{{3.15, 3.5}, {0.3, 7.0}}, {{6.15, 5.5}, {0.3, 7.0}}, {{9.15, 3.5}, {0.3, 7.0}}};
  scene.start = {{1.0, 1.0}, Angle::degrees(180.0)};
  scene.goal = {{11.0, 1.0}, Angle::degrees(0.0)};
  return scene;
}

TEST(WalkSigns, doNotTurnOnAWayThatTurnsPastHalfATurn) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    PlanOptions options;
    options.seed = seed;
    const Result<Plan> plan = testing::gaitPlanner().plan(slalom(), options);
    ASSERT_TRUE(plan.has_value());
    ASSERT_EQ(plan->report.status, PlanStatus::kArrived);
    expectContinuousSigns(*plan);
  }
}

TEST(WalkSigns, doNotTurnWhereverAWalkBeginsAndEnds) {
  Random random(11);
  std::size_t arrived = 0;
  for (int sample = 0; sample < 30; ++sample) {
    Scene scene = slalom();
    const auto anywhere = [&] {
      const double column = 3.0 * static_cast<double>(random.below(4));
      return Placement{{column + random.uniform(1.0, 2.2), random.uniform(0.8, 8.2)},
                       Angle::degrees(random.uniform(-180.0, 180.0))};
    };
    scene.start = anywhere();
    scene.goal = anywhere();
    const Result<Plan> plan = testing::gaitPlanner().plan(scene);
    if (!plan || plan->report.status != PlanStatus::kArrived) continue;
    ++arrived;
    expectContinuousSigns(*plan);
  }
  EXPECT_GT(arrived, 15U);
}

TEST(WalkSigns, doNotTurnWhereAWalkIsPlannedAnewOnItsWay) {
  Scene scene = slalom();
  const Result<Plan> walk = testing::gaitPlanner().plan(scene);
  ASSERT_TRUE(walk.has_value());
  for (const std::size_t frame : {30U, 120U, 300U}) {
    scene.goal.position = {10.5, 2.0 + 0.01 * static_cast<double>(frame)};
    const Result<Plan> anew = testing::gaitPlanner().replan(*walk, frame, scene);
    ASSERT_TRUE(anew.has_value());
    expectContinuousSigns(*anew);
    // What was shown goes on being shown.
    for (std::size_t i = 0; i < frame * walk->walk.jointCount && !anew->walk.rotations.empty(); ++i)
      EXPECT_GT(walk->walk.rotations[i].dot(anew->walk.rotations[i]), 0.0);
  }
}

TEST(WalkSigns, doNotTurnForFurtherWalkers) {
  Scene scene;
  scene.widthMetres = 12.0;
  scene.depthMetres = 10.0;
  scene.start = {{2.0, 2.0}, Angle::degrees(-170.0)};
  scene.goal = {{10.0, 2.0}, Angle::degrees(170.0)};
  scene.walkers = {{{{2.0, 8.0}, Angle::degrees(180.0)}, {{10.0, 8.0}, Angle::degrees(-90.0)}}};
  const Result<Plan> plan = testing::gaitPlanner().plan(scene);
  ASSERT_TRUE(plan.has_value());
  ASSERT_EQ(plan->others.size(), 1U);
  EXPECT_EQ(plan->others[0].report.status, PlanStatus::kArrived);
  expectContinuousSigns(*plan);
}

}  // namespace
}  // namespace stridegraph
