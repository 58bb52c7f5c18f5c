#include "graph/build_advice.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "graph/test_library.h"
#include "motion/gait_skeleton.h"
#include "motion/gait_synthesis.h"

namespace stridegraph {
namespace {

using testing::documentOf;
using testing::threeWalks;
using testing::walker;
using testing::walkOf;

BvhDocument gaitOf(const GaitRequest& request) {
  return {gaitSkeleton(), gaitBvhLayout(), *synthesiseGait(request), {}};
}

/// Synthesised clips that make no library with the usual parameters, or one that holds next to nothing.
struct Case {
  const char* name;
  std::vector<BvhDocument> documents;
};

std::vector<Case> failingCases() {
  std::vector<Case> cases;
  cases.push_back({"little more than a stride", {gaitOf({.name = "gait", .segments = {{1.4, 1.3}}})}});
  cases.push_back(
      {"a turn", {gaitOf({.name = "gait", .segments = {{0.8, 1.0}, {1.0, 1.0, 1.5}, {0.6, 1.0}}})}});
  cases.push_back({"a start", {gaitOf({.name = "gait", .segments = {{0.5, 0.0}, {1.2, 1.3}}})}});
  cases.push_back({"a jog", {gaitOf({.name = "gait", .segments = {{0.9, 2.8, 0.0, Gait::kJog}}})}});
  cases.push_back(
      {"uneven steps", {gaitOf({.name = "gait", .segments = {{2.0, 1.1}, {1.0, 1.6}}, .variation = 2.0})}});
  cases.push_back({"two of a kind",
                   {gaitOf({.name = "gait", .segments = {{1.3, 1.2}}}),
                    gaitOf({.name = "gait", .segments = {{1.2, 1.4}}, .startPhase = 2.0})}});
  for (std::uint64_t seed = 1; seed <= 4; ++seed)
    cases.push_back({"wandering", {documentOf(testing::wanderingClip(walker(), 120, seed), "wandering")}});
  return cases;
}

std::string errorOf(const std::vector<BvhDocument>& documents, const LibraryParams& params) {
  const Result<BuiltLibrary> built = buildLibrary(documents, params);
  return built ? std::string() : built.error().message;
}

/// The number behind `label` in a text; empty where there is none.
std::optional<double> numberAfter(const std::string& text, std::string_view label) {
  const std::size_t at = text.find(label);
  if (at == std::string::npos) return {};
  return std::strtod(text.c_str() + at + label.size(), nullptr);
}

/// The sentence that begins like that; empty where there is none.
std::string sentenceOf(const std::string& text, std::string_view beginning) {
  const std::size_t at = text.find(beginning);
  if (at == std::string::npos) return {};
  const std::size_t end = text.find(". ", at);
  return text.substr(at, end == std::string::npos ? end : end - at);
}

TEST(BuildAdvice, isTrueWhateverItNames) {
  const LibraryParams usual{.thresholdMetres = 0.02};
  std::size_t thresholds = 0;
  std::size_t mirrors = 0;
  for (const Case& one : failingCases()) {
    const std::string advice = errorOf(one.documents, usual);
    if (advice.empty()) continue;
    const std::string larger = sentenceOf(advice, "With a threshold of ");
    if (const auto metres = numberAfter(larger, "--threshold ")) {
      ++thresholds;
      const auto built = buildLibrary(one.documents, {.thresholdMetres = *metres});
      ASSERT_TRUE(built) << one.name << ": " << advice;
      EXPECT_EQ(
          numberAfter(larger, "one could: "),
          std::round(built->report.survivingShare * static_cast<double>(built->library.frames.frameCount())))
          << one.name << ": " << advice;
      EXPECT_NE(errorOf(one.documents, {.thresholdMetres = *metres - 0.001}), "")
          << one.name << ": " << advice;
    }
    const std::string mirror = sentenceOf(advice, "With mirror images");
    if (!mirror.empty()) {
      ++mirrors;
      const double metres = numberAfter(mirror, "--threshold ").value_or(usual.thresholdMetres);
      EXPECT_EQ(errorOf(one.documents, {.thresholdMetres = metres, .mirror = true}), "")
          << one.name << ": " << advice;
    }
    if (advice.find("No threshold up to 0.3 m would do") != std::string::npos) {
      EXPECT_NE(errorOf(one.documents, {.thresholdMetres = 0.3}), "") << one.name << ": " << advice;
    }
  }
  EXPECT_GE(thresholds, 6U);
  EXPECT_GE(mirrors, 1U);
}

TEST(BuildAdvice, saysThatClipsAreTooShortForAStride) {
  const std::string advice = errorOf({documentOf(walkOf({.frames = 30}), "short of a cycle")}, {});
  EXPECT_TRUE(
      advice.starts_with("no walk could go on for ever: no 13 frames of these clips come within 0.05 m of "
                         "any other 13. "))
      << advice;
  EXPECT_NE(advice.find(
                "The longest clip lasts 1.0 s. A stride of walking takes about 1.1 s, and the way back into "
                "it 17 frames (0.6 s) more, so that clips of steady walking should last 1.7 s at least"),
            std::string::npos)
      << advice;
}

TEST(BuildAdvice, saysThatNothingWalks) {
  GaitRequest request{.name = "gait", .segments = {{1.0, 0.0}}};
  const std::string advice = errorOf({gaitOf(request)}, {.thresholdMetres = 1e-4});
  EXPECT_NE(advice.find("Nothing in the clips walks: the fastest half second goes at 0.0"), std::string::npos)
      << advice;
}

TEST(BuildAdvice, saysThatAllIsOnePose) {
  Clip clip{"still", 30.0, walker().size(), {}, {}};
  for (int f = 0; f < 60; ++f) clip.append(testing::restPose(walker(), {0.0, 0.9, 0.0}).view());
  EXPECT_EQ(errorOf({documentOf(clip, "still")}, {}),
            "no walk could go on for ever: every frame shows the same pose");
}

/// The warnings of the topic kGraph that name no clip.
std::vector<std::string> limitsIn(const BuiltLibrary& built) {
  std::vector<std::string> limits;
  for (const Warning& warning : built.report.warnings) {
    if (warning.topic == WarningTopic::kGraph && warning.place.file.empty())
      limits.push_back(warning.message);
  }
  return limits;
}

bool isSaid(const std::vector<std::string>& limits, std::string_view beginning) {
  return std::any_of(limits.begin(), limits.end(),
                     [&](const std::string& limit) { return limit.starts_with(beginning); });
}

TEST(GraphLimits, nameWalksThatOnlyCurveToOneSide) {
  const auto limitsAt = [](double degreesPerSecond, bool mirror) {
    const Clip walk = walkOf({.frames = 80, .turnPerSecond = Angle::degrees(degreesPerSecond)});
    std::vector<BvhDocument> documents = {documentOf(walk, "walk")};
    // With its one arm in the middle the body is symmetric.
    documents[0].skeleton.joints[10].offset = Vec3::Zero();
    return limitsIn(*buildLibrary(std::move(documents), {.mirror = mirror}));
  };
  EXPECT_TRUE(isSaid(limitsAt(30.0, false),
                     "walks can only curve to the left, by 30 degrees a second: mirror images of the clips "
                     "(--mirror) turn right as much"));
  EXPECT_TRUE(isSaid(limitsAt(-30.0, false), "walks can only curve to the right, by 30 degrees a second: "));
  EXPECT_TRUE(
      isSaid(limitsAt(0.0, false), "walks go straight on only: they turn by 0.0 degrees a second at most"));
  // What is advised helps.
  EXPECT_FALSE(isSaid(limitsAt(30.0, true), "walks can only curve"));
}

TEST(GraphLimits, nameTurnsToOneSideBesideStraightWalks) {
  std::vector<BvhDocument> documents = threeWalks();
  documents.pop_back();
  EXPECT_TRUE(isSaid(limitsIn(*buildLibrary(documents)),
                     "walks can turn to the left only, by 40.0 degrees a second"));
  EXPECT_FALSE(isSaid(limitsIn(*buildLibrary(threeWalks())), "walks can"));
}

TEST(GraphLimits, nameTheSlowestSpeedOfALibraryThatNeverStands) {
  EXPECT_TRUE(isSaid(limitsIn(*buildLibrary(threeWalks())),
                     "nothing stands: the slowest half second of the graph goes at 1.20 m/s"));
}

TEST(GraphLimits, nameLibrariesThatLeadNowhere) {
  // The body marks time.
  const std::vector<std::string> limits = limitsIn(
      *buildLibrary({documentOf(walkOf({.frames = 80, .speedMetresPerSecond = 0.0}), "on the spot")}));
  EXPECT_TRUE(isSaid(limits, "nothing walks: the fastest half second of the graph goes at 0.00 m/s"));
  EXPECT_FALSE(isSaid(limits, "nothing stands"));
}

TEST(GraphLimits, areNoneOfALibraryThatStandsWalksAndTurnsBothWays) {
  std::vector<BvhDocument> documents;
  for (const double side : {1.0, -1.0}) {
    GaitRequest request{.name = "gait",
                        .segments = {{2.0, 0.0}, {3.0, 1.2}, {1.5, 1.0, 1.2 * side}, {3.0, 1.2}, {2.0, 0.0}}};
    request.seed = side > 0.0 ? 1 : 2;
    documents.push_back(gaitOf(request));
  }
  EXPECT_EQ(limitsIn(*buildLibrary(documents, {.thresholdMetres = 0.06})), std::vector<std::string>());
}

TEST(GraphLimits, tellWhatWouldBringMoreFramesIn) {
  std::vector<BvhDocument> documents = {documentOf(walkOf({.frames = 60}), "walk")};
  for (std::uint64_t k = 0; k < 3; ++k)
    documents.push_back(documentOf(testing::wanderingClip(walker(), 400, 70 + k), "wandering"));
  const BuiltLibrary built = *buildLibrary(documents);
  const std::vector<std::string> limits = limitsIn(built);
  ASSERT_TRUE(isSaid(limits, "only "));
  const auto metres = numberAfter(limits.front(), "--threshold ");
  ASSERT_TRUE(metres) << limits.front();
  const BuiltLibrary larger = *buildLibrary(documents, {.thresholdMetres = *metres});
  EXPECT_GE(larger.report.survivingShare, kUsefulShare) << limits.front();
}

}  // namespace
}  // namespace stridegraph
