#include "motion/bvh_limits.h"

#include <gtest/gtest.h>

#include "motion/bvh_texts.h"
#include "motion/captures.h"
#include "motion/stated_limits.h"

namespace stridegraph {
namespace {

using testing::kBodyText;
using testing::read;
using testing::refusal;
using testing::replaced;
using testing::statedLimit;

TEST(BvhLimits, areThoseOfTheDocument) {
  const std::string document = testing::contentOf(STRIDEGRAPH_DOCS "/motion-files.md");
  EXPECT_EQ(statedLimit(document, "bytes of a file"), kMostBvhBytes);
  EXPECT_EQ(statedLimit(document, "joints and end sites"), kMostBvhJoints);
  EXPECT_EQ(statedLimit(document, "joints from the root to an end site"), kMostBvhDepth);
  EXPECT_EQ(statedLimit(document, "channels of a joint"), kMostBvhChannels);
  EXPECT_EQ(statedLimit(document, "bytes of a name, as UTF-8"), kMostBvhNameBytes);
  EXPECT_EQ(statedLimit(document, "frames"), kMostBvhFrames);
  EXPECT_EQ(statedLimit(document, "numbers in all rows"), kMostBvhNumbers);
  EXPECT_EQ(statedLimit(document, "rotations: frames times joints and end sites"), kMostBvhRotations);
  EXPECT_EQ(statedLimit(document, "shortest frame time, seconds"), kShortestBvhFrameSeconds);
  EXPECT_EQ(statedLimit(document, "longest frame time, seconds"), kLongestBvhFrameSeconds);
  EXPECT_EQ(statedLimit(document, "size of a number"), kLargestBvhNumber);
}

TEST(BvhLimits, holdForTheBytesOfAFile) {
  std::string text(kBodyText);
  text.resize(kMostBvhBytes + 1, '\n');
  EXPECT_EQ(refusal(text), "body.bvh: found a file of 500000001 bytes, expected at most 500000000");
  text.pop_back();
  EXPECT_EQ(read(text).clip.frameCount(), 2U);
}

/// A chain of so many joints below the root, each of which has its own line.
std::string chainOf(std::size_t joints) {
  std::string text = "HIERARCHY ROOT a\n{ OFFSET 0 0 0 CHANNELS 1 Yposition";
  for (std::size_t i = 0; i < joints; ++i) text += " JOINT b\n{ OFFSET 0 0.17 0";
  return text + std::string(joints + 1, '}') + " MOTION Frames: 1 Frame Time: 0.1 90";
}

TEST(BvhLimits, holdForTheDepth) {
  EXPECT_EQ(read(chainOf(kMostBvhDepth - 1)).skeleton.size(), kMostBvhDepth);
  EXPECT_EQ(refusal(chainOf(kMostBvhDepth)),
            "body.bvh:1001:25: found 1001 or more joints one below the other, expected at most 1000");
}

/// A root with so many joints right below it.
std::string fanOf(std::size_t joints, std::string_view motion) {
  std::string text = "HIERARCHY ROOT a\n{ OFFSET 0 0 0 CHANNELS 1 Yposition";
  for (std::size_t i = 0; i < joints; ++i) text += " JOINT b\n{ OFFSET 0 170 0 }";
  return text + "} MOTION " + std::string(motion);
}

TEST(BvhLimits, holdForTheJoints) {
  const std::string_view motion = "Frames: 1 Frame Time: 0.1 90";
  EXPECT_EQ(read(fanOf(kMostBvhJoints - 1, motion)).skeleton.size(), kMostBvhJoints);
  EXPECT_EQ(refusal(fanOf(kMostBvhJoints, motion)),
            "body.bvh:10001:26: found 10001 or more joints and end sites, expected at most 10000");
}

TEST(BvhLimits, holdForTheChannels) {
  EXPECT_EQ(refusal(replaced(kBodyText, "CHANNELS 6", "CHANNELS 7")),
            "body.bvh:5:11: found 7 channels, expected 0 to 6");
}

TEST(BvhLimits, holdForTheLengthOfANameInBytes) {
  EXPECT_EQ(
      read(replaced(kBodyText, "leg", std::string(kMostBvhNameBytes, 'x'))).skeleton.joints[3].name.size(),
      kMostBvhNameBytes);
  EXPECT_EQ(refusal(replaced(kBodyText, "leg", std::string(kMostBvhNameBytes + 1, 'x'))),
            "body.bvh:15:8: found a name of 1001 bytes, expected at most 1000");
  EXPECT_EQ(refusal(replaced(kBodyText, "leg", std::string(kMostBvhNameBytes / 2 + 1, '\xE4'))),
            "body.bvh:15:8: found a name of 1002 bytes, expected at most 1000");
  EXPECT_EQ(refusal(replaced(kBodyText, "End Site", "End " + std::string(kMostBvhNameBytes + 1, 'x'))),
            "body.bvh:10:7: found a name of 1001 bytes, expected at most 1000");
}

TEST(BvhLimits, holdForDeclaredFramesBeforeMemoryIsTaken) {
  EXPECT_EQ(refusal(replaced(kBodyText, "Frames: 2", "Frames: 1000001")),
            "body.bvh:26:9: found 1000001 frames, expected at most 1000000");
  EXPECT_EQ(read(replaced(kBodyText, "Frames: 2", "Frames: 1000000")).clip.frameCount(), 2U);
  EXPECT_EQ(refusal(fanOf(99, "Frames: 200001 Frame Time: 0.1 90")),
            "body.bvh:101:36: found 200001 frames of 100 joints, expected at most 20000000 rotations in all");
}

TEST(BvhLimits, holdForDeclaredNumbers) {
  std::string text = "HIERARCHY ROOT a\n{ OFFSET 0 0 0";
  for (int i = 0; i < 99; ++i)
    text +=
        " JOINT b\n{ OFFSET 0 1 0 CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation }";
  text += "}\nMOTION\nFrames: 150000\nFrame Time: 0.1\n";
  EXPECT_EQ(refusal(text),
            "body.bvh:103:9: found 150000 frames of 594 numbers, expected at most 60000000 numbers in all");
}

TEST(BvhLimits, holdForRowsThatWereNotDeclared) {
  std::string rows = "Frames: 1\nFrame Time: 0.1\n";
  for (std::size_t i = 0; i < 2'001; ++i) rows += "90\n";
  EXPECT_EQ(refusal(fanOf(9'999, rows)),
            "body.bvh:12003:1: found more rotations, rows times joints, than the limit, expected at most "
            "20000000");
  rows = "Frames: 1\nFrame Time: 0.1\n";
  for (std::size_t i = 0; i <= kMostBvhFrames; ++i) rows += "9\n";
  EXPECT_EQ(refusal(fanOf(0, rows)),
            "body.bvh:1000004:1: found more rows than the limit, expected at most 1000000");
}

TEST(BvhLimits, holdForTheSizeOfNumbers) {
  EXPECT_EQ(read(replaced(kBodyText, "1 90 0 10", "1 90 0 1e9")).clip.frameCount(), 2U);
  EXPECT_EQ(
      refusal(replaced(kBodyText, "1 90 0 10", "1 90 0 -1.000001e9")),
      "body.bvh:29:8: found \"-1.000001e9\", expected a channel's value, finite and at most 1e9 in size");
}

}  // namespace
}  // namespace stridegraph
