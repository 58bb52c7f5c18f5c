#include <gtest/gtest.h>

#include <sstream>

#include "motion/bvh_texts.h"
#include "motion/bvh_writer.h"
#include "motion/captures.h"
#include "motion/facing.h"
#include "motion/kinematics.h"

namespace stridegraph {
namespace {

BvhDocument readCase(const std::string& name) {
  const Result<BvhDocument> document =
      readBvh(testing::contentOf(std::filesystem::path(STRIDEGRAPH_TEST_DATA) / "cases" / name), name);
  EXPECT_TRUE(document) << describe(document.error());
  return document ? *document : BvhDocument{};
}

/// The greatest distance of joints of the same name, in the frames that both have.
double greatestDistance(const BvhDocument& a, const BvhDocument& b) {
  double greatest = 0.0;
  for (std::size_t f = 0; f < std::min(a.clip.frameCount(), b.clip.frameCount()); ++f) {
    const std::vector<Vec3> first = jointPositions(a.skeleton, a.clip.pose(f));
    const std::vector<Vec3> second = jointPositions(b.skeleton, b.clip.pose(f));
    for (std::size_t j = 0; j < a.skeleton.size(); ++j) {
      const auto twin = b.skeleton.find(a.skeleton.joints[j].name);
      if (!twin) return 1e9;
      greatest = std::max(greatest, (first[j] - second[twin->value]).norm());
    }
  }
  return greatest;
}

class TravelCase : public ::testing::TestWithParam<const char*> {};

TEST_P(TravelCase, isTheSameWalkAsStraight) {
  const BvhDocument straight = readCase("straight.bvh");
  const BvhDocument document = readCase(GetParam());
  EXPECT_LT(greatestDistance(straight, document), 1e-4);
  EXPECT_EQ(differenceBetween(straight.skeleton, document.skeleton, 1e-6), "");
  EXPECT_EQ(document.layout.unitsPerMetre, straight.layout.unitsPerMetre);
  EXPECT_EQ(document.layout.up, UpAxis::kY);
  EXPECT_GE(document.confidence.up, kDoubtfulConfidence);
  EXPECT_GE(document.confidence.unit, kDoubtfulConfidence);
  EXPECT_EQ(document.warnings.size(), 1U) << testing::warningsOf(document);
}

TEST_P(TravelCase, facesWhereItGoesAsStraightDoes) {
  BvhDocument straight = readCase("straight.bvh");
  const BvhDocument document = readCase(GetParam());
  ASSERT_LE(document.clip.frameCount(), straight.clip.frameCount());
  straight.clip.rootPositions.resize(document.clip.frameCount());
  straight.clip.rotations.resize(document.clip.rotations.size());
  const Heading expected = facingOffset(std::span(&straight.clip, 1));
  const Heading found = facingOffset(std::span(&document.clip, 1));
  EXPECT_NEAR(found.sin, expected.sin, 1e-3);
  EXPECT_NEAR(found.cos, expected.cos, 1e-3);
}

TEST_P(TravelCase, comesBackFromWritingWithItsOwnJointsAndChannels) {
  const BvhDocument document = readCase(GetParam());
  const std::string text = writeBvh(document.skeleton, document.layout, document.clip);
  const BvhDocument back = testing::read(text);
  EXPECT_EQ(back.skeleton.size(), document.skeleton.size());
  EXPECT_LT(testing::greatestDistance(document, back), 1e-4);
  EXPECT_EQ(back.layout.channels, document.layout.channels);
  ASSERT_EQ(back.layout.still.joints.size(), document.layout.still.joints.size());
  // Everything between HIERARCHY and MOTION is as in the source but for the notation of numbers.
  const std::string source =
      testing::contentOf(std::filesystem::path(STRIDEGRAPH_TEST_DATA) / "cases" / GetParam());
  const auto wordsOf = [](std::string hierarchy) {
    hierarchy.resize(hierarchy.find("MOTION"));
    std::vector<std::string> words;
    std::istringstream stream(hierarchy);
    for (std::string word; stream >> word;) {
      if (word.find_first_not_of("-.0123456789") != std::string::npos) words.push_back(word);
    }
    return words;
  };
  EXPECT_EQ(wordsOf(text), wordsOf(source));
}

INSTANTIATE_TEST_SUITE_P(Cases, TravelCase,
                         ::testing::Values("root_that_stays.bvh", "root_without_channels.bvh",
                                           "zeros_in_position_channels.bvh"));

TEST(TravelCases, nameTheJointThatTravels) {
  EXPECT_EQ(testing::warningsOf(readCase("root_that_stays.bvh")),
            "root_that_stays.bvh: joint \"Hips\" is taken as the root of the motion: it travels, and "
            "\"joint_Root\" above it stands still\n");
  EXPECT_EQ(testing::warningsOf(readCase("root_without_channels.bvh")),
            "root_without_channels.bvh: joint \"Hips\" is taken as the root of the motion: it travels, and "
            "\"Armature\" above it stands still\n");
  EXPECT_EQ(readCase("root_that_stays.bvh").warnings[0].topic, WarningTopic::kTravel);
}

}  // namespace
}  // namespace stridegraph
