#include "motion/glb_writer.h"

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <nlohmann/json.hpp>

#include "motion/kinematics.h"
#include "motion/two_arms.h"

namespace stridegraph {
namespace {

using testing::twoArms;
using testing::waving;
using Json = nlohmann::json;

std::uint32_t wordAt(const std::vector<std::uint8_t>& bytes, std::size_t offset) {
  std::uint32_t word = 0;
  std::memcpy(&word, bytes.data() + offset, sizeof word);
  return word;
}

/// A binary glTF taken apart: 12 bytes of head, a chunk of JSON, a chunk of numbers.
struct Glb {
  explicit Glb(const std::vector<std::uint8_t>& bytes) {
    EXPECT_EQ(wordAt(bytes, 0), 0x46546C67U);
    EXPECT_EQ(wordAt(bytes, 4), 2U);
    EXPECT_EQ(wordAt(bytes, 8), bytes.size());
    const std::size_t textBytes = wordAt(bytes, 12);
    EXPECT_EQ(wordAt(bytes, 16), 0x4E4F534AU);
    json = Json::parse(bytes.begin() + 20, bytes.begin() + 20 + static_cast<std::ptrdiff_t>(textBytes),
                       nullptr, false);
    EXPECT_FALSE(json.is_discarded());
    EXPECT_EQ(wordAt(bytes, 24 + textBytes), 0x004E4942U);
    numbers.assign(bytes.begin() + 28 + static_cast<std::ptrdiff_t>(textBytes), bytes.end());
  }

  /// The floats of an accessor.
  std::vector<float> floats(const Json& accessorIndex) const {
    const Json& accessor = json["accessors"][accessorIndex.get<std::size_t>()];
    EXPECT_EQ(accessor["componentType"], 5126);
    const Json& view = json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    std::vector<float> values(view["byteLength"].get<std::size_t>() / sizeof(float));
    std::memcpy(values.data(), numbers.data() + view.value("byteOffset", std::size_t{0}),
                values.size() * sizeof(float));
    return values;
  }

  Json json;
  std::vector<std::uint8_t> numbers;
};

/// World positions of the nodes at a frame, from the file's animation alone.
std::vector<Vec3> nodePositions(const Glb& glb, std::size_t frame) {
  const Json& nodes = glb.json["nodes"];
  std::vector<Quat> rotations(nodes.size(), Quat::Identity());
  std::vector<Vec3> positions(nodes.size(), Vec3::Zero());
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    if (!nodes[n].contains("translation")) continue;
    const Json& t = nodes[n]["translation"];
    positions[n] = {t[0].get<double>(), t[1].get<double>(), t[2].get<double>()};
  }
  const Json& animation = glb.json["animations"][0];
  for (const Json& channel : animation["channels"]) {
    const std::vector<float> values =
        glb.floats(animation["samplers"][channel["sampler"].get<std::size_t>()]["output"]);
    const auto node = channel["target"]["node"].get<std::size_t>();
    const bool isRotation = channel["target"]["path"] == "rotation";
    const float* const v = values.data() + frame * (isRotation ? 4 : 3);
    if (isRotation) {
      rotations[node] = Eigen::Quaternionf(v[3], v[0], v[1], v[2]).cast<double>();
    } else {
      positions[node] = Eigen::Vector3f(v[0], v[1], v[2]).cast<double>();
    }
  }
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    for (const Json& child : nodes[n].value("children", Json::array())) {
      const auto c = child.get<std::size_t>();
      positions[c] = positions[n] + rotations[n] * positions[c];
      rotations[c] = rotations[n] * rotations[c];
    }
  }
  return positions;
}

TEST(WriteGlb, animatesANodeForEachJointAsTheClipMoves) {
  const Skeleton skeleton = twoArms();
  const Clip clip = waving(skeleton, 20, 3);
  const Glb glb(writeGlb(skeleton, clip));
  EXPECT_EQ(glb.json["animations"].size(), 1U);
  EXPECT_EQ(glb.json["animations"][0]["name"], "waving");
  for (const std::size_t frame : {0U, 7U, 19U}) {
    const std::vector<Vec3> nodes = nodePositions(glb, frame);
    const std::vector<Vec3> joints = jointPositions(skeleton, clip.pose(frame));
    std::size_t n = 0;
    for (std::size_t j = 0; j < skeleton.size(); ++j) {
      if (skeleton.joints[j].isEndSite) continue;
      EXPECT_EQ(glb.json["nodes"][n]["name"], skeleton.joints[j].name);
      EXPECT_LT((nodes[n] - joints[j]).norm(), 1e-5);
      ++n;
    }
    EXPECT_EQ(n + 1, nodes.size());
  }
}

TEST(WriteGlb, spacesFramesInSecondsAndStatesTheirLimits) {
  Clip clip = waving(twoArms(), 31, 3);
  clip.framesPerSecond = 30.0;
  const Glb glb(writeGlb(twoArms(), clip));
  const Json& input = glb.json["animations"][0]["samplers"][0]["input"];
  const std::vector<float> times = glb.floats(input);
  EXPECT_EQ(times.size(), 31U);
  EXPECT_FLOAT_EQ(times[30], 1.0F);
  const Json& accessor = glb.json["accessors"][input.get<std::size_t>()];
  EXPECT_EQ(accessor["min"], Json({0.0}));
  EXPECT_EQ(accessor["max"], Json({1.0}));
}

TEST(WriteGlb, skinsABodyThatLiesOnTheJointsInTheRestPose) {
  const Skeleton skeleton = twoArms();
  const Glb glb(writeGlb(skeleton, waving(skeleton, 2, 3)));
  const Json& skin = glb.json["skins"][0];
  EXPECT_EQ(skin["joints"].size(), 6U);
  const std::vector<float> matrices = glb.floats(skin["inverseBindMatrices"]);
  ASSERT_EQ(matrices.size(), 16U * 6U);
  // The left elbow is the fourth joint; its place at rest is the sum of the offsets up to it.
  EXPECT_FLOAT_EQ(matrices[3 * 16 + 12], -0.3F);
  EXPECT_FLOAT_EQ(matrices[3 * 16 + 13], -0.6F);
  EXPECT_FLOAT_EQ(matrices[3 * 16 + 14], -0.07F);
  EXPECT_FLOAT_EQ(matrices[3 * 16 + 15], 1.0F);
  const Json& body = glb.json["nodes"].back();
  EXPECT_EQ(body["mesh"], 0);
  EXPECT_EQ(body["skin"], 0);
  EXPECT_EQ(glb.json["meshes"][0]["primitives"][0]["attributes"].size(), 4U);
}

TEST(WriteGlb, writesABodyWithoutAnimationForAnEmptyClip) {
  Clip clip;
  clip.jointCount = twoArms().size();
  const Glb glb(writeGlb(twoArms(), clip));
  EXPECT_FALSE(glb.json.contains("animations"));
  EXPECT_EQ(glb.json["meshes"].size(), 1U);
}

TEST(WriteGlb, givesEachOfSeveralWalkersNodesASkinAndTracksOfItsOwn) {
  const Skeleton skeleton = twoArms();
  const Clip first = waving(skeleton, 20, 3);
  const Clip second = waving(skeleton, 9, 4);
  const std::array<const Clip*, 2> clips = {&first, &second};
  const Glb glb(writeGlb(skeleton, clips));
  const Json& nodes = glb.json["nodes"];
  ASSERT_EQ(nodes.size(), 2U * 8U);
  EXPECT_EQ(nodes[0]["name"], "walker_1");
  EXPECT_EQ(nodes[0]["children"], Json({1}));
  EXPECT_EQ(nodes[1]["name"], "hips");
  EXPECT_EQ(nodes[7]["name"], "walker_2");
  EXPECT_EQ(nodes[8]["name"], "hips");
  EXPECT_EQ(nodes[14]["name"], "walker_1_body");
  EXPECT_EQ(nodes[15]["name"], "walker_2_body");
  EXPECT_EQ(glb.json["scenes"][0]["nodes"], Json({0, 7, 14, 15}));
  EXPECT_EQ(glb.json["skins"][1]["joints"], Json({8, 9, 10, 11, 12, 13}));
  EXPECT_EQ(nodes[15]["skin"], 1);
  EXPECT_EQ(glb.json["meshes"].size(), 1U);
  ASSERT_EQ(glb.json["animations"].size(), 1U);
  const Json& channels = glb.json["animations"][0]["channels"];
  ASSERT_EQ(channels.size(), 2U * 7U);
  EXPECT_EQ(channels[7]["target"]["node"], 8);
  const Json& input = glb.json["animations"][0]["samplers"][7]["input"];
  EXPECT_EQ(glb.floats(input).size(), 9U);
  const std::vector<Vec3> places = nodePositions(glb, 5);
  const std::vector<Vec3> joints = jointPositions(skeleton, second.pose(5));
  EXPECT_LT((places[11] - joints[3]).norm(), 1e-5);
}

TEST(WriteGlb, givesTheSameBytesForTheSameClip) {
  const Clip clip = waving(twoArms(), 5, 3);
  EXPECT_EQ(writeGlb(twoArms(), clip), writeGlb(twoArms(), clip));
}

}  // namespace
}  // namespace stridegraph
