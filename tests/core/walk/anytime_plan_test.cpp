// Plans that get better while there is time.
#include "walk/anytime_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "walk/keeping.h"
#include "walk/test_gait_library.h"

namespace stridegraph {
namespace {

constexpr std::uint64_t kAll = std::numeric_limits<std::uint64_t>::max();

/// A room with a wall to walk round.
Scene roomWithWall() {
  Scene scene;
  scene.widthMetres = 12.0;
  scene.depthMetres = 9.0;
  scene.obstacles = {{{6.0, 2.5}, {0.5, 5.0}}};
  scene.start = {{2.0, 2.0}, Angle::degrees(90.0)};
  scene.goal = {{10.0, 2.0}, std::nullopt};
  return scene;
}

PlanOptions improving(std::uint64_t expansions) {
  PlanOptions options;
  options.improvementExpansions = expansions;
  return options;
}

AnytimePlan begun(const Scene& scene, const PlanOptions& options) {
  Result<AnytimePlan> plan = testing::gaitPlanner().begin(scene, options);
  EXPECT_TRUE(plan.has_value()) << describe(plan.error());
  return std::move(*plan);
}

void expectSame(const Plan& a, const Plan& b) {
  EXPECT_EQ(a.report.status, b.report.status);
  EXPECT_EQ(a.report.edges, b.report.edges);
  EXPECT_EQ(a.report.expansions, b.report.expansions);
  ASSERT_EQ(a.walk.frameCount(), b.walk.frameCount());
  for (std::size_t f = 0; f < a.walk.frameCount(); ++f)
    ASSERT_EQ(a.walk.rootPositions[f], b.walk.rootPositions[f]) << f;
}

TEST(AnytimePlan, givesTheFirstWalkAtOnce) {
  const Scene scene = roomWithWall();
  const AnytimePlan plan = begun(scene, improving(20'000));
  EXPECT_FALSE(plan.isDone());
  EXPECT_EQ(plan.progress(), 0.0);
  expectSame(plan.best(), *testing::gaitPlanner().plan(scene));
}

TEST(AnytimePlan, isDoneWhereNoBetterWalkIsAskedForOrNoneCanBe) {
  const Scene scene = roomWithWall();
  EXPECT_TRUE(begun(scene, {}).isDone());
  PlanOptions easy = improving(20'000);
  easy.enoughRatio = 10.0;
  EXPECT_TRUE(begun(scene, easy).isDone());
  Scene sealed = scene;
  sealed.obstacles = {{{6.0, 4.5}, {0.5, 9.0}}};
  const AnytimePlan none = begun(sealed, improving(20'000));
  EXPECT_TRUE(none.isDone());
  EXPECT_EQ(none.progress(), 1.0);
  EXPECT_EQ(none.best().report.status, PlanStatus::kNoPath);
}

TEST(AnytimePlan, endsInTheSameWalkInWhateverSlices) {
  const Scene scene = roomWithWall();
  const PlanOptions options = improving(12'000);
  const Plan atOnce = *testing::gaitPlanner().plan(scene, options);
  EXPECT_LT(atOnce.report.motionLengthMetres, testing::gaitPlanner().plan(scene)->report.motionLengthMetres);
  for (const std::uint64_t slice : {std::uint64_t{137}, std::uint64_t{5'000}, kAll}) {
    AnytimePlan plan = begun(scene, options);
    double before = 0.0;
    int steps = 0;
    for (; !plan.isDone(); ++steps) {
      plan.step(slice);
      EXPECT_GE(plan.progress(), before);
      before = plan.progress();
    }
    EXPECT_GE(steps, slice == kAll ? 1 : static_cast<int>(12'000 / slice));
    EXPECT_EQ(plan.progress(), 1.0);
    expectSame(plan.best(), atOnce);
  }
}

TEST(AnytimePlan, saysWhenThereIsABetterWalk) {
  AnytimePlan plan = begun(roomWithWall(), improving(12'000));
  int better = 0;
  while (!plan.isDone()) {
    const std::vector<Vec3> before = plan.best().walk.rootPositions;
    const bool changed = plan.step(500);
    EXPECT_EQ(changed, plan.best().walk.rootPositions != before);
    better += changed ? 1 : 0;
  }
  EXPECT_GE(better, 1);
}

TEST(AnytimePlan, stopsWhenItsTimeIsUp) {
  double now = 0.0;
  PlanOptions options = improving(kAll);
  options.budgetMilliseconds = 50.0;
  options.clock = [&now] { return now; };
  AnytimePlan plan = begun(roomWithWall(), options);
  EXPECT_FALSE(plan.isDone());
  now = 1000.0;  // Passed between two slices, which is nothing that the search has spent.
  plan.step(500);
  EXPECT_FALSE(plan.isDone());
  double ticks = 0.0;
  PlanOptions ticking = improving(kAll);
  ticking.budgetMilliseconds = 50.0;
  ticking.clock = [&ticks] { return ticks += 1.0; };
  AnytimePlan timed = begun(roomWithWall(), ticking);
  for (int i = 0; i < 200 && !timed.isDone(); ++i) timed.step(500);
  EXPECT_TRUE(timed.isDone());
}

/// Two walkers who pass each other, and one who crosses their ways.
Scene threeWalkers() {
  Scene scene = roomWithWall();
  scene.walkers = {{{{10.0, 3.0}, Angle::degrees(270.0)}, {{2.0, 3.0}, std::nullopt}},
                   {{{2.0, 7.5}, Angle::degrees(90.0)}, {{10.0, 7.5}, std::nullopt}}};
  return scene;
}

double gapAt(const Plan& a, const Plan& b, std::size_t frame) {
  const auto at = [frame](const Plan& plan) {
    return plan.way[std::min(frame, plan.way.size() - 1)].translation;
  };
  return (at(a) - at(b)).norm() - 0.8;
}

/// The least distance of two walkers' rims.
double leastGap(const Plan& plan) {
  std::vector<const Plan*> all = {&plan};
  for (const Plan& other : plan.others) all.push_back(&other);
  double least = 1e9;
  for (std::size_t a = 0; a < all.size(); ++a)
    for (std::size_t b = a + 1; b < all.size(); ++b)
      for (std::size_t f = 0; f < std::max(all[a]->way.size(), all[b]->way.size()); ++f)
        least = std::min(least, gapAt(*all[a], *all[b], f));
  return least;
}

TEST(AnytimePlan, keepsWalkersApartAllTheWhile) {
  AnytimePlan plan = begun(threeWalkers(), improving(4'000));
  const double before = metresLeft(plan.best(), 0);
  int better = 0;
  for (;;) {
    ASSERT_TRUE(allArrive(plan.best()));
    ASSERT_GT(leastGap(plan.best()), 0.0);
    if (plan.isDone()) break;
    better += plan.step(700) ? 1 : 0;
  }
  EXPECT_GE(better, 1);
  EXPECT_LT(metresLeft(plan.best(), 0), before);
  const Plan atOnce = *testing::gaitPlanner().plan(threeWalkers(), improving(4'000));
  expectSame(plan.best(), atOnce);
  for (std::size_t i = 0; i < atOnce.others.size(); ++i) expectSame(plan.best().others[i], atOnce.others[i]);
}

TEST(AnytimePlan, ofAWalkUnderWayKeepsWhatWasShown) {
  constexpr std::size_t kShown = 60;
  Scene scene = roomWithWall();
  const Plan current = *testing::gaitPlanner().plan(scene);
  scene.goal.position = {10.0, 4.0};
  Result<AnytimePlan> plan = testing::gaitPlanner().beginOnward(current, kShown, scene, improving(6'000));
  ASSERT_TRUE(plan.has_value());
  EXPECT_FALSE(plan->isDone());
  while (!plan->isDone()) plan->step(1'000);
  const Plan& best = plan->best();
  ASSERT_TRUE(allArrive(best));
  for (std::size_t f = 0; f <= kShown; ++f)
    ASSERT_EQ(best.walk.rootPositions[f], current.walk.rootPositions[f]) << f;
  expectSame(best, *testing::gaitPlanner().replan(current, kShown, scene, improving(6'000)));
}

TEST(AnytimePlan, ofAWalkThatStillHoldsIsDone) {
  const Plan current = *testing::gaitPlanner().plan(roomWithWall());
  const Result<AnytimePlan> plan =
      testing::gaitPlanner().beginOnward(current, 60, roomWithWall(), improving(6'000));
  ASSERT_TRUE(plan.has_value());
  EXPECT_TRUE(plan->isDone());
  EXPECT_TRUE(plan->best().kept);
}

}  // namespace
}  // namespace stridegraph
