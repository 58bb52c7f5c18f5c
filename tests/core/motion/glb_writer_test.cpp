#include "motion/glb_writer.h"

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "motion/export_names.h"
#include "motion/kinematics.h"
#include "motion/odd_skeletons.h"
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

/// A body that moves as the clip does, over a floor that is left where it is.
RoundBody bodyOf(const Skeleton& skeleton, const Clip& clip) {
  RoundBody body = roundBody(skeleton, clip);
  body.standing.rootPosition.y() -= body.liftMetres;
  body.liftMetres = 0.0;
  return body;
}

std::vector<std::uint8_t> written(const Skeleton& skeleton, const Clip& clip) {
  return writeGlb(skeleton, bodyOf(skeleton, clip), clip);
}

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
  const Glb glb(written(skeleton, clip));
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
  const Glb glb(written(twoArms(), clip));
  const Json& input = glb.json["animations"][0]["samplers"][0]["input"];
  const std::vector<float> times = glb.floats(input);
  EXPECT_EQ(times.size(), 31U);
  EXPECT_FLOAT_EQ(times[30], 1.0F);
  const Json& accessor = glb.json["accessors"][input.get<std::size_t>()];
  EXPECT_EQ(accessor["min"], Json({0.0}));
  EXPECT_EQ(accessor["max"], Json({1.0}));
}

TEST(WriteGlb, skinsTheBodySoThatItMovesAsItsParts) {
  const Skeleton skeleton = twoArms();
  const Clip clip = waving(skeleton, 20, 3);
  const RoundBody body = bodyOf(skeleton, clip);
  const Glb glb(writeGlb(skeleton, body, clip));
  const Json& skin = glb.json["skins"][0];
  ASSERT_EQ(skin["joints"].size(), 6U);
  const std::vector<float> matrices = glb.floats(skin["inverseBindMatrices"]);
  ASSERT_EQ(matrices.size(), 16U * 6U);
  const Json& shape = glb.json["meshes"][0]["primitives"][0];
  EXPECT_EQ(shape["attributes"].size(), 4U);
  // The pole of the first part lies at its end, whatever the joint does.
  const std::vector<float> positions = glb.floats(shape["attributes"]["POSITION"]);
  const Eigen::Vector4d pole(positions[0], positions[1], positions[2], 1.0);
  const std::size_t carrier = body.parts[0].from.joint.value;
  Eigen::Matrix4d jointFromStanding;
  for (Eigen::Index i = 0; i < 16; ++i)
    jointFromStanding(i % 4, i / 4) =
        static_cast<double>(matrices[16 * carrier + static_cast<std::size_t>(i)]);
  std::vector<JointPlacement> placed(skeleton.size());
  placeJoints(skeleton, clip.pose(11), placed);
  const Vec3 inJoint = (jointFromStanding * pole).head<3>();
  const Vec3 at = placed[carrier].position + placed[carrier].rotation * inJoint;
  const Capsule part = placeParts(body, skeleton, clip.pose(11)).front();
  EXPECT_NEAR((at - part.from).norm(), part.fromRadius, 1e-5);
  const Json& node = glb.json["nodes"].back();
  EXPECT_EQ(node["mesh"], 0);
  EXPECT_EQ(node["skin"], 0);
}

TEST(WriteGlb, writesABodyWithoutAnimationForAnEmptyClip) {
  Clip clip;
  clip.jointCount = twoArms().size();
  const Glb glb(written(twoArms(), clip));
  EXPECT_FALSE(glb.json.contains("animations"));
  EXPECT_EQ(glb.json["meshes"].size(), 1U);
}

TEST(WriteGlb, givesEachOfSeveralWalkersNodesASkinAndTracksOfItsOwn) {
  const Skeleton skeleton = twoArms();
  const Clip first = waving(skeleton, 20, 3);
  const Clip second = waving(skeleton, 9, 4);
  const std::array<WalkerClip, 2> clips = {{{&first, 0}, {&second, 1}}};
  const Glb glb(writeGlb(skeleton, bodyOf(skeleton, first), clips));
  const Json& nodes = glb.json["nodes"];
  ASSERT_EQ(nodes.size(), 2U * 8U);
  EXPECT_EQ(nodes[0]["name"], "walker_1");
  EXPECT_EQ(nodes[0]["children"], Json({1}));
  EXPECT_EQ(nodes[1]["name"], "walker_1_hips");
  EXPECT_EQ(nodes[7]["name"], "walker_2");
  EXPECT_EQ(nodes[8]["name"], "walker_2_hips");
  EXPECT_EQ(nodes[14]["name"], "walker_1_body");
  EXPECT_EQ(nodes[15]["name"], "walker_2_body");
  EXPECT_EQ(glb.json["scenes"][0]["nodes"], Json({0, 7, 14, 15}));
  EXPECT_EQ(glb.json["skins"][1]["joints"], Json({8, 9, 10, 11, 12, 13}));
  EXPECT_EQ(nodes[15]["skin"], 1);
  EXPECT_EQ(glb.json["meshes"].size(), 2U);
  EXPECT_EQ(glb.json["meshes"][0]["primitives"][0]["attributes"],
            glb.json["meshes"][1]["primitives"][0]["attributes"]);
  EXPECT_NE(glb.json["materials"][0]["pbrMetallicRoughness"],
            glb.json["materials"][1]["pbrMetallicRoughness"]);
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

TEST(WriteGlb, liftsAWalkWhoseFloorLiesElsewhere) {
  const Skeleton skeleton = twoArms();
  const Clip clip = waving(skeleton, 3, 3);
  RoundBody body = bodyOf(skeleton, clip);
  body.liftMetres = 0.25;
  const std::vector<Vec3> lifted = nodePositions(Glb(writeGlb(skeleton, body, clip)), 1);
  EXPECT_LT((lifted[0] - clip.rootPositions[1] - Vec3(0, 0.25, 0)).norm(), 1e-6);
}

/// All names of a kind of object.
std::vector<std::string> namesOf(const Json& objects) {
  std::vector<std::string> names;
  for (const Json& object : objects) names.push_back(object.value("name", ""));
  return names;
}

TEST(WriteGlb, givesEverythingANameOfItsOwnWhateverJointsAreCalled) {
  for (const Skeleton& skeleton : testing::oddSkeletons()) {
    const Clip first = waving(skeleton, 5, 3);
    const Clip second = waving(skeleton, 1, 4);
    const RoundBody body = roundBody(skeleton, first);
    const std::vector<WalkerClip> clips = {{&first, 0}, {&second, 1}, {&first, 9}};
    for (const std::size_t count : {1U, 3U}) {
      const Glb glb(writeGlb(skeleton, body, std::span(clips).first(count)));
      for (const char* const kind : {"nodes", "meshes", "skins", "materials", "animations"}) {
        const std::vector<std::string> names = namesOf(glb.json[kind]);
        EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
        for (const std::string& name : names) EXPECT_EQ(exportName(name, ""), name);
      }
    }
  }
}

TEST(WriteGlb, keepsNamesOfJointsThatAreLikeItsOwn) {
  Skeleton skeleton = twoArms();
  skeleton.joints[1].name = "body";
  const Glb glb(written(skeleton, waving(skeleton, 2, 3)));
  EXPECT_EQ(glb.json["nodes"][1]["name"], "body");
  EXPECT_EQ(glb.json["nodes"].back()["name"], "body_2");
}

TEST(WriteGlb, namesAWalkWithoutANameAndSafelyOneWithAny) {
  Clip clip = waving(twoArms(), 2, 3);
  clip.name.clear();
  EXPECT_EQ(Glb(written(twoArms(), clip)).json["animations"][0]["name"], "walk");
  clip.name = "Sch\xF6n\n";
  EXPECT_EQ(Glb(written(twoArms(), clip)).json["animations"][0]["name"], "Sch\xC3\xB6n");
}

TEST(WriteGlb, standsWhereAClipHasNoFrames) {
  Clip clip;
  clip.jointCount = twoArms().size();
  const RoundBody body = bodyOf(twoArms(), waving(twoArms(), 2, 3));
  const Glb glb(writeGlb(twoArms(), body, clip));
  EXPECT_FLOAT_EQ(glb.json["nodes"][0]["translation"][1].get<float>(), 1.0F);
}

TEST(WriteGlb, givesTheSameBytesForTheSameClip) {
  const Clip clip = waving(twoArms(), 5, 3);
  EXPECT_EQ(written(twoArms(), clip), written(twoArms(), clip));
}

}  // namespace
}  // namespace stridegraph
