#include "graph/jerks.h"

#include <gtest/gtest.h>

#include "graph/test_library.h"

namespace stridegraph {
namespace {

using testing::documentOf;
using testing::walker;
using testing::walkOf;

constexpr std::size_t kArm = 10;

/// A walk long enough to know what is usual, whose arm lies `degrees` off from frame `first` on.
Clip withSlip(std::size_t first, double degrees) {
  Clip clip = walkOf({.frames = 1200});
  for (std::size_t f = first; f < clip.frameCount(); ++f) {
    Quat& arm = clip.rotationsOf(f)[kArm];
    arm = arm * axisRotation(Axis::kZ, Angle::degrees(degrees));
  }
  return clip;
}

MotionLibrary libraryOf(const std::vector<Clip>& clips) {
  MotionLibrary library;
  library.skeleton = walker();
  library.frames.jointCount = library.skeleton.size();
  for (const Clip& clip : clips) {
    library.clips.push_back({clip.name, static_cast<std::uint32_t>(library.frames.frameCount()),
                             static_cast<std::uint32_t>(clip.frameCount()), false});
    for (std::size_t f = 0; f < clip.frameCount(); ++f) library.frames.append(clip.pose(f));
  }
  return library;
}

std::vector<Jerk> armJerks(const MotionLibrary& library) {
  return findJerks(library, JointIndex(kArm));
}

TEST(FindJerks, findsASlipAmongLibraryFrames) {
  const std::vector<Jerk> jerks = armJerks(libraryOf({withSlip(0, 0), withSlip(700, 20)}));
  ASSERT_EQ(jerks.size(), 1U);
  EXPECT_EQ(jerks[0].frame, FrameIndex(std::size_t{1200 + 699}));
  EXPECT_EQ(jerks[0].joint, JointIndex(kArm));
  EXPECT_NEAR(jerks[0].turn.degrees(), 20.0, 2.0);
}

TEST(FindJerks, leavesCleanMotionAndTheRootAlone) {
  const MotionLibrary library = libraryOf({withSlip(0, 0)});
  for (std::size_t j = 0; j < walker().size(); ++j)
    EXPECT_TRUE(findJerks(library, JointIndex(j)).empty()) << j;
}

TEST(FindJerks, leavesRareFastMotionAlone) {
  Clip clip = withSlip(0, 0);
  double angle = 0.0;
  for (std::size_t f = 600; f < clip.frameCount(); ++f) {
    const std::vector<double> turns = {3, 8, 15, 20, 20, 15, 8, 3};
    if (f - 600 < turns.size()) angle += turns[f - 600];
    Quat& arm = clip.rotationsOf(f)[kArm];
    arm = arm * axisRotation(Axis::kZ, Angle::degrees(angle));
  }
  EXPECT_TRUE(armJerks(libraryOf({clip, withSlip(0, 0), withSlip(0, 0), withSlip(0, 0)})).empty())
      << "a quick wave that gets up to speed over some frames";
}

TEST(FarthestByFrame, keepsOneJerkForEachFrame) {
  const auto jerkAt = [](std::size_t frame, std::size_t joint, double degrees) {
    return Jerk{FrameIndex(frame), JointIndex(joint), Angle::degrees(degrees)};
  };
  const std::vector<Jerk> jerks = farthestByFrame({jerkAt(9, 1, 5), jerkAt(4, 2, 7), jerkAt(9, 3, 8)});
  ASSERT_EQ(jerks.size(), 2U);
  EXPECT_EQ(jerks[0].frame, FrameIndex(std::size_t{4}));
  EXPECT_EQ(jerks[1].joint, JointIndex(std::size_t{3}));
}

TEST(FindJerks, looksAtAllJoints) {
  const MotionLibrary library = libraryOf({withSlip(0, 0), withSlip(700, 20)});
  const std::vector<Jerk> jerks = findJerks(library);
  ASSERT_EQ(jerks.size(), 1U);
  EXPECT_EQ(jerks[0].frame, armJerks(library)[0].frame);
}

TEST(PlaysAcross, needsFramesOnBothSidesOfAJerk) {
  const std::vector<Jerk> jerks = {{FrameIndex(std::size_t{20}), {}, {}}};
  const auto across = [&](std::size_t first, std::size_t last) {
    return playsAcross(jerks, FrameIndex(first), FrameIndex(last));
  };
  EXPECT_TRUE(across(20, 21));
  EXPECT_TRUE(across(3, 90));
  EXPECT_FALSE(across(3, 20));
  EXPECT_FALSE(across(21, 90));
}

TEST(SteadyFrameCounts, divideClipsAtJerks) {
  const MotionLibrary library = libraryOf({walkOf({.frames = 50}), walkOf({.frames = 30})});
  const std::vector<Jerk> jerks = {{FrameIndex(std::size_t{9}), {}, {}},
                                   {FrameIndex(std::size_t{60}), {}, {}}};
  EXPECT_EQ(steadyFrameCounts(library, jerks), (std::vector<std::uint32_t>{10, 40, 11, 19}));
  EXPECT_EQ(steadyFrameCounts(library, {}), (std::vector<std::uint32_t>{50, 30}));
}

TEST(BlendsAcross, looksAtBothSpansOfATransition) {
  const std::vector<Jerk> jerks = {{FrameIndex(std::size_t{20}), {}, {}}};
  const auto across = [&](std::size_t from, std::size_t to) {
    return blendsAcross(jerks, {FrameIndex(from), FrameIndex(to), 12, 12, 12, 0.0F});
  };
  EXPECT_TRUE(across(15, 60));
  EXPECT_TRUE(across(60, 25));
  EXPECT_TRUE(across(20, 60)) << "begins right before the jerk";
  EXPECT_FALSE(across(21, 60));
  EXPECT_FALSE(across(8, 60)) << "ends right before it";
  EXPECT_FALSE(across(60, 33)) << "its span begins behind the jerk";
}

TEST(LibraryBuilder, letsNothingPlayAcrossAJerkAndSaysWhere) {
  const BuiltLibrary built = testing::builtFrom({documentOf(withSlip(600, 20), "slips")});
  ASSERT_FALSE(built.report.warnings.empty());
  EXPECT_NE(describe(built.report.warnings[0])
                .find("slips: joint leftArm slips by 20 degrees from frame 599 to 600, more than it turns "
                      "anywhere else: nothing plays across that"),
            std::string::npos)
      << describe(built.report.warnings[0]);
  // A transition that leads in ends, and one that leads out begins, with its whole blend on one side.
  const ClipFate& fate = built.report.clips[0];
  EXPECT_NE(fate.reason.find(" or through frames 588 to 612 or "), std::string::npos) << fate.reason;
  EXPECT_LT(fate.survivingFrames + 24, fate.frames);
  const MotionGraph& graph = built.library.graph;
  for (const MotionEdge& edge : graph.edges) {
    const std::uint32_t from = graph.nodes[edge.from.value].value;
    const std::uint32_t to = graph.nodes[edge.to.value].value;
    if (edge.kind == EdgeKind::kClipPiece) {
      EXPECT_FALSE(from <= 599 && to >= 600) << from << " to " << to;
    } else {
      EXPECT_FALSE(from <= 599 && from + edge.sourceSpan >= 600) << from;
      EXPECT_FALSE(to - edge.targetSpan <= 599 && to >= 600) << to;
    }
  }
}

}  // namespace
}  // namespace stridegraph
