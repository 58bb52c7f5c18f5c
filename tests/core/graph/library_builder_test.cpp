#include "graph/library_builder.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "graph/library_checks.h"
#include "graph/sgraph_file.h"
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

/// The warnings that are about captured frames.
Warnings onFrames(const BuildReport& report) {
  Warnings warnings = report.warnings;
  std::erase_if(warnings, [](const Warning& warning) { return warning.topic != WarningTopic::kMotion; });
  return warnings;
}

/// Enough of one gait for some thousand transitions.
std::vector<BvhDocument> manyWalks() {
  std::vector<BvhDocument> walks;
  for (int w = 0; w < 16; ++w) {
    walks.push_back(
        documentOf(walkOf({.frames = 80, .turnPerSecond = Angle::degrees(4.0 * w), .phaseCycles = 0.07 * w}),
                   fmt::format("walk {}", w)));
  }
  return walks;
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
    EXPECT_TRUE(holds(fate.reason, "no transition leads into frames 0 to ")) << fate.reason;
  }
  EXPECT_NEAR(report.survivingShare, static_cast<double>(surviving) / 240.0, 1e-12);
  EXPECT_EQ(report.transitionsBeforeThinning, report.transitions);
}

TEST(LibraryBuilder, keepsNoMoreTransitionsThanAskedAndSaysWhatItLeavesOut) {
  const BuiltLibrary built = builtFrom(manyWalks(), {.mostTransitions = 1000});
  const BuildReport& report = built.report;
  EXPECT_EQ(faultIn(built.library).value_or(""), "");
  EXPECT_LE(report.transitions, 1000U);
  EXPECT_GT(report.transitions, 500U);
  EXPECT_EQ(report.transitionsBeforeThinning, builtFrom(manyWalks()).report.transitions);
  ASSERT_FALSE(report.warnings.empty());
  EXPECT_TRUE(report.warnings.front().message.starts_with(fmt::format(
      "{} of {} transitions are kept, and ", report.transitions, report.transitionsBeforeThinning)))
      << report.warnings.front().message;
  std::size_t surviving = 0;
  std::size_t leftOut = 0;
  for (const ClipFate& fate : report.clips) {
    surviving += fate.survivingFrames;
    if (fate.survivingFrames > 0) continue;
    ++leftOut;
    EXPECT_TRUE(holds(fate.reason, " frames are left out, since other frames show the same motion"))
        << fate.reason;
  }
  EXPECT_GT(leftOut, 0U);
  EXPECT_LT(leftOut, report.clips.size());
  EXPECT_NEAR(report.survivingShare * static_cast<double>(built.library.frames.frameCount()),
              static_cast<double>(surviving), 1e-6);
}

TEST(LibraryBuilder, thinsAnAppendedLibraryAsOneBuiltAtOnce) {
  const LibraryParams params = {.mostTransitions = 1000};
  const std::vector<BvhDocument> documents = manyWalks();
  const MotionLibrary base = builtFrom({documents.begin(), documents.end() - 2}, params).library;
  auto builder = LibraryBuilder::append(base, {documents.end() - 2, documents.end()});
  while (builder->step()) {
  }
  EXPECT_EQ(builder->finish()->hash, builtFrom(documents, params).library.hash);
}

TEST(LibraryBuilder, saysWhyAClipIsLeftOut) {
  std::vector<BvhDocument> documents = threeWalks();
  documents.push_back(documentOf(walkOf({.frames = 10}), "brief"));
  documents.push_back(documentOf(walkOf({.frames = 60, .speedMetresPerSecond = 6.0}), "sprint"));
  const BuildReport report = builtFrom(std::move(documents)).report;
  EXPECT_EQ(report.clips[3].reason, "too short: 10 frames, at least 17 are needed for a transition of 13");
  EXPECT_EQ(report.clips[3].survivingFrames, 0U);
  // The sprint repeats itself, but nothing leads over to the walks.
  EXPECT_EQ(report.clips[4].reason, "no transitions lead from it to the rest of the graph and back");
}

/// Steps to the end of a build; progress must grow from 0 to 1 on the way.
std::size_t stepsOf(LibraryBuilder& builder) {
  double progress = builder.progress();
  EXPECT_EQ(progress, 0.0);
  std::size_t steps = 0;
  for (; builder.step(); ++steps) {
    EXPECT_GE(builder.progress(), progress);
    EXPECT_LT(builder.progress(), 1.0);
    progress = builder.progress();
  }
  EXPECT_EQ(builder.progress(), 1.0);
  EXPECT_FALSE(builder.step());
  return steps;
}

TEST(LibraryBuilder, stepsOnWithGrowingProgressAndEndsAtOne) {
  Result<LibraryBuilder> builder = LibraryBuilder::start(threeWalks(), {}, "Made in code.");
  ASSERT_TRUE(builder);
  EXPECT_GE(stepsOf(*builder), 8U);
  EXPECT_EQ(builder->finish()->hash, builtFrom(threeWalks()).library.hash);
}

TEST(LibraryBuilder, stepsOnWithGrowingProgressWhateverBecomesOfIt) {
  const std::vector<BvhDocument> wandering = {
      documentOf(testing::wanderingClip(walker(), 200, 9), "wandering"),
      documentOf(testing::wanderingClip(walker(), 100, 10), "more of it")};
  for (const LibraryParams& params :
       {LibraryParams{}, LibraryParams{.mirror = true}, LibraryParams{.thresholdMetres = 1e-6},
        LibraryParams{.thresholdMetres = 2.0}, LibraryParams{.transitionFrames = 120}}) {
    Result<LibraryBuilder> builder = LibraryBuilder::start(wandering, params);
    ASSERT_TRUE(builder);
    const std::size_t steps = stepsOf(*builder);
    EXPECT_GE(steps, 2U);
    EXPECT_LT(steps, 2000U);
  }
  Result<LibraryBuilder> appending = LibraryBuilder::append(builtFrom(threeWalks()).library, wandering);
  ASSERT_TRUE(appending);
  EXPECT_GE(stepsOf(*appending), 8U);
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
  ASSERT_EQ(onFrames(built.report).size(), 1U);
  const std::string warning = describe(onFrames(built.report)[0]);
  EXPECT_TRUE(warning.starts_with("right: its floor lies 3.")) << warning;
  EXPECT_TRUE(warning.ends_with(" cm above that of the first clip; it was lowered to that")) << warning;
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
  EXPECT_EQ(onFrames(built.report).size(), 3U);
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

/// Of a library that grows one clip at a time, from the first so many at once.
BuiltLibrary grown(std::vector<BvhDocument> documents, std::size_t atOnce, const LibraryParams& params = {}) {
  const auto middle = documents.begin() + static_cast<std::ptrdiff_t>(atOnce);
  BuiltLibrary built = builtFrom({documents.begin(), middle}, params);
  for (auto document = middle; document != documents.end(); ++document) {
    // By way of a file, as a user does it.
    Result<MotionLibrary> read = readSgraph(writeSgraph(built.library));
    Result<LibraryBuilder> builder = LibraryBuilder::append(std::move(*read), {*document});
    while (builder->step()) {
    }
    built = {*builder->finish(), builder->report()};
  }
  return built;
}

/// Walks of several paces, one on another floor, one with a jump, one too short.
std::vector<BvhDocument> unevenWalks() {
  std::vector<BvhDocument> documents = threeWalks();
  documents.push_back(
      documentOf(walkOf({.frames = 90, .speedMetresPerSecond = 1.0, .cyclesPerSecond = 0.85}), "slow"));
  documents.push_back(documentOf(walkOf({.frames = 70, .phaseCycles = 0.2}), "high"));
  for (Vec3& root : documents[4].clip.rootPositions) root.y() += 0.04;
  documents.push_back(documentOf(walkOf({.frames = 90, .turnPerSecond = Angle::degrees(15)}), "jumping"));
  documents[5].clip.rotationsOf(30)[10] = axisRotation(Axis::kZ, Angle::degrees(81));
  documents.push_back(documentOf(walkOf({.frames = 9}), "brief"));
  return documents;
}

TEST(LibraryBuilder, appendsToTheSameBytesAsBuildingAtOnce) {
  const BuiltLibrary atOnce = builtFrom(unevenWalks());
  EXPECT_GT(atOnce.library.regions.size(), 0U);
  for (const std::size_t first : {std::size_t{1}, std::size_t{3}, std::size_t{6}}) {
    const BuiltLibrary built = grown(unevenWalks(), first);
    EXPECT_EQ(writeSgraph(built.library), writeSgraph(atOnce.library)) << first;
    EXPECT_EQ(built.report.nodesBeforePruning, atOnce.report.nodesBeforePruning);
    EXPECT_EQ(built.report.clips.size(), atOnce.report.clips.size());
    // The last clip has 5 windows, the others 562 after one is cut in two.
    EXPECT_GE(built.report.framePairs, 5U * 400);
    EXPECT_LT(built.report.framePairs, 5U * 600);
  }
}

TEST(LibraryBuilder, comparesOnlyNewFramesWhenItAppends) {
  std::vector<BvhDocument> documents = unevenWalks();
  documents.resize(5);
  const BuiltLibrary atOnce = builtFrom(documents);
  const BuiltLibrary built = grown(documents, 4);
  EXPECT_EQ(built.library.hash, atOnce.library.hash);
  // 66 windows against those of 3 clips of 80 frames and one of 90, and themselves.
  EXPECT_GE(built.report.framePairs, 66U * (3 * 76 + 86) + 66U * 67 / 2);
  EXPECT_LT(built.report.framePairs, 66U * (3 * 76 + 86 + 66));
}

TEST(LibraryBuilder, appendsToMirroredLibrariesAlike) {
  const LibraryParams params{.thresholdMetres = 0.04, .transitionFrames = 11, .mirror = true};
  std::vector<BvhDocument> documents = unevenWalks();
  // With its one arm in the middle the body is symmetric: its mirror needs no motion to be measured by.
  for (BvhDocument& document : documents) document.skeleton.joints[10].offset = Vec3::Zero();
  const BuiltLibrary atOnce = builtFrom(documents, params);
  const BuiltLibrary built = grown(documents, 2, params);
  EXPECT_EQ(writeSgraph(built.library), writeSgraph(atOnce.library));
  EXPECT_LT(built.report.framePairs, 10U * 1200);
}

TEST(LibraryBuilder, appendsAlikeWhereMirrorImagesDependOnTheClips) {
  const LibraryParams params{.thresholdMetres = 0.04, .mirror = true};
  const BuiltLibrary atOnce = builtFrom(unevenWalks(), params);
  const BuiltLibrary built = grown(unevenWalks(), 6, params);
  EXPECT_EQ(writeSgraph(built.library), writeSgraph(atOnce.library));
  // Mirror images were new, the others were not.
  EXPECT_GT(built.report.framePairs, 10U * 1200);
  EXPECT_LT(built.report.framePairs, atOnce.report.framePairs - 400U * 400 / 2);
}

TEST(LibraryBuilder, appendKeepsTheLicenceUnlessThereIsAnother) {
  const auto licenceAfter = [](const std::string& licence) {
    Result<LibraryBuilder> builder =
        LibraryBuilder::append(builtFrom(threeWalks()).library,
                               {documentOf(walkOf({.frames = 50, .phaseCycles = 0.6}), "more")}, licence);
    while (builder->step()) {
    }
    return builder->finish()->license;
  };
  EXPECT_EQ(licenceAfter(""), "Made in code.");
  EXPECT_EQ(licenceAfter("Another."), "Another.");
}

TEST(LibraryBuilder, refusesToAppendNothingOrAnotherBody) {
  const MotionLibrary library = builtFrom(threeWalks()).library;
  EXPECT_EQ(LibraryBuilder::append(library, {}).error().message, "no clips, at least one expected");
  std::vector<BvhDocument> documents = threeWalks();
  documents[1].skeleton.joints[2].offset.y() -= 0.02;
  const Result<LibraryBuilder> builder = LibraryBuilder::append(library, {documents[1]});
  ASSERT_FALSE(builder);
  EXPECT_EQ(builder.error().code, ErrorCode::kSkeletonMismatch);
  EXPECT_TRUE(describe(builder.error()).starts_with("left: its skeleton is not that of the library: "));
}

TEST(LibraryBuilder, warnsOfAGraphThatHoldsNextToNothing) {
  std::vector<BvhDocument> documents = {documentOf(walkOf({.frames = 60}), "walk")};
  for (std::uint64_t k = 0; k < 3; ++k)
    documents.push_back(documentOf(testing::wanderingClip(walker(), 400, 70 + k), "wandering"));
  const BuiltLibrary built = builtFrom(std::move(documents));
  ASSERT_LT(built.report.survivingShare, 0.1);
  ASSERT_FALSE(built.report.warnings.empty());
  EXPECT_TRUE(
      std::any_of(built.report.warnings.begin(), built.report.warnings.end(), [](const Warning& warning) {
        return warning.topic == WarningTopic::kGraph &&
               holds(warning.message, " of 1260 frames are in the graph: ");
      }));
  for (const Warning& warning : builtFrom(threeWalks()).report.warnings)
    EXPECT_FALSE(holds(warning.message, "frames are in the graph")) << warning.message;
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
  EXPECT_EQ(errorOf(threeWalks(), {.mostTransitions = 999}).message,
            "999 transitions at most, 1000 or more expected");
  EXPECT_EQ(errorOf(threeWalks(), {.largestSpanRatio = 2.5}).message,
            "spans 2.5 times as long, 1 to 2 expected");
  EXPECT_EQ(errorOf(threeWalks(), {.framesPerSecond = 241.0}).code, ErrorCode::kInvalidArgument);
  EXPECT_EQ(errorOf({}).message, "no clips, at least one expected");
}

TEST(LibraryBuilder, refusesClipsOfDifferentSkeletonsAndNamesThem) {
  std::vector<BvhDocument> documents = threeWalks();
  documents[1].skeleton.joints[2].offset.y() -= 0.02;
  const Error error = errorOf(std::move(documents));
  EXPECT_EQ(error.code, ErrorCode::kSkeletonMismatch);
  EXPECT_EQ(describe(error),
            "left: its skeleton is not that of the 2 clips like ahead: leftShin 47.0 cm, expected 45.0 cm");
}

TEST(LibraryBuilder, refusesNumbersThatAreNone) {
  std::vector<BvhDocument> documents = threeWalks();
  documents[2].clip.rootPositions[7].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(describe(errorOf(documents)), "right: the root's position in frame 7 is not finite");
  documents[2].clip.rootPositions[7].x() = -2e6;
  EXPECT_EQ(describe(errorOf(documents)), "right: the root's position in frame 7 is more than 1000000 m");
  documents = threeWalks();
  documents[2].clip.rotationsOf(3)[6] = Quat(0, 0, 0, 0);
  EXPECT_EQ(describe(errorOf(documents)),
            "right: the rotation of joint rightShin in frame 3 is not of unit length");
  documents = threeWalks();
  documents[0].clip.framesPerSecond = 0.0;
  EXPECT_EQ(describe(errorOf(documents)), "ahead: 0 frames a second, more than 0 expected");
}

TEST(LibraryBuilder, refusesClipsThatAreAllTooShort) {
  const Error error =
      errorOf({documentOf(walkOf({.frames = 16}), "a"), documentOf(walkOf({.frames = 12}), "b")});
  EXPECT_EQ(error.code, ErrorCode::kClipTooShort);
  EXPECT_EQ(error.message,
            "the longest clip has 16 frames (0.53 s at 30 a second); transitions of 13 need clips of 17 "
            "(0.57 s) at "
            "least");
}

TEST(LibraryBuilder, refusesWhatCannotGoOnForEverAndStillReports) {
  Result<LibraryBuilder> builder =
      LibraryBuilder::start({documentOf(walkOf({.frames = 30}), "short of a cycle")}, {});
  while (builder->step()) {
  }
  const Result<MotionLibrary> library = builder->finish();
  ASSERT_FALSE(library);
  EXPECT_EQ(library.error().code, ErrorCode::kEmptyGraph);
  EXPECT_TRUE(
      holds(library.error().message, "no 13 frames of these clips come within 0.05 m of any other 13"))
      << library.error().message;
  EXPECT_EQ(builder->report().clips[0].reason, "no 13 frames of it come within 0.05 m of any other frames");
}

}  // namespace
}  // namespace stridegraph
