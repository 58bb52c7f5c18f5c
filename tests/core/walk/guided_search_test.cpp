#include "walk/guided_search.h"

#include <gtest/gtest.h>

#include <limits>

#include "math/random.h"
#include "walk/search_tables.h"
#include "walk/synthesis.h"
#include "walk/test_library.h"

namespace stridegraph {
namespace {

constexpr std::uint64_t kAll = std::numeric_limits<std::uint64_t>::max();

class GuidedImprovement : public ::testing::Test {
 protected:
  MotionLibrary library = testing::threeArcs();
  SearchTables tables{library};

  /// A room of 12 by 12 m with some blocks between start and goal, others for each seed.
  static FloorPlan roomWithBlocks(std::uint64_t seed) {
    Random random(seed);
    Scene scene;
    for (int block = 0; block < 9; ++block)
      scene.obstacles.push_back({{random.uniform(3.5, 8.5), random.uniform(1.0, 11.0)}, {0.6, 0.6}});
    return FloorPlan(scene, 0.3);
  }

  /// From 1.5 m before one wall to 2 m before the other.
  MotionResult walkThrough(const FloorPlan& plan, std::uint64_t improvement,
                           std::optional<double> enough = {}) const {
    const double middle = 0.5 * plan.depthMetres();
    const std::vector<Vec2> path = {{1.5, middle}, {plan.widthMetres() - 2.0, middle}};
    const WalkConstraints wishes;
    const DistanceField field(plan, path.back());
    MotionQuery query{library, tables, plan, {path.front(), Angle::degrees(90.0)}, {path.back(), {}}};
    query.goalRadiusMetres = 0.4;
    query.path = path;
    query.field = &field;
    query.constraints = &wishes;
    query.improvementExpansions = improvement;
    query.enoughRatio = enough;
    return guidedSearch(query);
  }
};

TEST_F(GuidedImprovement, makesWalksCheaperAndNeverDearer) {
  int better = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const FloorPlan plan = roomWithBlocks(seed);
    const MotionResult first = walkThrough(plan, 0);
    const MotionResult improved = walkThrough(plan, 5000);
    ASSERT_EQ(improved.status, first.status) << seed;
    if (first.status != SearchStatus::kArrived) continue;
    EXPECT_LE(improved.costMetres, first.costMetres) << seed;
    EXPECT_LE(improved.expansions, first.expansions + 5000) << seed;
    if (improved.costMetres < first.costMetres) ++better;
  }
  EXPECT_GE(better, 2);
}

TEST_F(GuidedImprovement, endsWhenNothingIsLeftToLookAt) {
  Scene corridor;
  corridor.widthMetres = 7.0;
  corridor.depthMetres = 1.2;
  const FloorPlan plan(corridor, 0.3);
  const MotionResult enough = walkThrough(plan, 200'000);
  ASSERT_EQ(enough.status, SearchStatus::kArrived);
  EXPECT_LT(enough.expansions, 100'000U);
  EXPECT_EQ(walkThrough(plan, kAll).expansions, enough.expansions);
}

TEST_F(GuidedImprovement, endsWithAWalkThatIsGoodEnough) {
  const FloorPlan plan = roomWithBlocks(1);
  const MotionResult first = walkThrough(plan, 0);
  EXPECT_EQ(walkThrough(plan, 5000, 10.0).expansions, first.expansions);
  EXPECT_GT(walkThrough(plan, 5000, 1.0).expansions, first.expansions);
}

}  // namespace
}  // namespace stridegraph
