#include "graph/library_limits.h"

#include <gtest/gtest.h>

#include "graph/library_checks.h"
#include "graph/test_library.h"
#include "motion/captures.h"
#include "motion/stated_limits.h"

namespace stridegraph {
namespace {

using testing::documentOf;
using testing::statedLimit;
using testing::threeWalks;
using testing::walker;
using testing::walkOf;

/// A clip that never moves, of so many frames at a rate.
BvhDocument still(std::size_t frames, double framesPerSecond) {
  Clip clip = walkOf({.frames = 1});
  clip.framesPerSecond = framesPerSecond;
  clip.rootPositions.resize(frames, clip.rootPositions.front());
  const std::vector<Quat> pose = clip.rotations;
  clip.rotations.reserve(frames * pose.size());
  for (std::size_t f = 1; f < frames; ++f)
    clip.rotations.insert(clip.rotations.end(), pose.begin(), pose.end());
  return documentOf(std::move(clip), "still");
}

std::string refusal(std::vector<BvhDocument> clips, const LibraryParams& params = {}) {
  const auto builder = LibraryBuilder::start(std::move(clips), params);
  return builder ? "taken in" : describe(builder.error());
}

TEST(LibraryLimits, areThoseOfTheDocument) {
  const std::string document = testing::contentOf(STRIDEGRAPH_DOCS "/motion-files.md");
  EXPECT_EQ(statedLimit(document, "frames of a library, at its rate, mirror images among them"),
            kMostLibraryFrames);
  EXPECT_EQ(statedLimit(document, "pairs of frames that are compared"), kMostLibraryPairs);
  EXPECT_EQ(statedLimit(document, "pairs of alike pieces that are found"), kMostLibraryRegions);
  EXPECT_EQ(statedLimit(document, "rotations of a library: frames times joints and end sites"),
            kMostLibraryRotations);
  EXPECT_EQ(statedLimit(document, "frames that resampling makes of one"), kMostFramesForOne);
  EXPECT_EQ(statedLimit(document, "clips of a library, mirror images and pieces of cut clips among them"),
            kMostLibraryClips);
  EXPECT_EQ(statedLimit(document, "notes"), kMostLibraryNotes);
  EXPECT_EQ(statedLimit(document, "bytes of a note"), kMostNoteBytes);
  EXPECT_EQ(statedLimit(document, "bytes of the licence line"), kMostLicenseBytes);
}

TEST(LibraryLimits, ofParametersAreDocumentedAsTheyAreRefused) {
  const std::string document = testing::contentOf(STRIDEGRAPH_DOCS "/motion-files.md");
  const auto states = [&](std::string_view row) { return document.find(row) != std::string::npos; };
  EXPECT_TRUE(states("| Frames of a transition | 2 to 120 |"));
  EXPECT_FALSE(faultIn(LibraryParams{.transitionFrames = 2}));
  EXPECT_FALSE(faultIn(LibraryParams{.transitionFrames = 120}));
  EXPECT_TRUE(faultIn(LibraryParams{.transitionFrames = 121}));
  EXPECT_TRUE(states("| Frames a second | 1 to 240 |"));
  EXPECT_FALSE(faultIn(LibraryParams{.framesPerSecond = 240.0}));
  EXPECT_TRUE(faultIn(LibraryParams{.framesPerSecond = 240.5}));
  EXPECT_TRUE(states("| Transitions kept | 15,000, or as asked: 1,000 or more |"));
  EXPECT_EQ(LibraryParams{}.mostTransitions, 15'000U);
  EXPECT_TRUE(faultIn(LibraryParams{.mostTransitions = 999}));
}

TEST(LibraryLimits, holdForFramesThatResamplingMultiplies) {
  EXPECT_EQ(
      refusal({still(64, 0.03)}),
      "still: found 0.03 frames a second, expected at least 2.5: the library's 30 may be at most 12 times as "
      "many");
  EXPECT_EQ(refusal({still(64, 2.49)}).substr(0, 36), "still: found 2.49 frames a second, e");
  EXPECT_EQ(refusal({still(64, 2.5)}), "taken in");
  EXPECT_EQ(
      refusal({still(64, 19.9)}, {.framesPerSecond = 240.0}),
      "still: found 19.9 frames a second, expected at least 20: the library's 240 may be at most 12 times as "
      "many");
  EXPECT_EQ(refusal({still(64, 1e-9)}).substr(0, 12), "still: found");
  EXPECT_EQ(refusal({still(64, 10'000)}), "taken in");
}

TEST(LibraryLimits, holdForTheFramesOfAllClipsTogether) {
  EXPECT_EQ(refusal({still(kMostLibraryFrames, 30)}), "taken in");
  EXPECT_EQ(refusal({still(kMostLibraryFrames, 30), still(1, 30)}),
            "still: found 250001 frames with this clip, expected at most 250000 in a library (at 30 frames a "
            "second)");
  EXPECT_EQ(refusal({still(62'501, 15)}, {.framesPerSecond = 60.0}),
            "still: found 250001 frames with this clip, expected at most 250000 in a library (at 60 frames a "
            "second)");
  EXPECT_EQ(refusal({still(125'001, 30)}, {.mirror = true}),
            "still: found 250002 frames with this clip, expected at most 250000 in a library (at 30 frames a "
            "second, "
            "mirror images among them)");
}

TEST(LibraryLimits, holdForFramesThatAreAppended) {
  const MotionLibrary library = testing::builtFrom(threeWalks()).library;
  const std::size_t room = kMostLibraryFrames - library.frames.frameCount();
  EXPECT_TRUE(LibraryBuilder::append(library, {still(room, 30)}));
  const auto refused = LibraryBuilder::append(library, {still(room + 1, 30)});
  ASSERT_FALSE(refused);
  EXPECT_TRUE(refused.error().message.starts_with("found 250001 frames with this clip"))
      << refused.error().message;
}

TEST(LibraryLimits, holdForAlikePiecesWhileTheyAreFound) {
  // Each of 3,500 frames is like each other one, and neighbours are all kept.
  auto builder = LibraryBuilder::start(
      {still(3'500, 30)}, {.transitionFrames = 2, .neighbourFrames = 0, .largestSpanRatio = 1.0});
  ASSERT_TRUE(builder);
  while (builder->step()) {
  }
  EXPECT_LT(builder->progress(), 1.0 + 1e-9);
  EXPECT_LT(builder->report().framePairs, 3'500U * 3'501U / 2U) << "it stops at once";
  const auto library = builder->finish();
  ASSERT_FALSE(library);
  EXPECT_EQ(library.error().code, ErrorCode::kInvalidArgument);
  EXPECT_TRUE(library.error().message.starts_with("found more than 5000000 pairs of alike pieces"))
      << library.error().message;
}

TEST(LibraryLimits, holdForRotations) {
  std::vector<BvhDocument> clips = {still(1, 30)};
  const std::size_t joints = kMostLibraryRotations / 100;
  clips[0].skeleton.joints.resize(joints);
  clips[0].clip.rootPositions.resize(100);
  EXPECT_FALSE(faultInAmount(clips, {}));
  clips[0].clip.rootPositions.resize(101);
  const auto fault = faultInAmount(clips, {});
  ASSERT_TRUE(fault);
  EXPECT_EQ(describe(*fault),
            "still: found 101 frames of 200000 joints with this clip, expected at most 20000000 rotations in "
            "a library");
}

}  // namespace
}  // namespace stridegraph
