#include <gtest/gtest.h>

#include "motion/bvh_texts.h"
#include "motion/bvh_writer.h"
#include "motion/captures.h"

namespace stridegraph {
namespace {

using testing::captures;
using testing::contentOf;
using testing::read;
using testing::warningsOf;

/// Units per metre that the captures' description states.
double unitsOf(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  if (name.starts_with("scaled_")) return 1.0;
  const std::string folder = file.parent_path().filename().string();
  return folder == "cmu_cgspeed_120fps" || folder == "cmu_scale_pair" ? 0.45 / 0.0254 : 100.0;
}

TEST(Captures, areReadInTheRightUnitAndAxis) {
  const std::vector<std::filesystem::path> files = captures();
  if (files.empty()) GTEST_SKIP() << testing::kNoCaptures;
  for (const std::filesystem::path& file : files) {
    const BvhDocument document = read(contentOf(file));
    EXPECT_NEAR(document.layout.unitsPerMetre, unitsOf(file), 1e-9) << file;
    EXPECT_EQ(document.layout.up, UpAxis::kY) << file;
    const double rate = file.parent_path().filename().string().starts_with("cmu_") ? 120.0 : 30.0;
    EXPECT_EQ(document.clip.framesPerSecond, rate) << file;
    // A note on the unit is due where it is not centimetres; nothing else is odd in these files.
    EXPECT_EQ(document.warnings.size(), unitsOf(file) == 100.0 ? 0U : 1U) << file << warningsOf(document);
  }
}

TEST(Captures, comeBackFromWritingUnchanged) {
  const std::vector<std::filesystem::path> files = captures();
  if (files.empty()) GTEST_SKIP() << testing::kNoCaptures;
  for (const std::filesystem::path& file : files) {
    const BvhDocument document = read(contentOf(file));
    const BvhDocument back = read(writeBvh(document.skeleton, document.layout, document.clip),
                                  {document.layout.unitsPerMetre, {}});
    EXPECT_EQ(differenceBetween(document.skeleton, back.skeleton, 1e-5), "") << file;
    EXPECT_EQ(document.layout.channels, back.layout.channels) << file;
    EXPECT_EQ(document.clip.framesPerSecond, back.clip.framesPerSecond) << file;
    EXPECT_LT(testing::greatestDistance(document, back), 1e-4) << file;
    EXPECT_LT(testing::greatestAngleDegrees(document.clip, back.clip), 0.01) << file;
  }
}

}  // namespace
}  // namespace stridegraph
