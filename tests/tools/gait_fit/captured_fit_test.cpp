#include <gtest/gtest.h>

#include "gait_fit/held_out.h"
#include "gait_fit/retarget.h"
#include "motion/bvh_reader.h"
#include "motion/captures.h"

namespace stridegraph::gait_fit {
namespace {

/// The captures of a folder whose names begin with one of `takes`; all when there are none.
std::vector<Clip> clipsOf(std::string_view folder, const std::vector<std::string>& takes) {
  std::vector<Clip> clips;
  for (const auto& path : stridegraph::testing::captures(folder)) {
    const std::string name = path.stem().string();
    bool wanted = takes.empty();
    for (const std::string& take : takes) wanted = wanted || name.rfind(take, 0) == 0;
    if (!wanted) continue;
    const auto document = readBvh(stridegraph::testing::contentOf(path), name);
    EXPECT_TRUE(document.has_value()) << name;
    const auto pieces = onGaitBody(document->skeleton, std::span(&document->clip, 1), Gait::kWalk);
    EXPECT_TRUE(pieces.has_value()) << name;
    clips.insert(clips.end(), pieces->begin(), pieces->end());
  }
  return clips;
}

Result<HeldOutFigures> figuresOf(std::vector<Clip> clips, Gait gait) {
  auto fit = fitGait(std::move(clips), fitParamsFor(gait));
  if (!fit) return fail(std::move(fit));
  return measureHeldOut(*fit);
}

TEST(CapturedWalk, isToldToFiveAndAHalfDegreesByAModelThatHasNotSeenIt) {
  const auto clips = clipsOf("cmu16_walk", {});
  if (clips.empty()) GTEST_SKIP() << stridegraph::testing::kNoCaptures;
  const auto figures = figuresOf(clips, Gait::kWalk);
  ASSERT_TRUE(figures.has_value());
  EXPECT_LE(figures->heldOut.allJoints, 5.5);
  EXPECT_LE(figures->straightMeanCentimetres, 2.5);
  EXPECT_NEAR(figures->lean.heldOut / figures->lean.captured, 1.0, 0.1);
}

TEST(CapturedJog, isToldToEightAndAHalfDegreesByAModelThatHasNotSeenIt) {
  const auto clips =
      clipsOf("cmu16_jog", {"16_35", "16_36", "16_37", "16_38", "16_39", "16_40", "16_42", "16_44"});
  if (clips.empty()) GTEST_SKIP() << stridegraph::testing::kNoCaptures;
  const auto figures = figuresOf(clips, Gait::kJog);
  ASSERT_TRUE(figures.has_value());
  EXPECT_LE(figures->heldOut.allJoints, 8.5);
  EXPECT_LE(figures->straightMeanCentimetres, 4.5);
  EXPECT_NEAR(figures->lean.heldOut / figures->lean.captured, 1.0, 0.1);
}

}  // namespace
}  // namespace stridegraph::gait_fit
