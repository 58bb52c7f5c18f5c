#include <gtest/gtest.h>

#include "base/utf8.h"
#include "motion/bvh_texts.h"
#include "motion/captures.h"

namespace stridegraph {
namespace {

using testing::warningsOf;

std::string bytesOf(std::string_view name) {
  return testing::contentOf(std::string(STRIDEGRAPH_TEST_DATA "/cases/") + std::string(name));
}

BvhDocument readCase(std::string_view name) {
  return testing::read(bytesOf(name));
}

/// The same walk as in straight.bvh, or its first frames.
void expectStraight(const BvhDocument& document, std::size_t frames = 160) {
  const BvhDocument straight = readCase("straight.bvh");
  ASSERT_EQ(document.clip.frameCount(), frames);
  ASSERT_EQ(document.skeleton.size(), straight.skeleton.size());
  EXPECT_EQ(document.clip.framesPerSecond, 30.0);
  EXPECT_EQ(document.layout.unitsPerMetre, straight.layout.unitsPerMetre);
  for (std::size_t j = 0; j < straight.skeleton.size(); ++j) {
    EXPECT_EQ(document.skeleton.joints[j].parent, straight.skeleton.joints[j].parent);
    EXPECT_EQ(document.skeleton.joints[j].offset, straight.skeleton.joints[j].offset);
    EXPECT_EQ(document.skeleton.joints[j].isEndSite, straight.skeleton.joints[j].isEndSite);
  }
  for (std::size_t f = 0; f < frames; ++f) {
    EXPECT_EQ(document.clip.rootPositions[f], straight.clip.rootPositions[f]) << f;
    for (std::size_t j = 0; j < straight.skeleton.size(); ++j)
      EXPECT_EQ(document.clip.pose(f).rotations[j].coeffs(), straight.clip.pose(f).rotations[j].coeffs());
  }
}

TEST(BvhCases, readsTheSoundClipWithoutAWord) {
  const BvhDocument straight = readCase("straight.bvh");
  expectStraight(straight);
  EXPECT_EQ(warningsOf(straight), "");
}

TEST(BvhCases, refusesRowsThatAllHaveThreeNumbersMore) {
  EXPECT_EQ(testing::refusal(bytesOf("rows_with_three_numbers_more.bvh")),
            "body.bvh:120:1: found 63 numbers in a row, expected 60, one for each channel in HIERARCHY");
}

TEST(BvhCases, refusesAShortRowByItsLine) {
  EXPECT_EQ(testing::refusal(bytesOf("short_row.bvh")),
            "body.bvh:122:1: found 57 numbers in a row, expected 60, one for each channel in HIERARCHY");
}

TEST(BvhCases, readsEndSitesWithNames) {
  const BvhDocument document = readCase("end_sites_with_names.bvh");
  expectStraight(document);
  EXPECT_EQ(warningsOf(document), "");
  EXPECT_EQ(differenceBetween(readCase("straight.bvh").skeleton, document.skeleton), "");
  EXPECT_EQ(document.layout.endSiteNames[5], "Site1");
}

TEST(BvhCases, readsNamesInWindows1252) {
  const BvhDocument document = readCase("latin1_names.bvh");
  expectStraight(document);
  EXPECT_EQ(document.skeleton.joints[0].name, "H\xC3\xBC\x66te");
  for (const Joint& joint : document.skeleton.joints) EXPECT_TRUE(isUtf8(joint.name)) << joint.name;
  ASSERT_EQ(document.warnings.size(), 1U);
  EXPECT_EQ(document.warnings[0].topic, WarningTopic::kText);
  EXPECT_EQ(
      warningsOf(document),
      "body.bvh:2: found text that is not UTF-8 and read it as Windows-1252: \"H\xC3\xBC\x66te\" (line 2), "
      "\"Fu\xC3\x9FL\" (line 14), \"Fu\xC3\x9FR\" (line 38), \"Wirbels\xC3\xA4ule\" (line 54), "
      "\"Sch\xC3\xA4\x64\x65l\" (line 104)\n");
}

TEST(BvhCases, readsUtf16) {
  const BvhDocument document = readCase("utf16.bvh");
  expectStraight(document);
  EXPECT_EQ(differenceBetween(readCase("straight.bvh").skeleton, document.skeleton), "");
  EXPECT_EQ(warningsOf(document), "");
}

TEST(BvhCases, readsAFrameTimeInMilliseconds) {
  const BvhDocument document = readCase("frame_time_in_ms.bvh");
  expectStraight(document, 64);
  ASSERT_EQ(document.warnings.size(), 1U);
  EXPECT_EQ(document.warnings[0].topic, WarningTopic::kTime);
  EXPECT_EQ(
      warningsOf(document),
      "body.bvh:119:13: found a frame time of 33.333333 and read it as milliseconds: 30 frames a second\n");
}

TEST(BvhCases, readsOneFrameMoreThanDeclaredWithANote) {
  const BvhDocument document = readCase("one_frame_more.bvh");
  expectStraight(document);
  ASSERT_EQ(document.warnings.size(), 1U);
  EXPECT_EQ(document.warnings[0].topic, WarningTopic::kRows);
  EXPECT_EQ(
      warningsOf(document),
      "body.bvh:279:1: 159 frames are declared, 160 complete rows of 60 numbers were found; the complete "
      "rows are used\n");
}

}  // namespace
}  // namespace stridegraph
