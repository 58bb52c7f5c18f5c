#include "state/playback.h"
#include "walk/keeping.h"

#include <gtest/gtest.h>

namespace stridegraph {
namespace {

/// A walk along x at 1 m/s by a body of one joint, at 10 frames a second.
Plan planOf(std::size_t frames) {
  Plan plan;
  plan.report.status = frames > 0 ? PlanStatus::kArrived : PlanStatus::kNoPath;
  plan.report.explanation = frames > 0 ? "" : "a wall is in the way";
  plan.walk.framesPerSecond = 10.0;
  plan.walk.jointCount = 1;
  for (std::size_t i = 0; i < frames; ++i) {
    plan.walk.rootPositions.emplace_back(0.1 * static_cast<double>(i), 1.0, 0.0);
    plan.walk.rotations.push_back(Quat::Identity());
  }
  return plan;
}

AppState stateWithTwo(std::size_t firstFrames, std::size_t secondFrames) {
  AppState state;
  state.library = std::make_shared<const MotionLibrary>();
  state.scene.walkers.resize(1);
  state.plan = planOf(firstFrames);
  state.plan->others.push_back(planOf(secondFrames));
  return state;
}

TEST(Playback, lastsUntilTheLastWalkerIsThere) {
  AppState state = stateWithTwo(11, 31);
  EXPECT_DOUBLE_EQ(state.walkSeconds(), 3.0);
  state.playback.seconds = 2.0;
  EXPECT_NEAR(shownPose(state, 0)->rootPosition.x(), 1.0, 1e-12) << "the first stands at its end";
  EXPECT_NEAR(shownPose(state, 1)->rootPosition.x(), 2.0, 1e-12);
  EXPECT_FALSE(shownPose(state, 2));
}

TEST(Playback, runsThoughTheFirstWalkerHasNoWalk) {
  AppState state = stateWithTwo(0, 31);
  state.playback.playing = true;
  EXPECT_TRUE(state.canPlay());
  EXPECT_TRUE(advance(state, 0.5));
  EXPECT_DOUBLE_EQ(state.shownSeconds(), 0.5);
}

TEST(Playback, keepsItsTimeWhileThereIsNoWalk) {
  AppState state = stateWithTwo(11, 31);
  state.playback.seconds = 2.0;
  state.plan.reset();
  EXPECT_DOUBLE_EQ(state.shownSeconds(), 2.0);
  state.plan = planOf(11);
  EXPECT_DOUBLE_EQ(state.shownSeconds(), 1.0);
}

TEST(Playback, saysWhoDoesNotArrive) {
  EXPECT_EQ(statusSentence(stateWithTwo(11, 31)), "All 2 walkers arrive, the last after 3.0 s.");
  EXPECT_EQ(statusSentence(stateWithTwo(11, 0)), "Walker 2: A wall is in the way.");
  EXPECT_FALSE(allArrive(*stateWithTwo(11, 0).plan));
  EXPECT_TRUE(allArrive(*stateWithTwo(11, 31).plan));
}

TEST(Playback, saysWhatAWalkThatArrivesLeavesToBeWishedFor) {
  AppState state = stateWithTwo(11, 31);
  state.plan->others[0].report.explanation =
      "it can stand there until 9.0 s, when something that moves comes by";
  EXPECT_EQ(
      statusSentence(state),
      "All 2 walkers arrive, the last after 3.0 s. Walker 2: It can stand there until 9.0 s, when something "
      "that moves comes by.");
}

}  // namespace
}  // namespace stridegraph
