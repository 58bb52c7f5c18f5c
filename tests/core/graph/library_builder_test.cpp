#include "graph/library_builder.h"

#include <gtest/gtest.h>

#include <limits>

#include "graph/library_checks.h"
#include "graph/test_library.h"

namespace stridegraph {
namespace {

using testing::builtFrom;
using testing::documentOf;
using testing::threeWalks;
using testing::walker;
using testing::walkOf;

Error errorOf(std::vector<BvhDocument> documents, const LibraryParams& params = {}) {
  const Result<BuiltLibrary> built = buildLibrary(std::move(documents), params);
  return built ? Error{ErrorCode::kFile, "no error at all", {}} : built.error();
}

bool holds(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

TEST(LibraryBuilder, buildsASoundLibraryFromWalks) {
  const BuiltLibrary built = builtFrom(threeWalks());
  const MotionLibrary& library = built.library;
  EXPECT_EQ(faultIn(library).value_or(""), "");
  EXPECT_EQ(library.frames.frameCount(), 240U);
  EXPECT_EQ(library.clips.size(), 3U);
  EXPECT_EQ(library.license, "Made in code.");
  EXPECT_NE(library.hash, 0U);
  EXPECT_EQ(library.contactJoints.size(), 4U);
  EXPECT_NEAR(library.facingOffset.angle().degrees(), 0.0, 0.5);
  EXPECT_EQ(library.graph.clipPieceCount(), library.graph.nodes.size() - 3);
}

TEST(LibraryBuilder, holdsOnlyFloats) {
  const MotionLibrary library = builtFrom(threeWalks()).library;
  for (const Quat& q : library.frames.rotations) {
    for (const double part : {q.w(), q.x(), q.y(), q.z()})
      ASSERT_EQ(part, static_cast<double>(static_cast<float>(part)));
  }
  for (const Vec3& p : library.frames.rootPositions) {
    for (const int axis : {0, 1, 2}) ASSERT_EQ(p[axis], static_cast<double>(static_cast<float>(p[axis])));
  }
}

TEST(LibraryBuilder, reportsWhatItKept) {
  const BuiltLibrary built = builtFrom(threeWalks());
  const BuildReport& report = built.report;
  EXPECT_EQ(report.clipPiecesBeforePruning, report.nodesBeforePruning - 3);
  EXPECT_EQ(report.nodes, built.library.graph.nodes.size());
  EXPECT_EQ(report.transitions, built.library.graph.transitionCount());
  EXPECT_GT(report.framePairs, 3U * 76 * 76);
  ASSERT_EQ(report.clips.size(), 3U);
  std::size_t surviving = 0;
  for (const ClipFate& fate : report.clips) {
    surviving += fate.survivingFrames;
    EXPECT_GT(fate.transitions, 0U);
    EXPECT_TRUE(holds(fate.reason, "no way leads into frames 0 to ")) << fate.reason;
  }
  EXPECT_NEAR(report.survivingShare, static_cast<double>(surviving) / 240.0, 1e-12);
}

TEST(LibraryBuilder, saysWhyAClipIsLeftOut) {
  std::vector<BvhDocument> documents = threeWalks();
  documents.push_back(documentOf(walkOf({.frames = 10}), "brief"));
  documents.push_back(documentOf(walkOf({.frames = 60, .speedMetresPerSecond = 6.0}), "sprint"));
  const BuildReport report = builtFrom(std::move(documents)).report;
  EXPECT_EQ(report.clips[3].reason, "too short: 10 frames, at least 17 are needed for a transition of 13");
  EXPECT_EQ(report.clips[3].survivingFrames, 0U);
  // The sprint repeats itself, but nothing leads over to the walks.
  EXPECT_EQ(report.clips[4].reason, "no way leads from it to the rest of the graph and back");
}

TEST(LibraryBuilder, stepsOnWithGrowingProgressAndEndsAtOne) {
  Result<LibraryBuilder> builder = LibraryBuilder::start(threeWalks(), {}, "Made in code.");
  ASSERT_TRUE(builder);
  double progress = builder->progress();
  EXPECT_EQ(progress, 0.0);
  std::size_t steps = 0;
  while (builder->step()) {
    EXPECT_GE(builder->progress(), progress);
    progress = builder->progress();
    ++steps;
  }
  EXPECT_GE(steps, 8U);
  EXPECT_EQ(builder->progress(), 1.0);
  EXPECT_FALSE(builder->step());
  EXPECT_EQ(builder->finish()->hash, builtFrom(threeWalks()).library.hash);
}

TEST(LibraryBuilder, givesTheSameLibraryTwice) {
  EXPECT_EQ(builtFrom(threeWalks()).library.hash, builtFrom(threeWalks()).library.hash);
  EXPECT_NE(builtFrom(threeWalks()).library.hash,
            builtFrom(threeWalks(), {.thresholdMetres = 0.04}).library.hash);
}

TEST(LibraryBuilder, bringsClipsToOneRate) {
  std::vector<BvhDocument> documents = threeWalks();
  documents[1].clip.framesPerSecond = 60.0;
  documents[2].clip.framesPerSecond = 30.0003;
  const MotionLibrary library = builtFrom(std::move(documents)).library;
  EXPECT_EQ(library.frames.framesPerSecond, 30.0);
  EXPECT_EQ(library.clips[1].frameCount, 40U);
  EXPECT_EQ(library.clips[2].frameCount, 80U);
}

TEST(LibraryBuilder, levelsAFloorThatIsOffAndSaysSo) {
  std::vector<BvhDocument> documents = threeWalks();
  for (Vec3& root : documents[2].clip.rootPositions) root.y() += 0.03;
  const BuiltLibrary built = builtFrom(std::move(documents));
  ASSERT_EQ(built.report.warnings.size(), 1U);
  const std::string warning = describe(built.report.warnings[0]);
  EXPECT_TRUE(warning.starts_with("right: its floor lies 3.")) << warning;
  EXPECT_TRUE(warning.ends_with(" cm above that of the other clips; it was lowered to theirs")) << warning;
  EXPECT_NEAR(built.library.frames.rootPositions[160].y(), 0.9, 2e-3);
}

TEST(LibraryBuilder, cutsAClipWhereAJointJumps) {
  std::vector<BvhDocument> documents = threeWalks();
  documents[0].clip.rotationsOf(0)[10] = axisRotation(Axis::kZ, Angle::degrees(81));
  documents[1].clip.rotationsOf(40)[10] = axisRotation(Axis::kZ, Angle::degrees(81));
  const BuiltLibrary built = builtFrom(std::move(documents));
  ASSERT_EQ(built.library.clips.size(), 4U);
  EXPECT_EQ(built.library.clips[0].frameCount, 79U);
  EXPECT_EQ(built.library.clips[1].frameCount, 40U);
  EXPECT_EQ(built.library.clips[2].name, "left from frame 41");
  EXPECT_EQ(built.library.clips[2].frameCount, 39U);
  ASSERT_EQ(built.report.warnings.size(), 3U);
  EXPECT_TRUE(holds(describe(built.report.warnings[0]), "ahead: joint leftArm turns 8"))
      << describe(built.report.warnings[0]);
  EXPECT_TRUE(holds(describe(built.report.warnings[0]), "from frame 0 to 1"))
      << describe(built.report.warnings[0]);
}

TEST(LibraryBuilder, mirrorsEveryClipWhenAsked) {
  const MotionLibrary library = builtFrom(threeWalks(), {.mirror = true}).library;
  ASSERT_EQ(library.clips.size(), 6U);
  EXPECT_TRUE(library.clips[3].mirrored);
  EXPECT_EQ(library.clips[3].name, "ahead mirrored");
  EXPECT_EQ(library.clips[3].frameCount, 80U);
  EXPECT_EQ(faultIn(library).value_or(""), "");
}

TEST(LibraryBuilder, keepsMoreTransitionsOfASmallerNeighbourhood) {
  const auto transitionsWithin = [](std::uint32_t frames) {
    const auto built = buildLibrary(threeWalks(), {.neighbourFrames = frames});
    return built ? built->report.transitionsBeforePruning : 0;
  };
  EXPECT_GT(transitionsWithin(0), transitionsWithin(6));
  EXPECT_GE(transitionsWithin(6), transitionsWithin(12));
}

TEST(LibraryBuilder, refusesParamsOutOfRange) {
  EXPECT_EQ(errorOf(threeWalks(), {.thresholdMetres = 0.0}).message,
            "a threshold of 0 m, more than 0 expected");
  EXPECT_EQ(errorOf(threeWalks(), {.transitionFrames = 1}).message,
            "transitions of 1 frames, 2 to 120 expected");
  EXPECT_EQ(errorOf(threeWalks(), {.framesPerSecond = 241.0}).message,
            "241 frames a second, 1 to 240 expected");
  EXPECT_EQ(errorOf(threeWalks(), {.neighbourFrames = 101}).message,
            "a neighbourhood of 101 frames, 0 to 100 expected");
  EXPECT_EQ(errorOf(threeWalks(), {.framesPerSecond = 241.0}).code, ErrorCode::kInvalidArgument);
  EXPECT_EQ(errorOf({}).message, "no clips, at least one expected");
}

TEST(LibraryBuilder, refusesClipsOfDifferentSkeletonsAndNamesThem) {
  std::vector<BvhDocument> documents = threeWalks();
  documents[1].skeleton.joints[2].offset.y() -= 0.02;
  const Error error = errorOf(std::move(documents));
  EXPECT_EQ(error.code, ErrorCode::kSkeletonMismatch);
  EXPECT_EQ(describe(error),
            "left: its skeleton is not that of ahead: joint leftShin is offset 0.0200 m differently (at most "
            "0.0010 m "
            "expected)");
}

TEST(LibraryBuilder, refusesNumbersThatAreNone) {
  std::vector<BvhDocument> documents = threeWalks();
  documents[2].clip.rootPositions[7].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(describe(errorOf(documents)), "right: the root's position in frame 7 is not finite");
  documents = threeWalks();
  documents[2].clip.rotationsOf(3)[6] = Quat(0, 0, 0, 0);
  EXPECT_EQ(describe(errorOf(documents)),
            "right: the rotation of joint rightShin in frame 3 is not of unit length");
  documents[0].clip.framesPerSecond = 0.0;
  EXPECT_EQ(describe(errorOf(documents)), "ahead: 0 frames a second, more than 0 expected");
}

TEST(LibraryBuilder, refusesClipsThatAreAllTooShort) {
  const Error error =
      errorOf({documentOf(walkOf({.frames = 16}), "a"), documentOf(walkOf({.frames = 12}), "b")});
  EXPECT_EQ(error.code, ErrorCode::kClipTooShort);
  EXPECT_EQ(error.message, "the longest clip has 16 frames; transitions of 13 need clips of 17 at least");
}

TEST(LibraryBuilder, refusesWhatCannotGoOnForEverAndStillReports) {
  Result<LibraryBuilder> builder =
      LibraryBuilder::start({documentOf(walkOf({.frames = 30}), "short of a cycle")}, {});
  while (builder->step()) {
  }
  const Result<MotionLibrary> library = builder->finish();
  ASSERT_FALSE(library);
  EXPECT_EQ(library.error().code, ErrorCode::kEmptyGraph);
  EXPECT_TRUE(holds(library.error().message, "0 transitions were found within 0.05 m"))
      << library.error().message;
  EXPECT_EQ(builder->report().clips[0].reason, "no 13 frames of it come within 0.05 m of any other motion");
}

}  // namespace
}  // namespace stridegraph
