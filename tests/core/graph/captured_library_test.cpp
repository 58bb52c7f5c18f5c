#include <gtest/gtest.h>

#include <algorithm>
#include <bit>

#include "graph/graph_building.h"
#include "graph/library_builder.h"
#include "graph/library_checks.h"
#include "graph/pose_distance.h"
#include "graph/sgraph_file.h"
#include "graph/similarity.h"
#include "motion/captures.h"

namespace stridegraph {
namespace {

using testing::captures;
using testing::contentOf;

std::vector<BvhDocument> documentsIn(std::string_view folder) {
  std::vector<BvhDocument> documents;
  for (const auto& file : captures(folder))
    documents.push_back(std::move(*readBvh(contentOf(file), file.stem().string())));
  return documents;
}

BuiltLibrary builtFrom(std::string_view folder, const LibraryParams& params = {}) {
  return std::move(*buildLibrary(documentsIn(folder), params));
}

/// Share of the frames on which at least one foot joint stands.
double standingShare(const MotionLibrary& library) {
  const auto standing = std::count_if(library.contacts.begin(), library.contacts.end(),
                                      [](ContactMask mask) { return mask != 0; });
  return static_cast<double>(standing) / static_cast<double>(library.contacts.size());
}

TEST(CapturedWalks, ofCmu16KeepMostOfTheirFramesInOnePart) {
  if (captures("cmu16_walk").empty()) GTEST_SKIP() << testing::kNoCaptures;
  const BuiltLibrary built = builtFrom("cmu16_walk", {.largestSpanRatio = 1.0});
  EXPECT_EQ(faultIn(built.library).value_or(""), "");
  // An independent experiment, with regions of equal length alone, found 3094 transitions and kept 1857 of
  // them in 24 of the 26 clips. The one more that is lost here is 16_29, whose foot slips so early that
  // neither part of it is long enough.
  EXPECT_NEAR(static_cast<double>(built.report.transitionsBeforePruning), 3094.0, 250.0);
  EXPECT_NEAR(static_cast<double>(built.report.transitions), 1857.0, 150.0);
  EXPECT_GT(built.report.survivingShare, 0.64);
  EXPECT_EQ(std::count_if(built.report.clips.begin(), built.report.clips.end(),
                          [](const ClipFate& fate) { return fate.survivingFrames > 0; }),
            23);
  EXPECT_NEAR(built.library.facingOffset.angle().degrees(), -0.6, 0.1);
  EXPECT_EQ(built.library.contactJoints.size(), 6U);
  EXPECT_GT(standingShare(built.library), 0.99);
  // The arm that jumps by 81 degrees after its first frame is named, and two joints that slip.
  ASSERT_GE(built.report.warnings.size(), 3U);
  EXPECT_EQ(std::count_if(built.report.warnings.begin(), built.report.warnings.end(),
                          [](const Warning& warning) { return !warning.place.file.empty(); }),
            3);
  EXPECT_NE(built.report.warnings[0].message.find("rhumerus turns 81 degrees from frame 0 to 1"),
            std::string::npos);
  EXPECT_NE(built.report.warnings[2].message.find("lfoot slips by 45 degrees from frame 25 to 26"),
            std::string::npos);
  EXPECT_EQ(readSgraph(writeSgraph(built.library))->hash, built.library.hash);
}

TEST(CapturedWalks, ofMoreClipsConnectWhereTimeIsWarped) {
  if (captures("cmu16_walk").empty()) GTEST_SKIP() << testing::kNoCaptures;
  const BuiltLibrary equal = builtFrom("cmu16_walk", {.largestSpanRatio = 1.0});
  const BuiltLibrary built = builtFrom("cmu16_walk");
  EXPECT_EQ(faultIn(built.library).value_or(""), "");
  const auto used = [](const BuiltLibrary& library) {
    return std::count_if(library.report.clips.begin(), library.report.clips.end(),
                         [](const ClipFate& fate) { return fate.survivingFrames > 0; });
  };
  EXPECT_GE(used(built), used(equal) + 2);
  EXPECT_GT(built.report.survivingShare, equal.report.survivingShare + 0.02);
  EXPECT_GT(built.report.transitionsBeforePruning, equal.report.transitionsBeforePruning);
  EXPECT_LT(static_cast<double>(built.report.transitionsBeforePruning),
            1.15 * static_cast<double>(equal.report.transitionsBeforePruning));
}

TEST(CapturedWalks, growToTheSameLibraryAsAtOnce) {
  if (captures("accad_male1_walk").empty()) GTEST_SKIP() << testing::kNoCaptures;
  std::vector<BvhDocument> documents = documentsIn("accad_male1_walk");
  const std::vector<BvhDocument> last(documents.end() - 3, documents.end());
  for (const bool mirror : {false, true}) {
    const BuiltLibrary atOnce = builtFrom("accad_male1_walk", {.mirror = mirror});
    const MotionLibrary base =
        buildLibrary({documents.begin(), documents.end() - 3}, {.mirror = mirror})->library;
    Result<LibraryBuilder> builder = LibraryBuilder::append(base, last);
    while (builder->step()) {
    }
    EXPECT_EQ(builder->finish()->hash, atOnce.library.hash);
    EXPECT_LT(builder->report().framePairs, atOnce.report.framePairs);
  }
}

TEST(CapturedWalks, ofAccadKeepMostOfTheirFramesInOnePart) {
  if (captures("accad_male1_walk").empty()) GTEST_SKIP() << testing::kNoCaptures;
  const BuiltLibrary built = builtFrom("accad_male1_walk");
  EXPECT_EQ(faultIn(built.library).value_or(""), "");
  EXPECT_NEAR(static_cast<double>(built.report.transitionsBeforePruning), 2452.0, 200.0);
  EXPECT_NEAR(static_cast<double>(built.report.transitions), 2097.0, 150.0);
  // Beside both ends of every clip, 67 and 24 frames beside slips are missing.
  EXPECT_NEAR(built.report.survivingShare, 0.848, 0.01);
  for (const ClipFate& fate : built.report.clips) EXPECT_GT(fate.survivingFrames, 0U) << fate.name;
  EXPECT_NEAR(built.library.facingOffset.angle().degrees(), -83.5, 0.1);
  EXPECT_EQ(built.library.contactJoints.size(), 6U);
  EXPECT_GT(standingShare(built.library), 0.99);
}

TEST(CapturedWalks, connectBetterWhenMirrored) {
  if (captures("cmu16_walk").empty()) GTEST_SKIP() << testing::kNoCaptures;
  const BuiltLibrary built = builtFrom("cmu16_walk", {.mirror = true});
  EXPECT_EQ(built.library.clips.size(), 52U);
  EXPECT_NEAR(static_cast<double>(built.report.transitionsBeforePruning), 11754.0, 900.0);
  EXPECT_NEAR(built.library.facingOffset.angle().degrees(), 0.0, 0.05);
  for (const ClipFate& fate : built.report.clips) {
    // Its foot slips: neither part is long enough to connect.
    const bool slips = fate.name.starts_with("16_29");
    EXPECT_EQ(fate.survivingFrames > 0U, !slips) << fate.name;
  }
}

TEST(CapturedWalks, areComparedAsTheReferenceDoes) {
  if (captures("accad_male1_walk").empty()) GTEST_SKIP() << testing::kNoCaptures;
  const std::vector<BvhDocument> documents = documentsIn("accad_male1_walk");
  const Skeleton& skeleton = documents[0].skeleton;
  const std::vector<Clip> clips = {documents[0].clip, documents[7].clip};
  const FeatureBasis basis = featureBasis(skeleton, clips);
  const ClipFeatures a(skeleton, basis, clips[0]);
  const ClipFeatures b(skeleton, basis, clips[1]);
  DistanceRows rows(a, b);
  std::size_t row = 0;
  while (const std::size_t count = rows.advance()) {
    for (std::size_t k = 0; k < count; ++k, ++row) {
      for (std::size_t c = row % 7; c < b.windowCount(); c += 29) {
        const double expected =
            poseDistanceMetres(skeleton, clips[0], row + kWindowReach, clips[1], c + kWindowReach);
        ASSERT_NEAR(static_cast<double>(rows.row(k)[c]) / kMicrometresPerMetre, expected, 1e-5);
      }
    }
  }
}

TEST(CapturedJogs, areTooShortToConnectWell) {
  if (captures("cmu16_jog").empty()) GTEST_SKIP() << testing::kNoCaptures;
  const Result<BuiltLibrary> built = buildLibrary(documentsIn("cmu16_jog"));
  if (built) {
    EXPECT_LT(built->report.survivingShare, 0.05);
  } else {
    EXPECT_EQ(built.error().code, ErrorCode::kEmptyGraph);
  }
}

}  // namespace
}  // namespace stridegraph
