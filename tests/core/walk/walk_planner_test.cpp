#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "walk/test_library.h"
#include "walk/walk_planner.h"

namespace stridegraph {
namespace {

std::shared_ptr<const MotionLibrary> sharedLibrary() {
  static const auto library = std::make_shared<const MotionLibrary>(testing::threeArcs());
  return library;
}

/// An open room of 12 by 12 m, to be crossed.
Scene openRoom() {
  Scene scene;
  scene.start = {{2, 6}, Angle::degrees(90)};
  scene.goal = {{9, 6}, {}};
  return scene;
}

/// The same with a wall across that leaves a gap of 2 m.
Scene roomWithGap() {
  Scene scene = openRoom();
  scene.obstacles = {{{6, 5}, {0.4, 10}}};
  return scene;
}

Plan planOf(const Scene& scene, const PlanOptions& options = {}) {
  Result<Plan> plan = WalkPlanner(sharedLibrary()).plan(scene, options);
  EXPECT_TRUE(plan.has_value()) << describe(plan.error());
  return std::move(*plan);
}

std::string refusalOf(const Scene& scene, const PlanOptions& options = {}) {
  const Result<Plan> plan = WalkPlanner(sharedLibrary()).plan(scene, options);
  return plan ? "planned" : plan.error().message;
}

/// What every planner with every search promises.
class PlanContract : public ::testing::TestWithParam<std::tuple<PlannerKind, SearchKind>> {
 protected:
  PlanOptions options() const {
    PlanOptions options;
    options.planner = std::get<0>(GetParam());
    options.search = std::get<1>(GetParam());
    options.goalRadiusMetres = 0.4;
    return options;
  }
};

TEST_P(PlanContract, walksAcrossAnOpenRoom) {
  // The thesis's search promises nothing: some of eight seeds must do. The guided one arrives with the first.
  PlanOptions seeded = options();
  seeded.seed = 1;
  Plan plan = planOf(openRoom(), seeded);
  while (seeded.search != SearchKind::kGuided && plan.report.status != PlanStatus::kArrived &&
         *seeded.seed < 8) {
    ++*seeded.seed;
    plan = planOf(openRoom(), seeded);
  }
  ASSERT_EQ(plan.report.status, PlanStatus::kArrived) << plan.report.explanation;
  EXPECT_LT((onFloor(plan.walk.rootPositions.front()) - Vec2(2, 6)).norm(), 1e-9);
  EXPECT_LE((onFloor(plan.walk.rootPositions.back()) - Vec2(9, 6)).norm(), 0.4 + 1e-9);
  EXPECT_EQ(plan.report.frames, plan.walk.frameCount());
  EXPECT_EQ(plan.frameKinds.size(), plan.walk.frameCount());
}

TEST_P(PlanContract, saysThatTheStartIsBlocked) {
  Scene scene = openRoom();
  scene.obstacles = {{{2, 6}, {1, 1}}};
  const Plan plan = planOf(scene, options());
  EXPECT_EQ(plan.report.status, PlanStatus::kStartBlocked);
  EXPECT_EQ(plan.report.explanation, "the start is less than 0.40 m from an obstacle or a wall");
}

TEST_P(PlanContract, saysThatTheGoalIsBlocked) {
  Scene scene = openRoom();
  scene.goal.position = {11.9, 6};
  EXPECT_EQ(planOf(scene, options()).report.status, PlanStatus::kGoalBlocked);
}

TEST_P(PlanContract, saysThatASealedGoalHasNoPath) {
  Scene scene = openRoom();
  scene.obstacles = {{{6, 6}, {0.4, 12}}};
  const Plan plan = planOf(scene, options());
  EXPECT_EQ(plan.report.status, PlanStatus::kNoPath);
  EXPECT_EQ(plan.report.explanation, "no way from start to goal is 0.80 m wide everywhere");
  EXPECT_EQ(plan.walk.frameCount(), 0U);
}

TEST_P(PlanContract, stopsWhenTheTimeIsSpent) {
  PlanOptions hasty = options();
  auto seconds = std::make_shared<double>(0.0);
  hasty.clock = [seconds] { return 1000.0 * ++*seconds; };
  hasty.budgetMilliseconds = 1.0;
  EXPECT_EQ(planOf(openRoom(), hasty).report.status, PlanStatus::kBudgetSpent);
}

TEST_P(PlanContract, givesTheSameWalkForTheSameSeed) {
  const Plan first = planOf(openRoom(), options());
  const Plan second = planOf(openRoom(), options());
  EXPECT_EQ(first.report.edges, second.report.edges);
  EXPECT_EQ(toJson(first.report), toJson(second.report));
}

INSTANTIATE_TEST_SUITE_P(All, PlanContract,
                         ::testing::Combine(::testing::Values(PlannerKind::kPrm, PlannerKind::kRrtConnect),
                                            ::testing::ValuesIn(kAllSearchKinds)),
                         [](const auto& instance) {
                           std::string name(plannerName(std::get<0>(instance.param)));
                           name += searchName(std::get<1>(instance.param));
                           name.erase(std::remove(name.begin(), name.end(), '-'), name.end());
                           return name;
                         });

TEST(GuidedSearch, keepsClearOfWallsForEverySeed) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    PlanOptions options;
    options.seed = seed;
    const Plan plan = planOf(roomWithGap(), options);
    ASSERT_EQ(plan.report.status, PlanStatus::kArrived) << plan.report.explanation;
    EXPECT_GE(plan.report.clearanceMetres, -1e-6);
    EXPECT_LE((onFloor(plan.walk.rootPositions.back()) - Vec2(9, 6)).norm(), 0.1 + 1e-9);
    EXPECT_LT(plan.report.motionLengthMetres, 1.2 * plan.report.pathLengthMetres);
  }
}

TEST(GuidedSearch, choosesAHeadingWhereNoneIsAsked) {
  Scene scene = roomWithGap();
  scene.start.heading.reset();
  EXPECT_EQ(planOf(scene).report.status, PlanStatus::kArrived);
}

/// A corridor along z, entered facing its wall.
Plan planInCorridor(double widthMetres) {
  Scene scene;
  scene.widthMetres = widthMetres;
  scene.start = {{widthMetres / 2, 6.0}, Angle::degrees(90)};
  scene.goal = {{widthMetres / 2, 10.0}, {}};
  scene.radiusMetres = 0.45;
  return planOf(scene);
}

TEST(GuidedSearch, saysNoMotionWhereTheClipsCannotTurn) {
  const PlanReport report = planInCorridor(1.3).report;
  EXPECT_EQ(report.status, PlanStatus::kNoMotion);
  EXPECT_NE(report.explanation.find("3.9 m before it, beside the room's wall"), std::string::npos)
      << report.explanation;
}

TEST(GuidedSearch, saysWhenNoFirstStepFits) {
  const PlanReport report = planInCorridor(1.0).report;
  EXPECT_EQ(report.status, PlanStatus::kNoMotion);
  EXPECT_NE(report.explanation.find("every first step from the start at (0.5, 6.0) touches the room's wall"),
            std::string::npos)
      << report.explanation;
}

TEST(GuidedSearch, endsOnTheGoalAndFacesAsAsked) {
  for (const double degrees : {90.0, 60.0, 120.0, 0.0}) {
    Scene scene = openRoom();
    scene.goal.heading = Angle::degrees(degrees);
    const PlanReport report = planOf(scene).report;
    ASSERT_EQ(report.status, PlanStatus::kArrived) << report.explanation;
    EXPECT_LT(report.arrivalErrorMetres, 0.02) << degrees;
    ASSERT_TRUE(report.arrivalHeadingError.has_value());
    EXPECT_LT(report.arrivalHeadingError->degrees(), 3.0) << degrees;
    EXPECT_EQ(report.explanation, "");
  }
}

TEST(GuidedSearch, keepsTheWayBeforeItsEndWasBent) {
  std::size_t bent = 0;
  for (const double degrees : {90.0, 60.0, 120.0, 0.0}) {
    Scene scene = openRoom();
    scene.goal.heading = Angle::degrees(degrees);
    const Plan plan = planOf(scene);
    ASSERT_EQ(plan.report.status, PlanStatus::kArrived) << plan.report.explanation;
    EXPECT_EQ(plan.unbentWay.empty(), plan.report.arrivalWarp.metres == 0.0);
    if (plan.unbentWay.empty()) continue;
    ++bent;
    ASSERT_EQ(plan.unbentWay.size(), plan.walk.frameCount());
    // The beginning is the walk's own; the end is within the search's tolerance, and was moved.
    EXPECT_LT((plan.unbentWay.front().translation - onFloor(plan.walk.rootPositions.front())).norm(), 1e-9);
    EXPECT_LE((plan.unbentWay.back().translation - scene.goal.position).norm(), 0.1);
    EXPECT_NE(plan.unbentWay.back().translation, onFloor(plan.walk.rootPositions.back()));
  }
  EXPECT_GT(bent, 0U);
}

TEST(GuidedSearch, comesToAStandWhereTheLibraryCan) {
  const WalkPlanner planner(std::make_shared<const MotionLibrary>(testing::threeArcsAndAStop()));
  const Result<Plan> standing = planner.plan(roomWithGap());
  ASSERT_TRUE(standing.has_value());
  ASSERT_EQ(standing->report.status, PlanStatus::kArrived);
  EXPECT_TRUE(standing->report.endsStanding);
  EXPECT_FALSE(standing->report.startsStanding);
  EXPECT_LT(standing->report.arrivalErrorMetres, 0.02);
  PlanOptions moving;
  moving.standing = false;
  EXPECT_FALSE(planner.plan(roomWithGap(), moving)->report.endsStanding);
}

TEST(GuidedSearch, beginsWithAStandWhereTheLibraryCan) {
  const WalkPlanner planner(std::make_shared<const MotionLibrary>(testing::threeArcsAndAStart()));
  const Result<Plan> plan = planner.plan(openRoom());
  ASSERT_TRUE(plan.has_value());
  ASSERT_EQ(plan->report.status, PlanStatus::kArrived);
  EXPECT_TRUE(plan->report.startsStanding);
}

TEST(ThesisSearch, doesNotLookAtObstaclesAndSaysSo) {
  PlanOptions options;
  options.search = SearchKind::kThesis;
  options.goalRadiusMetres = 0.5;
  Scene scene = openRoom();
  scene.obstacles = {{{5.5, 6}, {1.0, 2.0}}};
  std::size_t collided = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    options.seed = seed;
    const Plan plan = planOf(scene, options);
    if (plan.report.status != PlanStatus::kArrived || plan.report.clearanceMetres >= 0.0) continue;
    ++collided;
    EXPECT_NE(plan.report.explanation.find("into an obstacle or a wall"), std::string::npos);
  }
  EXPECT_GT(collided, 0U);
}

TEST(ThesisSearch, touchesNothingWhenItChecksItsEdges) {
  PlanOptions options;
  options.search = SearchKind::kThesisChecked;
  options.goalRadiusMetres = 0.5;
  Scene scene = openRoom();
  scene.obstacles = {{{5.5, 6}, {1.0, 2.0}}};
  std::size_t arrived = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    options.seed = seed;
    const PlanReport report = planOf(scene, options).report;
    if (report.status != PlanStatus::kArrived) continue;
    ++arrived;
    EXPECT_GE(report.clearanceMetres, -FloorPlan::kTouchToleranceMetres) << "seed " << seed;
  }
  EXPECT_GT(arrived, 0U);
}

TEST(WalkPlanner, namesTheOptionThatIsOutOfRange) {
  PlanOptions options;
  options.goalRadiusMetres = 0.0;
  EXPECT_EQ(refusalOf(openRoom(), options), "goal radius: found 0, expected 0.01 to 5");
  options = {};
  options.radiusMetres = 9.0;
  EXPECT_EQ(refusalOf(openRoom(), options), "radius: found 9, expected 0.05 to 5");
  options = {};
  options.budgetMilliseconds = -1.0;
  EXPECT_EQ(refusalOf(openRoom(), options), "budget in milliseconds: found -1, expected 0 to 1000000000");
}

TEST(WalkPlanner, saysWhenTheThesisSearchRunsIntoWhatMoves) {
  Scene scene = openRoom();
  PlanOptions options;
  options.search = SearchKind::kThesis;
  options.goalRadiusMetres = 0.4;
  // A wall that comes down on everything: whoever does not look is in it.
  scene.moving = {{{20, 20}, TrackRepeat::kOnce, {{0.0, {6, -11}}, {1.0, {6, 6}}}}};
  Plan plan = planOf(scene, options);
  for (std::uint64_t seed = 2; seed < 9 && plan.report.status != PlanStatus::kArrived; ++seed) {
    options.seed = seed;
    plan = planOf(scene, options);
  }
  ASSERT_EQ(plan.report.status, PlanStatus::kArrived);
  EXPECT_NE(plan.report.explanation.find("into something that moves"), std::string::npos)
      << plan.report.explanation;
  options.search = SearchKind::kGuided;
  EXPECT_EQ(planOf(scene, options).report.status, PlanStatus::kGoalBlocked);
}

TEST(WalkPlanner, refusesASceneThatIsOutOfRange) {
  Scene scene = openRoom();
  scene.widthMetres = -1.0;
  EXPECT_NE(refusalOf(scene), "planned");
}

TEST(PlanReport, holdsEveryFigureOfTheContract) {
  const auto json = nlohmann::json::parse(toJson(planOf(roomWithGap()).report), nullptr, false);
  ASSERT_TRUE(json.is_object());
  for (const char* member :
       {"status",          "seed",          "planner",         "search",
        "radius_m",        "goal_radius_m", "units_per_metre", "path_ms",
        "motion_ms",       "synthesis_ms",  "total_ms",        "path_length_m",
        "motion_length_m", "duration_s",    "frames",          "expansions",
        "transitions",     "edges",         "clearance_m",     "foot_skate_cm_s",
        "arrival_error_m", "arrival_warp",  "bent_share",      "starts_standing",
        "ends_standing",   "library_hash",  "contacts",        "feet_corrected",
        "penetration_cm",  "seams",         "feet_left_alone", "foot_skate_source_cm_s"}) {
    EXPECT_TRUE(json.contains(member)) << member;
  }
  for (const char* ratio : {"joint_speed_ratio", "joint_accel_ratio"}) {
    EXPECT_TRUE(json[ratio].is_number()) << ratio;
    EXPECT_TRUE(json[std::string(ratio) + "_at"]["frame"].is_number()) << ratio;
    EXPECT_EQ(json[std::string(ratio) + "_at"]["joint"], "foot") << "the only joint beside the root";
  }
  EXPECT_TRUE(json["feet_corrected"]["mean_cm"].is_number());
  EXPECT_TRUE(json["feet_corrected"]["worst_cm"].is_number());
  EXPECT_EQ(json["status"], "arrived");
  EXPECT_EQ(json["edges"][0].size(), 2U);
}

TEST(PlanReport, namesFeetThatWereLeftAlone) {
  EXPECT_EQ(planOf(openRoom()).report.feetLeftAlone, std::vector<std::string>{"foot"});
  PlanOptions raw;
  raw.footCleanup = false;
  EXPECT_TRUE(planOf(openRoom(), raw).report.feetLeftAlone.empty());
}

TEST(PlanReport, namesEverySeamOfTheWalk) {
  const Plan plan = planOf(roomWithGap());
  ASSERT_FALSE(plan.report.seams.empty());
  EXPECT_EQ(plan.report.seams.size(), plan.report.transitions);
  for (const WalkSeam& seam : plan.report.seams) {
    ASSERT_LT(seam.frame, plan.walk.frameCount());
    EXPECT_EQ(plan.frameKinds[seam.frame], EdgeKind::kTransition);
    EXPECT_EQ(plan.frameKinds[seam.frame - 1], EdgeKind::kClipPiece);
    EXPECT_EQ(seam.from.value % testing::kClipFrames, 26U) << "where transitions leave";
    EXPECT_EQ(seam.to.value % testing::kClipFrames, 14U) << "and arrive";
    EXPECT_NEAR(seam.distanceMetres, 0.02, 1e-6);
  }
}

TEST(PlanReport, findsNoJointBeyondItsClips) {
  const PlanReport report = planOf(roomWithGap()).report;
  EXPECT_GT(report.jointSpeed.ratio, 0.5);
  EXPECT_LE(report.jointSpeed.ratio, 1.0 + 1e-9) << "blends of even steps are slower than the steps";
  EXPECT_EQ(report.penetrationMetres, 0.0);
}

}  // namespace
}  // namespace stridegraph
