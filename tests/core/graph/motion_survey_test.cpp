#include "graph/motion_survey.h"

#include <gtest/gtest.h>

#include "graph/clip_intake.h"
#include "graph/test_library.h"

namespace stridegraph {
namespace {

using testing::builtFrom;
using testing::documentOf;
using testing::walker;
using testing::walkOf;

/// A body that rests, as a library holds it; no graph is made of it.
MotionLibrary resting(std::size_t frames) {
  Clip clip{"still", 30.0, walker().size(), {}, {}};
  for (std::size_t f = 0; f < frames; ++f) clip.append(testing::restPose(walker(), {0.0, 0.9, 0.0}).view());
  ClipIntake intake(walker(), {});
  Warnings warnings;
  intake.add(clip, warnings);
  MotionLibrary library;
  intake.collect(library);
  return library;
}

TEST(MotionSurvey, tellsSpeedAndWayOfASteadyWalk) {
  const MotionLibrary library =
      builtFrom({documentOf(walkOf({.frames = 61, .speedMetresPerSecond = 1.5}), "walk")}).library;
  const MotionSurvey survey = surveyOf(library, wholeClips(library));
  EXPECT_EQ(survey.frames, 61U);
  EXPECT_NEAR(survey.longestSeconds, 61.0 / 30.0, 1e-12);
  EXPECT_NEAR(survey.pathMetres, 3.0, 1e-4);
  EXPECT_NEAR(survey.slowestMetresPerSecond, 1.5, 1e-4);
  EXPECT_NEAR(survey.fastestMetresPerSecond, 1.5, 1e-4);
  EXPECT_FALSE(survey.isOnePose);
}

TEST(MotionSurvey, looksAtTheStretchesItIsGivenAlone) {
  MotionLibrary library =
      builtFrom({documentOf(walkOf({.frames = 80, .speedMetresPerSecond = 1.5}), "walk")}).library;
  for (std::size_t f = 40; f < 80; ++f) library.frames.rootPositions[f] = library.frames.rootPositions[39];
  const MotionSurvey all = surveyOf(library, wholeClips(library));
  EXPECT_NEAR(all.slowestMetresPerSecond, 0.0, 1e-9);
  EXPECT_NEAR(all.fastestMetresPerSecond, 1.5, 1e-4);
  const std::vector<std::vector<PlayedRun>> beginning = {{{0, 30}}};
  EXPECT_NEAR(surveyOf(library, beginning).slowestMetresPerSecond, 1.5, 1e-4);
  const std::vector<std::vector<PlayedRun>> end = {{{40, 79}}};
  EXPECT_NEAR(surveyOf(library, end).fastestMetresPerSecond, 0.0, 1e-9);
}

TEST(MotionSurvey, recognisesASinglePose) {
  const MotionLibrary library = resting(60);
  const MotionSurvey survey = surveyOf(library, wholeClips(library));
  EXPECT_TRUE(survey.isOnePose);
  EXPECT_EQ(survey.fastestMetresPerSecond, 0.0);
  EXPECT_EQ(survey.slowestMetresPerSecond, 0.0);
}

TEST(MotionSurvey, ofNothingIsNothing) {
  const MotionLibrary library = resting(60);
  const std::vector<std::vector<PlayedRun>> none = {{}};
  const MotionSurvey survey = surveyOf(library, none);
  EXPECT_EQ(survey.frames, 0U);
  EXPECT_EQ(survey.slowestMetresPerSecond, 0.0);
}

}  // namespace
}  // namespace stridegraph
