#include "graph/clip_intake.h"

#include <gtest/gtest.h>

#include "graph/test_library.h"

namespace stridegraph {
namespace {

using testing::builtFrom;
using testing::documentOf;
using testing::threeWalks;
using testing::walker;
using testing::walkOf;

std::vector<std::string> textsOf(const Warnings& warnings) {
  std::vector<std::string> texts;
  for (const Warning& warning : warnings) texts.push_back(describe(warning));
  return texts;
}

Clip named(Clip clip, std::string name) {
  clip.name = std::move(name);
  return clip;
}

TEST(ClipIntake, leavesOutFramesThatAClipShowsAlready) {
  ClipIntake intake(walker(), {});
  Warnings warnings;
  intake.add(named(walkOf({.frames = 40}), "a"), warnings);
  intake.add(named(walkOf({.frames = 40, .phaseCycles = 0.3}), "b"), warnings);
  intake.add(named(walkOf({.frames = 40}), "again"), warnings);
  intake.add(named(walkOf({.frames = 40}), "a"), warnings);
  EXPECT_EQ(intake.originals(), 2U);
  EXPECT_EQ(textsOf(warnings), (std::vector<std::string>{"again: shows the same 40 frames as a: left out",
                                                         "a: shows the same 40 frames as a: left out"}));
  EXPECT_EQ(warnings[0].topic, WarningTopic::kMotion);
}

TEST(ClipIntake, keepsClipsThatDifferInASingleNumber) {
  ClipIntake intake(walker(), {});
  Warnings warnings;
  Clip walk = walkOf({.frames = 40});
  intake.add(named(walk, "a"), warnings);
  walk.rootPositions[39].z() += 1e-3;
  intake.add(named(walk, "b"), warnings);
  EXPECT_EQ(intake.originals(), 2U);
  EXPECT_TRUE(warnings.empty());
}

TEST(ClipIntake, keepsDifferentClipsOfOneNameAndSaysSo) {
  ClipIntake intake(walker(), {});
  Warnings warnings;
  intake.add(named(walkOf({.frames = 40}), "walk"), warnings);
  intake.add(named(walkOf({.frames = 41}), "walk"), warnings);
  EXPECT_EQ(intake.originals(), 2U);
  EXPECT_EQ(textsOf(warnings),
            (std::vector<std::string>{"walk: another clip has this name, too; both are kept"}));
  EXPECT_EQ(warnings[0].topic, WarningTopic::kText);
}

TEST(ClipIntake, knowsTheClipsOfTheLibraryItGoesOnFrom) {
  ClipIntake intake(builtFrom(threeWalks()).library);
  Warnings warnings;
  intake.add(threeWalks()[1].clip, warnings);
  EXPECT_EQ(intake.originals(), 3U);
  EXPECT_EQ(textsOf(warnings),
            (std::vector<std::string>{"left: shows the same 80 frames as left: left out"}));
}

TEST(ClipIntake, givesALibraryTheClipsOneAfterTheOther) {
  ClipIntake intake(walker(), {});
  Warnings warnings;
  intake.add(named(walkOf({.frames = 40}), "a"), warnings);
  intake.add(named(walkOf({.frames = 30}), "b"), warnings);
  MotionLibrary library;
  intake.collect(library);
  ASSERT_EQ(library.clips.size(), 2U);
  EXPECT_EQ(library.clips[1].name, "b");
  EXPECT_EQ(library.clips[1].firstFrame, 40U);
  EXPECT_EQ(library.frames.frameCount(), 70U);
  EXPECT_EQ(library.frames.rootPositions[40], intake.clips()[1].rootPositions[0]);
}

}  // namespace
}  // namespace stridegraph
