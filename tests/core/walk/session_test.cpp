#include "walk/session.h"

#include <gtest/gtest.h>

#include "walk/test_gait_library.h"

namespace stridegraph {
namespace {

constexpr std::size_t kShown = 90;

class Session : public ::testing::Test {
 protected:
  Session() {
    scene.widthMetres = 20.0;
    scene.depthMetres = 12.0;
    scene.start = {{2.0, 6.0}, Angle::degrees(90.0)};
    scene.goal = {{18.0, 6.0}, std::nullopt};
    EXPECT_TRUE(session.plan(scene).has_value());
  }

  WalkSession::Following follow() {
    const Result<WalkSession::Following> done = session.follow(scene, kShown);
    EXPECT_TRUE(done.has_value());
    return *done;
  }

  static double jump(const Clip& a, std::size_t f, const Clip& b, std::size_t g) {
    return (a.rootPositions[f] - b.rootPositions[g]).norm();
  }

  Scene scene;
  WalkSession session{testing::sharedGaitPlanner()};
};

TEST_F(Session, keepsAWalkThatAnEditDoesNotConcern) {
  const std::size_t frames = session.current().walk.frameCount();
  scene.obstacles.push_back({{10.0, 1.0}, {2.0, 1.0}});
  EXPECT_EQ(follow(), WalkSession::Following::kKept);
  EXPECT_EQ(session.current().walk.frameCount(), frames);
}

TEST_F(Session, bendsTheWalkFromThePresentPoseAroundANewWall) {
  const Clip before = session.current().walk;
  scene.obstacles.push_back({{12.0, 6.0}, {1.0, 4.0}});
  ASSERT_EQ(follow(), WalkSession::Following::kBent);
  const Plan& plan = session.current();
  ASSERT_EQ(plan.report.status, PlanStatus::kArrived);
  EXPECT_GE(plan.report.clearanceMetres, -1e-6);
  EXPECT_LE(plan.report.arrivalErrorMetres, 0.02);
  for (std::size_t f = 0; f <= kShown; ++f) {
    EXPECT_LT(jump(before, f, plan.walk, f), 0.01) << f;
    for (std::size_t j = 0; f < kShown && j < before.jointCount; ++j)
      EXPECT_TRUE(before.rotationsOf(f)[j].isApprox(plan.walk.rotationsOf(f)[j], 1e-9));
  }
  // Nothing jumps where the walk turns off.
  for (std::size_t f = 1; f < plan.walk.frameCount(); ++f)
    EXPECT_LT(jump(plan.walk, f - 1, plan.walk, f), 0.12) << f;
}

TEST_F(Session, followsAGoalThatIsDragged) {
  for (int i = 1; i <= 5; ++i) {
    scene.goal.position = {18.0, 6.0 + 0.8 * i};
    ASSERT_EQ(follow(), WalkSession::Following::kBent) << i;
    const Plan& plan = session.current();
    const Vec3& last = plan.walk.rootPositions.back();
    EXPECT_LT((Vec2(last.x(), last.z()) - scene.goal.position).norm(), 0.11) << i;
  }
}

TEST_F(Session, staysAsItWasWhenTheGoalIsWalledInAndSaysWhy) {
  const std::size_t frames = session.current().walk.frameCount();
  scene.obstacles = {{{16.0, 6.0}, {1.0, 12.0}}};
  EXPECT_EQ(follow(), WalkSession::Following::kStuck);
  EXPECT_EQ(session.trouble().status, PlanStatus::kNoPath);
  EXPECT_FALSE(session.trouble().explanation.empty());
  EXPECT_EQ(session.current().walk.frameCount(), frames);
  scene.obstacles.clear();
  EXPECT_NE(follow(), WalkSession::Following::kStuck);
}

TEST_F(Session, cannotTurnOffInItsLastSteps) {
  scene.goal.position = {18.0, 3.0};
  const Result<WalkSession::Following> done = session.follow(scene, session.current().walk.frameCount() - 1);
  ASSERT_TRUE(done.has_value());
  EXPECT_EQ(*done, WalkSession::Following::kStuck);
  EXPECT_NE(session.trouble().explanation.find("last steps"), std::string::npos);
}

}  // namespace
}  // namespace stridegraph
