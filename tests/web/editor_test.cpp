#include "state/editor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <variant>

#include "scene/scene_limits.h"
#include "state/track_edit.h"

namespace stridegraph {
namespace {

/// A room of 10 m by 8 m seen from straight above, with a block in its middle.
class EditorTest : public testing::Test {
 protected:
  EditorTest() {
    state.scene.widthMetres = 10.0;
    state.scene.depthMetres = 8.0;
    state.scene.obstacles.push_back({Vec2(5.0, 4.0), Vec2(2.0, 1.0)});
    state.scene.start.position = Vec2(1.0, 1.0);
    state.scene.goal.position = Vec2(9.0, 7.0);
    const Viewport viewport{1000.0, 800.0};
    view = viewOf(poseAboveRoom(10.0, 8.0, viewport), viewport);
  }

  PointerAt over(double x, double z, double height = 0.0, bool free = false) const {
    return {*view.project({x, height, z}), free, 9.0};
  }

  /// Presses at one place, moves to another, lets go.
  void drag(const PointerAt& from, const PointerAt& to) {
    state.drag = beginDrag(state, view, from);
    ASSERT_TRUE(state.drag);
    moveDrag(*state.drag, view, to);
    const Commands commands = finishDrag(*state.drag);
    state.drag.reset();
    applyAll(state, commands);
  }

  AppState state;
  CameraView view;
};

TEST_F(EditorTest, drawsABlockOnTheGrid) {
  state.tool = Tool::kBlock;
  drag(over(1.03, 4.98), over(2.46, 6.21));
  ASSERT_EQ(state.scene.obstacles.size(), 2u);
  const Rectangle& block = state.scene.obstacles[1];
  EXPECT_NEAR(block.centre.x() - block.size.x() / 2, 1.0, 1e-9);
  EXPECT_NEAR(block.centre.y() + block.size.y() / 2, 6.2, 1e-9);
  EXPECT_NEAR(block.size.x(), 1.5, 1e-9);
  EXPECT_EQ(state.selection, (Item{ItemKind::kObstacle, 1}));
}

TEST_F(EditorTest, drawsFreelyWithoutSnapping) {
  state.tool = Tool::kBlock;
  drag(over(1.034, 5.0, 0.0, true), over(2.467, 6.0, 0.0, true));
  EXPECT_NEAR(state.scene.obstacles.at(1).size.x(), 1.433, 2e-3);
}

TEST_F(EditorTest, keepsDrawnBlocksInsideTheRoom) {
  state.tool = Tool::kBlock;
  drag(over(8.0, 1.0), over(14.0, -3.0));
  const Rectangle& block = state.scene.obstacles.at(1);
  EXPECT_NEAR(block.centre.x() + block.size.x() / 2, 10.0, 1e-9);
  EXPECT_NEAR(block.centre.y() - block.size.y() / 2, 0.0, 1e-9);
}

TEST_F(EditorTest, aClickDrawsNothing) {
  state.tool = Tool::kBlock;
  drag(over(2.0, 5.0), over(2.02, 5.0));
  EXPECT_EQ(state.scene.obstacles.size(), 1u);
  EXPECT_TRUE(state.history.past.empty());
}

TEST_F(EditorTest, movesABlockByWhereItWasGrabbed) {
  drag(over(5.4, 4.2, kBlockHeightMetres), over(6.6, 3.7, kBlockHeightMetres));
  const Rectangle& block = state.scene.obstacles[0];
  EXPECT_NEAR(block.centre.x(), 6.2, 1e-9);
  EXPECT_NEAR(block.centre.y(), 3.5, 1e-9);
  EXPECT_NEAR(block.size.x(), 2.0, 1e-12);
  EXPECT_EQ(state.history.past.size(), 1u);
  EXPECT_EQ(state.history.past[0].label, "Move block");
}

TEST_F(EditorTest, resizesByACornerAndKeepsTheOppositeOne) {
  state.selection = {ItemKind::kObstacle, 0};
  drag(over(6.0, 4.5, kBlockHeightMetres), over(7.0, 6.0, kBlockHeightMetres));
  const Rectangle& block = state.scene.obstacles[0];
  EXPECT_NEAR(block.centre.x() - block.size.x() / 2, 4.0, 1e-9);
  EXPECT_NEAR(block.centre.y() - block.size.y() / 2, 3.5, 1e-9);
  EXPECT_NEAR(block.size.x(), 3.0, 1e-9);
  EXPECT_NEAR(block.size.y(), 2.5, 1e-9);
}

TEST_F(EditorTest, neverResizesThroughTheOppositeSide) {
  state.selection = {ItemKind::kObstacle, 0};
  drag(over(6.0, 4.0, kBlockHeightMetres), over(1.0, 4.0, kBlockHeightMetres));
  EXPECT_NEAR(state.scene.obstacles[0].size.x(), kSmallestBlockMetres, 1e-9);
  EXPECT_NEAR(state.scene.obstacles[0].size.y(), 1.0, 1e-9);
}

TEST_F(EditorTest, movesStartAndKeepsItInside) {
  drag(over(1.0, 1.0), over(-4.0, 2.0));
  EXPECT_NEAR(state.scene.start.position.x(), 0.0, 1e-9);
  EXPECT_NEAR(state.scene.start.position.y(), 2.0, 1e-9);
}

TEST_F(EditorTest, turnsTheHeadingByItsHandle) {
  state.selection = {ItemKind::kStart, 0};
  drag(over(1.0, 1.0 + kHeadingHandleMetres), over(3.0, 1.02));
  ASSERT_TRUE(state.scene.start.heading);
  EXPECT_NEAR(headingDegrees(state.scene.start), 90.0, 1e-9);
}

TEST_F(EditorTest, placesTheGoalFacingTheDrag) {
  state.tool = Tool::kGoal;
  drag(over(7.0, 2.0), over(7.0, 4.0));
  EXPECT_NEAR(state.scene.goal.position.x(), 7.0, 1e-9);
  EXPECT_NEAR(headingDegrees(state.scene.goal), 0.0, 1e-9);
  EXPECT_EQ(state.tool, Tool::kSelect);
}

TEST_F(EditorTest, drawsAMovingBlockByItsWay) {
  state.tool = Tool::kMoving;
  drag(over(2.0, 6.0), over(6.04, 6.0));
  ASSERT_EQ(state.scene.moving.size(), 1u);
  const MovingObstacle& moving = state.scene.moving[0];
  EXPECT_EQ(moving.repeat, TrackRepeat::kPingPong);
  ASSERT_EQ(moving.track.size(), 2u);
  EXPECT_NEAR(moving.track[0].position.x(), 2.0, 1e-9);
  EXPECT_NEAR(moving.track[1].position.x(), 6.0, 1e-9);
  EXPECT_NEAR(moving.track[1].seconds, 5.0, 1e-9);
  EXPECT_EQ(state.selection, (Item{ItemKind::kMoving, 0}));
  EXPECT_EQ(state.tool, Tool::kSelect);
  EXPECT_EQ(state.history.past.back().label, "Draw moving block");
}

TEST_F(EditorTest, takesHoldOfAMovingBlockWhereItIsNow) {
  state.scene.moving.push_back(backAndForth({Vec2(2.0, 6.0), Vec2::Ones()}, Vec2(6.0, 6.0), 0.8));
  EXPECT_EQ(handleUnder(state, view, over(2.0, 6.0)).item, (Item{ItemKind::kMoving, 0}));
  state.playback.seconds = 5.0;
  EXPECT_EQ(handleUnder(state, view, over(6.0, 6.0)).item, (Item{ItemKind::kMoving, 0}));
  EXPECT_EQ(handleUnder(state, view, over(2.0, 6.0)).kind, HandleKind::kNone);
}

TEST_F(EditorTest, movesAWholeTrackAndKeepsItInside) {
  state.scene.moving.push_back(backAndForth({Vec2(2.0, 6.0), Vec2::Ones()}, Vec2(6.0, 6.0), 0.8));
  drag(over(2.0, 6.0), over(9.0, 5.0));
  const std::vector<TrackPoint>& track = state.scene.moving[0].track;
  EXPECT_NEAR(track[0].position.x(), 6.0, 1e-9);
  EXPECT_NEAR(track[1].position.x(), 10.0, 1e-9);
  EXPECT_NEAR(track[1].position.y(), 5.0, 0.11);
}

TEST_F(EditorTest, movesTheEndOfATrackAtTheSameSpeed) {
  state.scene.moving.push_back(backAndForth({Vec2(2.0, 6.0), Vec2::Ones()}, Vec2(6.0, 6.0), 0.8));
  state.selection = {ItemKind::kMoving, 0};
  drag(over(6.0, 6.0), over(4.0, 6.0));
  const MovingObstacle& moving = state.scene.moving[0];
  EXPECT_NEAR(moving.track[1].position.x(), 4.0, 1e-9);
  EXPECT_NEAR(trackSpeed(moving), 0.8, 1e-9);
}

TEST_F(EditorTest, addsAWalkerFromItsStartToItsGoal) {
  state.tool = Tool::kWalker;
  drag(over(1.0, 7.0), over(8.0, 1.52));
  ASSERT_EQ(state.scene.walkers.size(), 1u);
  EXPECT_NEAR(state.scene.walkers[0].start.position.y(), 7.0, 1e-9);
  EXPECT_NEAR(state.scene.walkers[0].goal.position.y(), 1.5, 1e-9);
  EXPECT_EQ(state.selection, (Item{ItemKind::kGoal, 1}));
  EXPECT_EQ(state.history.past.back().label, "Draw walker");
  state.tool = Tool::kSelect;
  drag(over(8.0, 1.5), over(8.0, 2.5));
  EXPECT_NEAR(state.scene.walkers[0].goal.position.y(), 2.5, 1e-9);
}

TEST_F(EditorTest, addsNoMoreWalkersThanAScenesMayHold) {
  state.tool = Tool::kWalker;
  state.scene.walkers.resize(kMostWalkers);
  EXPECT_FALSE(beginDrag(state, view, over(1.0, 7.0)));
}

TEST_F(EditorTest, drawsAnAreaWhichAClickChooses) {
  state.tool = Tool::kArea;
  drag(over(1.0, 5.0), over(3.0, 7.0));
  ASSERT_EQ(state.scene.constraints.areas.size(), 1u);
  EXPECT_EQ(state.scene.constraints.areas[0].kind, AreaKind::kAvoid);
  state.tool = Tool::kSelect;
  const PointerAt within = over(2.0, 6.0);
  EXPECT_EQ(handleUnder(state, view, within).item, (Item{ItemKind::kArea, 0}));
  state.selection = {};
  EXPECT_FALSE(beginDrag(state, view, within)) << "the floor on it turns the view";
  EXPECT_EQ(areaUnder(state, view, within), (Item{ItemKind::kArea, 0}));
  EXPECT_EQ(areaUnder(state, view, over(3.5, 6.0)), Item{});
  state.selection = {ItemKind::kArea, 0};
  drag(over(3.0, 7.0), over(4.0, 7.5));
  EXPECT_NEAR(state.scene.constraints.areas[0].rectangle.size.x(), 3.0, 1e-9);
}

TEST_F(EditorTest, leavesEmptyFloorToTheCamera) {
  EXPECT_FALSE(beginDrag(state, view, over(8.0, 2.0)));
}

TEST_F(EditorTest, nudgesWithinTheRoom) {
  const Scene moved = nudged(state.scene, {ItemKind::kGoal, 0}, Vec2(5.0, 0.1));
  EXPECT_NEAR(moved.goal.position.x(), 10.0, 1e-12);
  EXPECT_NEAR(moved.goal.position.y(), 7.1, 1e-12);
}

}  // namespace
}  // namespace stridegraph
