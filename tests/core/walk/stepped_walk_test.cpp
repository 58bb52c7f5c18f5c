#include "walk/stepped_walk.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "walk/test_library.h"
#include "walk/test_walker.h"

namespace stridegraph {
namespace {

using namespace testing;

const MotionLibrary& library() {
  static const MotionLibrary standing = standingLibrary();
  return standing;
}

const StandingBody& body() {
  static const StandingBody standing = *standingBody(library(), findWalkFeet(library()));
  return standing;
}

SynthesisedWalk walkTo(const Placement& goal) {
  const Placement start{{0, 0}, Angle::degrees(0)};
  return stepWalk(library(), body(), *planSteps(start, goal, body().apart, body().steps));
}

/// How a walk may go: ahead, aside, back, turning, and not at all.
std::vector<Placement> goals() {
  return {{{0, 0.7}, {}},
          {{0.25, 0}, Angle::degrees(0)},
          {{-0.2, -0.2}, Angle::degrees(0)},
          {{0, 0}, Angle::degrees(120)},
          {{0.3, 0.5}, Angle::degrees(-60)},
          {{0, 0}, Angle::degrees(0)}};
}

TEST(StandingBody, knowsItsFeet) {
  EXPECT_NEAR(body().steps.legMetres, body().feet[0].foot.legMetres, 1e-9);
  EXPECT_NEAR(body().apart.leftMetres[0], -body().apart.leftMetres[1], 1e-9);
  EXPECT_EQ(body().feet[0].contacts, 0b0011);
  EXPECT_EQ(body().feet[1].contacts, 0b1100);
  EXPECT_EQ(body().firstFrame, 0U);
  EXPECT_EQ(body().lastFrame, 29U);
}

TEST(StandingBody, isNoneWhereNobodyStandsOrLegsAreMissing) {
  EXPECT_FALSE(standingBody(threeArcs(), findWalkFeet(threeArcs())).has_value());
  MotionLibrary walking = standingLibrary();
  for (std::size_t f = 0; f < walking.frames.frameCount(); ++f)
    walking.frames.rootPositions[f].z() = 0.04 * static_cast<double>(f);
  EXPECT_FALSE(standingBody(walking, findWalkFeet(walking)).has_value());
}

TEST(SteppedWalk, beginsAndEndsStandingWhereItIsAskedTo) {
  for (const Placement& goal : goals()) {
    const SynthesisedWalk walk = walkTo(goal);
    ASSERT_EQ(walk.placements.size(), walk.clip.frameCount());
    EXPECT_LT(walk.placements.front().translation.norm(), 1e-9);
    EXPECT_LT((walk.placements.back().translation - goal.position).norm(), 1e-9);
    EXPECT_LT((onFloor(walk.clip.rootPositions.back()) - goal.position).norm(), 1e-9);
    if (goal.heading) {
      EXPECT_LT(
          std::abs((walk.placements.back().heading - Heading::fromAngle(*goal.heading)).angle().degrees()),
          0.01);
    }
    for (const std::size_t end : {std::size_t{0}, walk.clip.frameCount() - 5}) {
      EXPECT_LT((walk.clip.rootPositions[end + 4] - walk.clip.rootPositions[end]).norm(), 0.01);
      EXPECT_EQ(walk.contacts[end], kAllDown);
      EXPECT_EQ(walk.frameKinds[end], EdgeKind::kClipPiece);
    }
  }
}

TEST(SteppedWalk, keepsPlantedFeetWhereTheyStand) {
  for (const Placement& goal : goals()) {
    const SynthesisedWalk walk = walkTo(goal);
    for (const auto& [tip, bit] : {std::pair{kLeftTip, 0b0010U}, {kRightTip, 0b1000U}}) {
      const std::vector<Vec3> track = trackOf(walk, tip);
      for (std::size_t f = 1; f < track.size(); ++f) {
        EXPECT_GT(track[f].y(), -1e-4) << "below the floor";
        if ((walk.contacts[f] & walk.contacts[f - 1] & bit) == 0) continue;
        EXPECT_LT((track[f] - track[f - 1]).norm(), 1e-4) << f;
      }
    }
  }
}

TEST(SteppedWalk, liftsOneFootAtATime) {
  for (const Placement& goal : goals()) {
    const SynthesisedWalk walk = walkTo(goal);
    for (const ContactMask mask : walk.contacts) EXPECT_NE(mask, 0) << "nobody jumps";
  }
  const SynthesisedWalk walk = walkTo({{0, 0.7}, {}});
  const std::vector<Vec3> track = trackOf(walk, kLeftTip);
  double highest = 0.0;
  for (const Vec3& place : track) highest = std::max(highest, place.y());
  EXPECT_GT(highest, 0.03);
  EXPECT_LT(highest, 0.15);
}

TEST(SteppedWalk, movesWithoutJolts) {
  for (const Placement& goal : goals()) {
    const SynthesisedWalk walk = walkTo(goal);
    const double fps = walk.clip.framesPerSecond;
    for (std::size_t f = 2; f < walk.clip.frameCount(); ++f) {
      const auto& root = walk.clip.rootPositions;
      EXPECT_LT((root[f] - 2.0 * root[f - 1] + root[f - 2]).norm() * fps * fps, 6.0) << f;
      for (std::size_t j = 1; j < walk.clip.jointCount; ++j) {
        EXPECT_LT(
            angleBetween(walk.clip.pose(f).rotations[j], walk.clip.pose(f - 1).rotations[j]).degrees() * fps,
            500.0)
            << j << " at " << f;
      }
    }
  }
}

TEST(SteppedWalk, keepsToTheStraightLineWithoutSway) {
  SteppedWalkParams params;
  params.swayMetres = 0.0;
  const Placement start{{0, 0}, Angle::degrees(0)};
  const auto plan = planSteps(start, {{0, 0.7}, {}}, body().apart, body().steps);
  for (const FloorTransform& at : stepWalk(library(), body(), *plan, params).placements)
    EXPECT_LT(std::abs(at.translation.x()), 1e-9);
}

}  // namespace
}  // namespace stridegraph
