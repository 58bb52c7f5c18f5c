#include "graph/clip_faults.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "graph/library_limits.h"
#include "graph/test_library.h"

namespace stridegraph {
namespace {

using testing::documentOf;
using testing::walkOf;

std::vector<BvhDocument> walks(std::size_t count) {
  std::vector<BvhDocument> documents;
  for (std::size_t k = 0; k < count; ++k)
    documents.push_back(documentOf(walkOf({.frames = 3}), fmt::format("walk {}", k)));
  return documents;
}

std::string faultOf(const std::vector<BvhDocument>& documents) {
  const std::optional<Error> error = faultInClips(documents, LibraryParams{});
  return error ? describe(*error) : "";
}

TEST(ClipFaults, areNoneOfSoundClips) {
  EXPECT_EQ(faultOf(walks(4)), "");
}

TEST(ClipFaults, nameTheFileAndJointsOfOneClipOfAnotherSkeleton) {
  std::vector<BvhDocument> documents = walks(3);
  documents[0].skeleton.joints[2].offset.y() = -0.43;
  documents[0].skeleton.joints[6].offset.y() = -0.44;
  EXPECT_EQ(
      faultOf(documents),
      "walk 0: its skeleton is not that of the 2 clips like walk 1: leftShin 43.0 cm, expected 45.0 cm, "
      "rightShin 44.0 cm, expected 45.0 cm");
}

TEST(ClipFaults, groupFilesBySkeletonWithTheLargestGroupExpected) {
  std::vector<BvhDocument> documents = walks(9);
  for (const std::size_t k : {0U, 4U}) documents[k].skeleton.joints[2].offset.y() = -0.43;
  documents[7].skeleton.joints[11].name = "paw";
  EXPECT_EQ(faultOf(documents),
            "3 of 9 clips have another skeleton than the 6 clips like walk 1:\n"
            "  walk 0, walk 4: leftShin 43.0 cm, expected 45.0 cm\n"
            "  walk 7: leftHand is called paw");
}

TEST(ClipFaults, stayReadableWithManyFilesAndCountWhatTheyLeaveOut) {
  std::vector<BvhDocument> documents = walks(300);
  for (std::size_t k = 0; k < 120; ++k)
    documents[k].skeleton.joints[2].offset.y() =
        -0.2 - 0.002 * static_cast<double>(std::min<std::size_t>(k, 100));
  const std::string fault = faultOf(documents);
  EXPECT_TRUE(
      fault.starts_with("120 of 300 clips have another skeleton than the 180 clips like walk 120:\n"
                        "  walk 100, walk 101, walk 102, walk 103 and 16 more clips: leftShin 40.0 cm"))
      << fault;
  EXPECT_TRUE(fault.ends_with("\n  and 89 more clips")) << fault;
  EXPECT_LT(fault.size(), 2000U);
}

TEST(ClipFaults, takeTheLibrarysSkeletonAsTheOneExpected) {
  const MotionLibrary library = testing::builtFrom(testing::threeWalks()).library;
  std::vector<BvhDocument> documents = walks(2);
  for (BvhDocument& document : documents) document.skeleton.joints[2].offset.y() = -0.43;
  const std::optional<Error> error = faultInClips(documents, library);
  ASSERT_TRUE(error);
  EXPECT_EQ(error->code, ErrorCode::kSkeletonMismatch);
  EXPECT_EQ(describe(*error),
            "2 of 2 clips have another skeleton than the library:\n"
            "  walk 0, walk 1: leftShin 43.0 cm, expected 45.0 cm");
}

TEST(ClipFaults, nameEveryClipThatIsNotSound) {
  std::vector<BvhDocument> documents = walks(4);
  documents[1].clip.rootPositions[1].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(faultOf(documents), "walk 1: the root's position in frame 1 is not finite");
  documents[2].clip = {"walk 2", 30.0, 13, {}, {}};
  documents[3].clip.framesPerSecond = 0.0;
  EXPECT_EQ(faultOf(documents),
            "3 of 4 clips cannot be used:\n"
            "  walk 1: the root's position in frame 1 is not finite\n"
            "  walk 2: a clip without frames\n"
            "  walk 3: 0 frames a second, more than 0 expected");
}

TEST(ClipFaults, refuseMoreClipsThanALibraryHolds) {
  std::vector<BvhDocument> documents = walks(1);
  documents.resize(kMostLibraryClips / 2 + 1, documents.front());
  EXPECT_FALSE(faultInClips(documents, LibraryParams{}));
  EXPECT_EQ(faultInClips(documents, LibraryParams{.mirror = true})->message,
            "found 10002 clips, expected at most 10000 in a library, mirror images among them");
}

TEST(ClipFaults, refuseMoreRotationsThanALibraryHolds) {
  std::vector<BvhDocument> documents = walks(1);
  Skeleton& skeleton = documents[0].skeleton;
  while (skeleton.size() < 200)
    skeleton.joints.push_back({"more", JointIndex(std::size_t{0}), {0.0, 0.1, 0.0}});
  Clip clip{"walk", 3.0 / 20'000.0, skeleton.size(), {}, {}};
  for (int f = 0; f < 3; ++f) clip.append(testing::restPose(skeleton, {0.0, 0.9, 0.0}).view());
  documents[0].clip = clip;
  EXPECT_EQ(faultOf(documents), "600000 frames of 200 joints; a library holds 50000000 rotations at most");
}

}  // namespace
}  // namespace stridegraph
