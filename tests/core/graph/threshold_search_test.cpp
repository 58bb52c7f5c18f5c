#include "graph/threshold_search.h"

#include <gtest/gtest.h>

#include "graph/clip_intake.h"
#include "graph/test_library.h"

namespace stridegraph {
namespace {

using testing::documentOf;
using testing::threeWalks;
using testing::walker;
using testing::walkOf;

/// What is searched: clips as a library holds them, without a graph.
struct Draft {
  MotionLibrary library;
  std::vector<Jerk> jerks;
  std::vector<ClipFeatures> features;
};

Draft draftOf(const std::vector<BvhDocument>& documents, const LibraryParams& params = {}) {
  Draft draft;
  draft.library.skeleton = walker();
  draft.library.params = params;
  ClipIntake intake(walker(), params);
  Warnings warnings;
  for (const BvhDocument& document : documents) intake.add(document.clip, warnings);
  intake.collect(draft.library);
  draft.jerks = findJerks(draft.library);
  const FeatureBasis basis = featureBasis(walker(), intake.clips());
  for (const Clip& clip : intake.clips()) draft.features.emplace_back(walker(), basis, clip);
  return draft;
}

std::optional<ThresholdFinding> foundIn(Draft draft, const ThresholdGoal& goal) {
  ThresholdSearch search(draft.library, draft.jerks, std::move(draft.features), goal);
  double progress = search.progress();
  while (search.step()) {
    EXPECT_GE(search.progress(), progress);
    progress = search.progress();
  }
  EXPECT_EQ(search.progress(), 1.0);
  EXPECT_FALSE(search.step());
  return search.found();
}

/// Motion that never quite repeats itself.
std::vector<BvhDocument> wandering(std::uint64_t seed, std::size_t clips = 1) {
  std::vector<BvhDocument> documents;
  for (std::size_t c = 0; c < clips; ++c)
    documents.push_back(documentOf(testing::wanderingClip(walker(), 150, 10 * seed + c), "wandering"));
  return documents;
}

bool canBeBuilt(const std::vector<BvhDocument>& documents, double thresholdMetres) {
  return buildLibrary(documents, {.thresholdMetres = thresholdMetres}).has_value();
}

TEST(ThresholdSearch, findsTheSmallestThresholdThatMakesALibrary) {
  std::size_t found = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    for (const std::size_t clips : {1U, 3U}) {
      const std::vector<BvhDocument> documents = wandering(seed, clips);
      const auto finding = foundIn(draftOf(documents), {.fromMetres = 0.01});
      if (!finding) {
        EXPECT_FALSE(canBeBuilt(documents, 0.3)) << seed;
        continue;
      }
      ++found;
      EXPECT_TRUE(canBeBuilt(documents, finding->thresholdMetres)) << seed;
      EXPECT_FALSE(canBeBuilt(documents, finding->thresholdMetres - 0.001)) << seed;
    }
  }
  EXPECT_GE(found, 6U);
}

TEST(ThresholdSearch, tellsHowManyFramesTheGraphThenPlays) {
  const std::vector<BvhDocument> documents = wandering(2, 2);
  const auto finding = foundIn(draftOf(documents), {.fromMetres = 0.01});
  ASSERT_TRUE(finding);
  const auto built = buildLibrary(documents, {.thresholdMetres = finding->thresholdMetres});
  ASSERT_TRUE(built);
  EXPECT_NEAR(static_cast<double>(finding->playedFrames),
              built->report.survivingShare * static_cast<double>(built->library.frames.frameCount()), 1e-6);
}

TEST(ThresholdSearch, goesOnUntilSoManyFramesArePlayed) {
  const std::vector<BvhDocument> documents = wandering(2, 2);
  const auto any = foundIn(draftOf(documents), {.fromMetres = 0.01});
  const auto many = foundIn(draftOf(documents), {.fromMetres = 0.01, .leastFrames = 150});
  ASSERT_TRUE(any);
  ASSERT_TRUE(many);
  EXPECT_GE(many->playedFrames, 150U);
  EXPECT_GE(many->thresholdMetres, any->thresholdMetres);
}

TEST(ThresholdSearch, staysAtTheSmallestWhereThatWillDo) {
  const auto finding = foundIn(draftOf(threeWalks()), {.fromMetres = 0.04});
  ASSERT_TRUE(finding);
  EXPECT_EQ(finding->thresholdMetres, 0.04);
}

TEST(ThresholdSearch, findsNothingInClipsThatAreTooShortToComeBack) {
  const std::vector<BvhDocument> documents = {documentOf(walkOf({.frames = 24}), "brief")};
  EXPECT_FALSE(foundIn(draftOf(documents), {.fromMetres = 0.01}));
}

TEST(ThresholdSearch, hasNothingToDoBetweenEqualThresholds) {
  EXPECT_FALSE(foundIn(draftOf(threeWalks()), {.fromMetres = 0.3, .toMetres = 0.3}));
  EXPECT_FALSE(foundIn(draftOf({}), {}));
}

TEST(ThresholdSearch, takesNoMoreClipsThanItCanComparing) {
  std::vector<LibraryClip> clips(30, {"clip", 0, 1000, false});
  // 14 clips have 13944 windows: 97 million pairs.
  EXPECT_EQ(ThresholdSearch::searchable(clips), 14U);
  clips.resize(3);
  EXPECT_EQ(ThresholdSearch::searchable(clips), 3U);
  clips[0].frameCount = 20'000;
  EXPECT_EQ(ThresholdSearch::searchable(clips), 0U);
}

}  // namespace
}  // namespace stridegraph
