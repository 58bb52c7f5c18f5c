#include "state/commands.h"

#include <gtest/gtest.h>

namespace stridegraph {
namespace {

AppState stateWithBlock() {
  AppState state;
  state.scene.widthMetres = 10.0;
  state.scene.depthMetres = 8.0;
  state.scene.obstacles.push_back({Vec2(5.0, 4.0), Vec2(2.0, 1.0)});
  return state;
}

Scene withWidth(const AppState& state, double widthMetres) {
  Scene scene = state.scene;
  scene.widthMetres = widthMetres;
  return scene;
}

TEST(Commands, undoAndRedoBringBackScenes) {
  AppState state = stateWithBlock();
  apply(state, EditScene{"Widen", withWidth(state, 12.0)});
  apply(state, EditScene{"Widen more", withWidth(state, 14.0)});
  apply(state, Undo{});
  EXPECT_EQ(state.scene.widthMetres, 12.0);
  EXPECT_EQ(state.history.future.back().label, "Widen more");
  apply(state, Undo{});
  EXPECT_EQ(state.scene.widthMetres, 10.0);
  apply(state, Undo{});
  EXPECT_EQ(state.scene.widthMetres, 10.0);
  apply(state, Redo{});
  apply(state, Redo{});
  EXPECT_EQ(state.scene.widthMetres, 14.0);
  EXPECT_TRUE(state.history.future.empty());
}

TEST(Commands, anEditForgetsWhatWasUndone) {
  AppState state = stateWithBlock();
  apply(state, EditScene{"Widen", withWidth(state, 12.0)});
  apply(state, Undo{});
  apply(state, EditScene{"Narrow", withWidth(state, 6.0)});
  apply(state, Redo{});
  EXPECT_EQ(state.scene.widthMetres, 6.0);
}

TEST(Commands, editsWithTheSameKeyAreOneStep) {
  AppState state = stateWithBlock();
  for (const double width : {10.1, 10.2, 10.3}) {
    apply(state, EditScene{"Widen", withWidth(state, width), "one drag"});
  }
  apply(state, EditScene{"Widen", withWidth(state, 11.0), "another drag"});
  EXPECT_EQ(state.history.past.size(), 2u);
  apply(state, Undo{});
  EXPECT_EQ(state.scene.widthMetres, 10.3);
  apply(state, Undo{});
  EXPECT_EQ(state.scene.widthMetres, 10.0);
}

TEST(Commands, deletingChosenBlockCanBeUndone) {
  AppState state = stateWithBlock();
  apply(state, DeleteSelection{});
  EXPECT_EQ(state.scene.obstacles.size(), 1u);
  apply(state, Select{{ItemKind::kObstacle, 0}});
  apply(state, DeleteSelection{});
  EXPECT_TRUE(state.scene.obstacles.empty());
  EXPECT_EQ(state.selection.kind, ItemKind::kNothing);
  apply(state, Undo{});
  EXPECT_EQ(state.scene.obstacles.size(), 1u);
}

TEST(Commands, deletesWhateverMayGo) {
  AppState state = stateWithBlock();
  state.scene.moving.push_back({Vec2::Ones(), TrackRepeat::kLoop, {{0.0, {1.0, 1.0}}}});
  state.scene.walkers.resize(2);
  state.scene.walkers[1].goal.position = {3.0, 3.0};
  state.scene.constraints.areas.resize(1);
  for (const Item& item : {Item{ItemKind::kMoving, 0}, Item{ItemKind::kArea, 0}, Item{ItemKind::kStart, 1}}) {
    apply(state, Select{item});
    apply(state, DeleteSelection{});
  }
  EXPECT_TRUE(state.scene.moving.empty());
  EXPECT_TRUE(state.scene.constraints.areas.empty());
  ASSERT_EQ(state.scene.walkers.size(), 1u);
  EXPECT_EQ(state.scene.walkers[0].goal.position, Vec2(3.0, 3.0));
  EXPECT_EQ(state.history.past.back().label, "Delete walker");
  apply(state, Select{{ItemKind::kGoal, 0}});
  apply(state, DeleteSelection{});
  EXPECT_EQ(state.history.past.size(), 3u) << "the first walker's goal stays";
}

TEST(Commands, undoingAWalkerLetsGoOfIt) {
  AppState state = stateWithBlock();
  Scene scene = state.scene;
  scene.walkers.resize(1);
  apply(state, EditScene{"Draw walker", scene});
  apply(state, Select{{ItemKind::kGoal, 1}});
  apply(state, Undo{});
  EXPECT_EQ(state.selection, Item{});
}

TEST(Commands, everyChangeOfTheSceneWantsAPlan) {
  AppState state = stateWithBlock();
  apply(state, Select{{ItemKind::kStart, 0}});
  EXPECT_FALSE(state.replanning.wanted);
  apply(state, EditScene{"Widen", withWidth(state, 12.0)});
  EXPECT_TRUE(state.replanning.wanted);
  state.replanning.wanted = false;
  apply(state, Undo{});
  EXPECT_TRUE(state.replanning.wanted);
}

TEST(Commands, openingASceneStartsAfresh) {
  AppState state = stateWithBlock();
  state.selection = {ItemKind::kObstacle, 0};
  state.tool = Tool::kBlock;
  state.playback.seconds = 3.0;
  apply(state, OpenScene{"Open", Scene{}});
  EXPECT_EQ(state.selection.kind, ItemKind::kNothing);
  EXPECT_EQ(state.tool, Tool::kSelect);
  EXPECT_EQ(state.playback.seconds, 0.0);
  EXPECT_TRUE(state.playback.playing);
}

TEST(Commands, speedStaysWithinItsRange) {
  AppState state;
  Playback playback;
  playback.speed = 7.0;
  apply(state, ChangePlayback{playback});
  EXPECT_EQ(state.playback.speed, 2.0);
  playback.speed = 0.0;
  apply(state, ChangePlayback{playback});
  EXPECT_EQ(state.playback.speed, 0.1);
}

}  // namespace
}  // namespace stridegraph
