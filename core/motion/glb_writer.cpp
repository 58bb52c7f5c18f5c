#include "motion/glb_writer.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <array>
#include <cmath>
#include <ostream>
#include <streambuf>
#include <string>
#include <string_view>
#include <utility>

#include "base/check.h"
#include "motion/body_colours.h"
#include "motion/body_mesh.h"
#include "motion/export_names.h"
#include "motion/glb_buffer.h"
#include "motion/glb_tracks.h"
#include "motion/kinematics.h"

namespace stridegraph {
namespace {

constexpr int kNoTarget = 0;
constexpr GlbAccessor kTimes{TINYGLTF_TYPE_SCALAR, TINYGLTF_COMPONENT_TYPE_FLOAT, kNoTarget, false, true};
constexpr GlbAccessor kTranslations{TINYGLTF_TYPE_VEC3, TINYGLTF_COMPONENT_TYPE_FLOAT};
constexpr GlbAccessor kRotations{TINYGLTF_TYPE_VEC4, TINYGLTF_COMPONENT_TYPE_FLOAT};
constexpr GlbAccessor kMatrices{TINYGLTF_TYPE_MAT4, TINYGLTF_COMPONENT_TYPE_FLOAT};
constexpr GlbAccessor kPositions{TINYGLTF_TYPE_VEC3, TINYGLTF_COMPONENT_TYPE_FLOAT,
                                 TINYGLTF_TARGET_ARRAY_BUFFER, false, true};
constexpr GlbAccessor kNormals{TINYGLTF_TYPE_VEC3, TINYGLTF_COMPONENT_TYPE_FLOAT,
                               TINYGLTF_TARGET_ARRAY_BUFFER};
constexpr GlbAccessor kJointIndices{TINYGLTF_TYPE_VEC4, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT,
                                    TINYGLTF_TARGET_ARRAY_BUFFER};
constexpr GlbAccessor kWeights{TINYGLTF_TYPE_VEC4, TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE,
                               TINYGLTF_TARGET_ARRAY_BUFFER, true};
constexpr GlbAccessor kIndices{TINYGLTF_TYPE_SCALAR, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT,
                               TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER};

/// Memory that a stream writes into, without a copy in between.
class ByteSink : public std::streambuf {
 public:
  std::vector<std::uint8_t> bytes;

 private:
  std::streamsize xsputn(const char* text, std::streamsize count) override {
    bytes.insert(bytes.end(), text, text + count);
    return count;
  }
  int_type overflow(int_type c) override {
    bytes.push_back(static_cast<std::uint8_t>(c));
    return c;
  }
};

/// Linear light of a channel of an sRGB colour (IEC 61966-2-1).
double linearChannel(std::uint32_t colour, unsigned shift) {
  const double c = static_cast<double>((colour >> shift) & 0xFFU) / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

std::vector<double> numbersOf(const Vec3& v) {
  return {static_cast<double>(finiteFloat(v.x())), static_cast<double>(finiteFloat(v.y())),
          static_cast<double>(finiteFloat(v.z()))};
}

std::vector<double> numbersOf(const std::array<float, 4>& key) {
  return {key.begin(), key.end()};
}

class GlbWriter {
 public:
  GlbWriter(const Skeleton& skeleton, const RoundBody& body, std::span<const WalkerClip> clips)
      : skeleton_(skeleton), body_(body), clips_(clips), placeOf_(skeleton.size(), -1) {
    int places = 0;
    for (std::size_t j = 0; j < skeleton.size(); ++j)
      if (!skeleton.joints[j].isEndSite) placeOf_[j] = places++;
    standing_.jointCount = skeleton.size();
    standing_.append(body.standing.view());
    standing_.rootPositions[0].y() -= body.liftMetres;
  }

  std::vector<std::uint8_t> write() {
    model_.asset.version = "2.0";
    model_.asset.generator = "Stridegraph";
    model_.scenes.emplace_back();
    model_.defaultScene = 0;
    tinygltf::Animation animation;
    animation.name = clips_.size() == 1 ? exportName(clips_.front().clip->name, "walk") : "walks";
    for (const WalkerClip& each : clips_) {
      addNodes(each);
      if (each.clip->frameCount() > 0) addTracks(*each.clip, animation);
    }
    if (!animation.channels.empty()) model_.animations.push_back(std::move(animation));
    const tinygltf::Primitive shape = addShape();
    const int matrices = addMatrices();
    for (std::size_t i = 0; i < clips_.size(); ++i) addBody(i, shape, matrices);
    makeNamesUnique();
    ByteSink sink;
    std::ostream stream(&sink);
    tinygltf::TinyGLTF writer;
    STRIDEGRAPH_CHECK(writer.WriteGltfSceneToStream(&model_, stream, false, true));
    return std::move(sink.bytes);
  }

 private:
  /// In a file with several walkers everything is named for its walker.
  std::string named(std::string_view what, std::size_t walker) const {
    return clips_.size() == 1 ? std::string(what)
                              : fmt::format("walker_{}{}{}", walker + 1, what.empty() ? "" : "_", what);
  }

  template <typename Objects>
  static void makeNamesUnique(Objects& objects) {
    std::vector<std::string> names;
    for (const auto& object : objects) names.push_back(object.name);
    names = madeUnique(std::move(names));
    for (std::size_t i = 0; i < names.size(); ++i) objects[i].name = std::move(names[i]);
  }

  void makeNamesUnique() {
    makeNamesUnique(model_.nodes);
    makeNamesUnique(model_.meshes);
    makeNamesUnique(model_.skins);
    makeNamesUnique(model_.materials);
  }

  Vec3 lift() const { return body_.liftMetres * Vec3::UnitY(); }
  int nodeCount() const { return static_cast<int>(model_.nodes.size()); }

  /// A node for each joint that can turn, placed as in the first frame; below one of their own where there
  /// are several walkers.
  void addNodes(const WalkerClip& each) {
    const std::size_t added = firstNodes_.size();
    const Clip& clip = each.clip->frameCount() > 0 ? *each.clip : standing_;
    const int top = nodeCount();
    model_.scenes.front().nodes.push_back(top);
    if (clips_.size() > 1) {
      model_.nodes.emplace_back().name = named("", each.walker);
      model_.nodes.back().children.push_back(top + 1);
    }
    firstNodes_.push_back(nodeCount());
    for (std::size_t j = 0; j < skeleton_.size(); ++j) {
      const Joint& joint = skeleton_.joints[j];
      if (joint.isEndSite) continue;
      const int index = nodeCount();
      tinygltf::Node& node = model_.nodes.emplace_back();
      node.name = named(exportName(joint.name, "joint"), each.walker);
      node.translation = numbersOf(joint.parent ? joint.offset : Vec3(clip.rootPositions[0] + lift()));
      node.rotation = numbersOf(rotationKey(clip.rotations[j]));
      if (joint.parent)
        model_.nodes[static_cast<std::size_t>(nodeOf(joint.parent->value, added))].children.push_back(index);
    }
  }

  int nodeOf(std::size_t joint, std::size_t added) const { return firstNodes_[added] + placeOf_[joint]; }

  /// Adds what moves the walker whose nodes were added last.
  void addTracks(const Clip& clip, tinygltf::Animation& animation) {
    const std::size_t added = firstNodes_.size() - 1;
    const int times = addGlbAccessor(model_, bytesOf(keyTimes(clip)), kTimes);
    addChannel(animation, nodeOf(0, added), "translation",
               {times, addGlbAccessor(model_, bytesOf(rootKeys(clip, body_.liftMetres)), kTranslations)});
    for (std::size_t j = 0; j < skeleton_.size(); ++j) {
      if (placeOf_[j] < 0) continue;
      addChannel(animation, nodeOf(j, added), "rotation",
                 {times, addGlbAccessor(model_, bytesOf(rotationKeys(clip, j)), kRotations)});
    }
  }

  /// `track` holds the accessors of times and of values.
  static void addChannel(tinygltf::Animation& animation, int node, const char* path,
                         std::array<int, 2> track) {
    tinygltf::AnimationSampler sampler;
    sampler.input = track[0];
    sampler.output = track[1];
    sampler.interpolation = "LINEAR";
    tinygltf::AnimationChannel channel;
    channel.sampler = static_cast<int>(animation.samplers.size());
    channel.target_node = node;
    channel.target_path = path;
    animation.samplers.push_back(std::move(sampler));
    animation.channels.push_back(std::move(channel));
  }

  /// The body that all walkers share, as accessors.
  tinygltf::Primitive addShape() {
    const BodyMesh body = buildBodyMesh(skeleton_, body_);
    std::vector<std::uint16_t> carriers;
    std::vector<std::uint8_t> weights;
    for (const VertexCarriers& each : body.carriers) {
      const auto second = static_cast<std::uint8_t>(std::lround(255.0 * each.secondShare));
      const int secondPlace = second > 0 ? placeOf_[each.joints[1]] : 0;
      carriers.insert(carriers.end(), {static_cast<std::uint16_t>(placeOf_[each.joints[0]]),
                                       static_cast<std::uint16_t>(secondPlace), 0, 0});
      weights.insert(weights.end(), {static_cast<std::uint8_t>(255 - second), second, 0, 0});
    }
    tinygltf::Primitive primitive;
    primitive.mode = TINYGLTF_MODE_TRIANGLES;
    primitive.attributes["POSITION"] = addGlbAccessor(model_, bytesOf(body.positions), kPositions);
    primitive.attributes["NORMAL"] = addGlbAccessor(model_, bytesOf(body.normals), kNormals);
    primitive.attributes["JOINTS_0"] = addGlbAccessor(model_, bytesOf(carriers), kJointIndices);
    primitive.attributes["WEIGHTS_0"] = addGlbAccessor(model_, bytesOf(weights), kWeights);
    primitive.indices = addGlbAccessor(model_, bytesOf(body.indices), kIndices);
    return primitive;
  }

  /// Joint by joint what leads from the standing body's world into the joint's axes.
  int addMatrices() {
    std::vector<JointPlacement> placed(skeleton_.size());
    placeJoints(skeleton_, body_.standing.view(), placed);
    std::vector<float> jointFromWorld;
    for (std::size_t j = 0; j < skeleton_.size(); ++j) {
      if (placeOf_[j] < 0) continue;
      const Mat3 turn = placed[j].rotation.normalized().conjugate().toRotationMatrix();
      const Vec3 place = -(turn * placed[j].position);
      for (Eigen::Index column = 0; column < 3; ++column) {
        for (const double number : turn.col(column)) jointFromWorld.push_back(finiteFloat(number));
        jointFromWorld.push_back(0.0F);
      }
      for (const double number : place) jointFromWorld.push_back(finiteFloat(number));
      jointFromWorld.push_back(1.0F);
    }
    return addGlbAccessor(model_, bytesOf(jointFromWorld), kMatrices);
  }

  int addMaterial(std::size_t walker) {
    const std::uint32_t colour = bodyColour(walker);
    tinygltf::Material& material = model_.materials.emplace_back();
    material.name = named("colour", walker);
    material.pbrMetallicRoughness.baseColorFactor = {linearChannel(colour, 16), linearChannel(colour, 8),
                                                     linearChannel(colour, 0), 1.0};
    material.pbrMetallicRoughness.metallicFactor = 0.0;
    material.pbrMetallicRoughness.roughnessFactor = 0.7;
    return static_cast<int>(model_.materials.size() - 1);
  }

  /// Skins the body to a walker's joints. Skinned nodes stand at the top of a scene, else viewers disagree.
  void addBody(std::size_t added, tinygltf::Primitive shape, int matrices) {
    const std::size_t walker = clips_[added].walker;
    shape.material = addMaterial(walker);
    tinygltf::Mesh& mesh = model_.meshes.emplace_back();
    mesh.name = named("body", walker);
    mesh.primitives.push_back(std::move(shape));
    tinygltf::Skin& skin = model_.skins.emplace_back();
    skin.name = named("skin", walker);
    for (std::size_t j = 0; j < skeleton_.size(); ++j)
      if (placeOf_[j] >= 0) skin.joints.push_back(nodeOf(j, added));
    skin.skeleton = firstNodes_[added];
    skin.inverseBindMatrices = matrices;
    model_.scenes.front().nodes.push_back(nodeCount());
    tinygltf::Node& node = model_.nodes.emplace_back();
    node.name = named("body", walker);
    node.mesh = static_cast<int>(added);
    node.skin = static_cast<int>(added);
  }

  const Skeleton& skeleton_;
  const RoundBody& body_;
  std::span<const WalkerClip> clips_;
  Clip standing_;                ///< One frame.
  std::vector<int> placeOf_;     ///< For each joint its place in the skins, -1 for end sites.
  std::vector<int> firstNodes_;  ///< For each clip the node of its root joint; the others follow.
  tinygltf::Model model_;
};

}  // namespace

std::vector<std::uint8_t> writeGlb(const Skeleton& skeleton, const RoundBody& body,
                                   std::span<const WalkerClip> clips) {
  STRIDEGRAPH_CHECK(!skeleton.joints.empty() && !clips.empty());
  for (const WalkerClip& each : clips)
    STRIDEGRAPH_CHECK(each.clip != nullptr && each.clip->jointCount == skeleton.size());
  return GlbWriter(skeleton, body, clips).write();
}

std::vector<std::uint8_t> writeGlb(const Skeleton& skeleton, const RoundBody& body, const Clip& clip) {
  return writeGlb(skeleton, body, std::array{WalkerClip{&clip, 0}});
}

}  // namespace stridegraph
