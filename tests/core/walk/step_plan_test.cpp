#include "walk/step_plan.h"

#include <gtest/gtest.h>

#include <cmath>

#include "math/random.h"

namespace stridegraph {
namespace {

const FeetApart kFeet{{0.1, -0.1}};

Placement at(double x, double z, std::optional<double> degrees = std::nullopt) {
  Placement placement{{x, z}, std::nullopt};
  if (degrees) placement.heading = Angle::degrees(*degrees);
  return placement;
}

StepPlan planned(const Placement& start, const Placement& goal) {
  const std::optional<StepPlan> plan = planSteps(start, goal, kFeet, {});
  EXPECT_TRUE(plan.has_value());
  return plan.value_or(StepPlan{});
}

double degreesBetween(const Heading& a, const Heading& b) {
  return std::abs((a - b).angle().degrees());
}

TEST(StepPlan, takesAStepOrTwoToWhatIsStraightAhead) {
  // The walker faces +z; a leg of 0.85 m steps 0.41 m at most, and the other foot comes up.
  EXPECT_EQ(planned(at(0, 0, 0), at(0, 0.3)).steps.size(), 2U);
  EXPECT_EQ(planned(at(0, 0, 0), at(0, 0.8)).steps.size(), 3U);
}

TEST(StepPlan, staysWhereItStandsAtTheGoal) {
  EXPECT_TRUE(planned(at(1, 2, 30), at(1, 2, 30)).steps.empty());
  EXPECT_TRUE(planned(at(1, 2, 30), at(1, 2)).steps.empty());
  EXPECT_TRUE(planned(at(1, 2), at(1, 2)).steps.empty());
  EXPECT_TRUE(planned(at(1, 2), at(1, 2, 30)).steps.empty());
  EXPECT_TRUE(planned(at(1, 2, 30), at(1.005, 2, 30.5)).steps.empty());
}

TEST(StepPlan, goesSidewaysWithTheFootOnThatSideFirst) {
  const StepPlan left = planned(at(0, 0, 0), at(0.25, 0, 0));
  ASSERT_EQ(left.steps.size(), 2U);
  EXPECT_EQ(left.steps[0].foot, 0U) << "+x is to the left of who faces +z";
  EXPECT_EQ(planned(at(0, 0, 0), at(-0.25, 0, 0)).steps[0].foot, 1U);
}

TEST(StepPlan, stepsBackALittleAndTurnsRoundForMore) {
  const StepPlan little = planned(at(0, 0, 0), at(0, -0.25));
  EXPECT_EQ(little.steps.size(), 2U);
  EXPECT_LT(degreesBetween(little.goal.heading, Heading{}), 0.1);
  const StepPlan more = planned(at(0, 0, 0), at(0, -1.2));
  EXPECT_GT(degreesBetween(more.goal.heading, Heading{}), 179.9);
}

TEST(StepPlan, turnsOnTheSpot) {
  const StepPlan turn = planned(at(0, 0, 0), at(0, 0, 90));
  EXPECT_LE(turn.steps.size(), 4U);
  EXPECT_LT(turn.goal.translation.norm(), 1e-9);
  EXPECT_LT(degreesBetween(turn.goal.heading, Heading::fromAngle(Angle::degrees(90))), 0.01);
}

TEST(StepPlan, facesAlongTheWayWhereNoHeadingIsAsked) {
  const StepPlan plan = planned(at(0, 0), at(0.5, 0));
  EXPECT_LT(degreesBetween(plan.start.heading, Heading::fromAngle(Angle::degrees(90))), 0.01);
}

TEST(StepPlan, isNoneWhereItWouldTakeTooMany) {
  StepParams few;
  few.mostSteps = 3;
  EXPECT_FALSE(planSteps(at(0, 0, 0), at(0, 1.5), kFeet, few).has_value());
}

/// What a step does, seen by the body over the foot that stands.
FloorTransform ofStep(const StepPlan& plan, std::size_t step) {
  const FloorTransform over = step == 0 ? plan.start : plan.steps[step - 1].to;
  return over.inverse() * plan.steps[step].to;
}

TEST(StepPlan, keepsToItsLimitsAndEndsAtTheGoalForEveryPair) {
  const StepParams params;
  Random random(5);
  for (int i = 0; i < 500; ++i) {
    const double metres = random.uniform() * 1.5;
    const Heading way = Heading::fromAngle(Angle::degrees(360.0 * random.uniform()));
    const Placement start = at(3, 3, 360.0 * random.uniform() - 180.0);
    Placement goal{start.position + metres * way.direction(), std::nullopt};
    if (i % 2 == 0) goal.heading = Angle::degrees(360.0 * random.uniform() - 180.0);
    const StepPlan plan = planned(start, goal);
    EXPECT_LT((plan.goal.translation - goal.position).norm(), kThereMetres);
    if (goal.heading) {
      EXPECT_LT(degreesBetween(plan.goal.heading, Heading::fromAngle(*goal.heading)), 1.0);
    }
    for (std::size_t s = 0; s < plan.steps.size(); ++s) {
      const Footfall& fall = plan.steps[s];
      if (s > 0) {
        EXPECT_NE(fall.foot, plan.steps[s - 1].foot) << "feet take turns";
      }
      const FloorTransform step = ofStep(plan, s);
      const double side = fall.foot == 0 ? 1.0 : -1.0;
      const double outward = side * step.translation.x();
      // A body that turns while it goes faces a little elsewhere than where the limit was looked at.
      EXPECT_LT(step.translation.y(), params.ahead * params.legMetres * 1.1) << i;
      EXPECT_GT(step.translation.y(), -params.behind * params.legMetres * 1.3) << i;
      EXPECT_LT(outward, params.aside * params.legMetres * 1.3) << i;
      EXPECT_GT(0.2 + outward, 0.08) << "feet do not cross " << i;
      const double turn = side * step.heading.angle().degrees();
      EXPECT_LT(turn, params.outward.degrees() + 0.1);
      EXPECT_GT(turn, -params.inward.degrees() - 0.1);
    }
  }
}

}  // namespace
}  // namespace stridegraph
