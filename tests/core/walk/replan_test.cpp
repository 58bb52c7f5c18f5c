// A walk under way while its room is edited.
#include <gtest/gtest.h>

#include "walk/test_gait_library.h"

namespace stridegraph {
namespace {

constexpr std::size_t kShown = 90;

class Replan : public ::testing::Test {
 protected:
  Replan() {
    scene.widthMetres = 20.0;
    scene.depthMetres = 12.0;
    scene.start = {{2.0, 6.0}, Angle::degrees(90.0)};
    scene.goal = {{18.0, 6.0}, std::nullopt};
    walk = *testing::gaitPlanner().plan(scene);
    EXPECT_EQ(walk.report.status, PlanStatus::kArrived);
  }

  Plan after(std::size_t frame = kShown) const {
    Result<Plan> plan = testing::gaitPlanner().replan(walk, frame, scene);
    EXPECT_TRUE(plan.has_value()) << describe(plan.error());
    return std::move(*plan);
  }

  static double jump(const Clip& a, std::size_t f, const Clip& b, std::size_t g) {
    return (a.rootPositions[f] - b.rootPositions[g]).norm();
  }

  Scene scene;
  Plan walk;
};

TEST_F(Replan, keepsAWalkThatAnEditDoesNotConcern) {
  scene.obstacles.push_back({{10.0, 1.0}, {2.0, 1.0}});
  const Plan plan = after();
  EXPECT_TRUE(plan.kept);
  EXPECT_EQ(plan.walk.frameCount(), walk.walk.frameCount());
  EXPECT_EQ(plan.scene.obstacles.size(), 1U);
}

TEST_F(Replan, keepsNoWalkThatWasPlannedWithOtherOptions) {
  PlanOptions wider;
  wider.radiusMetres = 0.6;
  PlanOptions seeded;
  seeded.seed = 7;
  PlanOptions moving;
  moving.standing = false;
  for (const PlanOptions& options : {wider, seeded, moving}) {
    const Result<Plan> plan = testing::gaitPlanner().replan(walk, kShown, scene, options);
    ASSERT_TRUE(plan.has_value());
    EXPECT_EQ(plan->report.status, PlanStatus::kArrived);
    EXPECT_FALSE(plan->kept);
  }
  PlanOptions longer;
  longer.improvementExpansions = 100;
  const Result<Plan> plan = testing::gaitPlanner().replan(walk, kShown, scene, longer);
  ASSERT_TRUE(plan.has_value());
  EXPECT_TRUE(plan->kept);
}

TEST_F(Replan, bendsTheWalkFromThePresentPoseAroundANewWall) {
  scene.obstacles.push_back({{12.0, 6.0}, {1.0, 4.0}});
  const Plan plan = after();
  ASSERT_EQ(plan.report.status, PlanStatus::kArrived);
  EXPECT_FALSE(plan.kept);
  EXPECT_GE(plan.report.clearanceMetres, -1e-6);
  EXPECT_LE(plan.report.arrivalErrorMetres, 0.02);
  for (std::size_t f = 0; f < kShown; ++f) {
    EXPECT_LT(jump(walk.walk, f, plan.walk, f), 1e-9) << f;
    for (std::size_t j = 0; j < walk.walk.jointCount; ++j)
      EXPECT_TRUE(walk.walk.rotationsOf(f)[j].isApprox(plan.walk.rotationsOf(f)[j], 1e-9));
  }
  // Nothing jumps where the walk turns off.
  for (std::size_t f = 1; f < plan.walk.frameCount(); ++f)
    EXPECT_LT(jump(plan.walk, f - 1, plan.walk, f), 0.12) << f;
}

TEST_F(Replan, takesAShorterWayThatOpensAndKeepsOneThatIsHardlyShorter) {
  scene.obstacles = {{{12.0, 6.0}, {1.0, 8.0}}, {{3.0, 11.5}, {0.5, 0.5}}};
  walk = after();
  ASSERT_EQ(walk.report.status, PlanStatus::kArrived);
  scene.obstacles.pop_back();
  EXPECT_TRUE(after().kept);
  scene.obstacles.clear();
  const Plan shorter = after();
  EXPECT_FALSE(shorter.kept);
  EXPECT_LT(shorter.report.motionLengthMetres, walk.report.motionLengthMetres);
}

TEST_F(Replan, followsAGoalThatIsDragged) {
  for (int i = 1; i <= 5; ++i) {
    scene.goal.position = {18.0, 6.0 + 0.8 * i};
    walk = after();
    ASSERT_EQ(walk.report.status, PlanStatus::kArrived) << i;
    const Vec3& last = walk.walk.rootPositions.back();
    EXPECT_LT((Vec2(last.x(), last.z()) - scene.goal.position).norm(), 0.02) << i;
  }
}

TEST_F(Replan, saysWhyAWalkCannotFollow) {
  scene.obstacles = {{{16.0, 6.0}, {1.0, 12.0}}};
  const Plan plan = after();
  EXPECT_EQ(plan.report.status, PlanStatus::kNoPath);
  EXPECT_FALSE(plan.report.explanation.empty());
}

TEST_F(Replan, cannotTurnOffInItsLastSteps) {
  scene.goal.position = {18.0, 3.0};
  const Plan plan = after(walk.walk.frameCount() - 1);
  EXPECT_EQ(plan.report.status, PlanStatus::kNoMotion);
  EXPECT_NE(plan.report.explanation.find("last steps"), std::string::npos);
}

TEST_F(Replan, refusesASceneWithOtherWalkers) {
  scene.walkers.push_back({scene.start, scene.goal});
  const Result<Plan> plan = testing::gaitPlanner().replan(walk, kShown, scene);
  ASSERT_FALSE(plan.has_value());
  EXPECT_EQ(plan.error().message, "walkers: found 1, expected 0 as in the walk under way");
}

}  // namespace
}  // namespace stridegraph
