#include "walk/overlaps.h"

#include <gtest/gtest.h>

namespace stridegraph {
namespace {

std::vector<std::optional<Refusal>> refusalsOf(const Scene& scene, const std::vector<Beginner>& walkers) {
  return Overlaps{scene, 0.4, 0.1}.refusals(walkers);
}

Beginner from(const Vec2& start, const Vec2& goal, bool begins = true) {
  return {{{start, {}}, {goal, {}}}, begins};
}

TEST(Overlaps, namesAllPairsThatStartTooNear) {
  const auto refusals = refusalsOf(
      {}, {from({2, 2}, {9, 1}), from({2.5, 2}, {9, 3}), from({5, 5}, {9, 5}), from({2, 2.8}, {9, 7})});
  ASSERT_TRUE(refusals[0] && refusals[1] && refusals[3]);
  EXPECT_FALSE(refusals[2]);
  EXPECT_EQ(refusals[0]->status, PlanStatus::kStartBlocked);
  EXPECT_EQ(refusals[0]->explanation,
            "walkers 1 and 2 start 0.50 m apart, and bodies of radius 0.40 m need 0.83 m; "
            "walkers 1 and 4 start 0.80 m apart, and bodies of radius 0.40 m need 0.83 m");
  EXPECT_EQ(refusals[1]->explanation,
            "walkers 1 and 2 start 0.50 m apart, and bodies of radius 0.40 m need 0.83 m");
}

TEST(Overlaps, doesNotAskWhereWalkersUnderWayOnceStarted) {
  const auto refusals = refusalsOf({}, {from({2, 2}, {9, 1}, false), from({2.5, 2}, {9, 3})});
  EXPECT_FALSE(refusals[0] || refusals[1]);
}

TEST(Overlaps, letsTheFirstOfThoseWithOneGoalGo) {
  const auto refusals =
      refusalsOf({}, {from({1, 1}, {9, 1}), from({1, 3}, {9, 1.4}), from({1, 5}, {9, 1.8})});
  EXPECT_FALSE(refusals[0]);
  ASSERT_TRUE(refusals[1]);
  EXPECT_EQ(refusals[1]->status, PlanStatus::kGoalBlocked);
  EXPECT_EQ(refusals[1]->explanation,
            "the goals of walkers 1 and 2 are 0.40 m apart, and bodies of radius 0.40 m need 0.83 m: "
            "walker 1 stays there");
  EXPECT_FALSE(refusals[2]) << "0.80 m from the first goal can be kept within the goal radius";
}

TEST(Overlaps, takesNoNoticeOfTheGoalOfWhoDoesNotGo) {
  const auto refusals = refusalsOf({}, {from({1, 1}, {9, 1}), from({1.2, 1}, {9, 9}), from({1, 5}, {9, 1})});
  EXPECT_TRUE(refusals[0] && refusals[1]);
  EXPECT_FALSE(refusals[2]);
}

TEST(Overlaps, refusesWhoseGoalIsWhereAnotherStays) {
  const auto refusals = refusalsOf({}, {from({1, 1}, {9, 1}), from({9, 1.3}, {9, 1.2})});
  ASSERT_TRUE(refusals[0]);
  EXPECT_FALSE(refusals[1]);
  EXPECT_EQ(refusals[0]->status, PlanStatus::kGoalBlocked);
  EXPECT_EQ(refusals[0]->explanation,
            "the goals of walkers 1 and 2 are 0.20 m apart, and bodies of radius 0.40 m need 0.83 m: "
            "walker 2 stays there");
}

TEST(Overlaps, namesTheMovingBlockAtAStart) {
  Scene scene;
  scene.moving = {{{1, 1}, TrackRepeat::kLoop, {{0.0, {8, 8}}}},
                  {{1, 1}, TrackRepeat::kOnce, {{0.0, {1, 3.8}}, {1.0, {1, 9}}}}};
  const auto refusals = refusalsOf(scene, {from({1, 1}, {9, 1}), from({1, 3}, {9, 3})});
  EXPECT_FALSE(refusals[0]);
  ASSERT_TRUE(refusals[1]);
  EXPECT_EQ(refusals[1]->status, PlanStatus::kStartBlocked);
  EXPECT_EQ(refusals[1]->explanation,
            "moving block 2 is at the start of walker 2 when the walk begins: it reaches 0.10 m into the "
            "body's disc of radius 0.40 m");
}

}  // namespace
}  // namespace stridegraph
