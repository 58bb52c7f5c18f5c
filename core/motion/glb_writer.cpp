#include "motion/glb_writer.h"

#include <tiny_gltf.h>

#include <array>
#include <sstream>
#include <utility>

#include "base/check.h"
#include "motion/glb_body.h"
#include "motion/glb_buffer.h"

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

void appendFloats(const Vec3& v, std::vector<float>& floats) {
  for (Eigen::Index i = 0; i < 3; ++i) floats.push_back(static_cast<float>(v[i]));
}

/// x, y, z, w, as glTF has them, normalised anew in single precision.
void appendFloats(const Quat& rotation, std::vector<float>& floats) {
  const Eigen::Vector4f q = rotation.coeffs().cast<float>().normalized();
  for (Eigen::Index i = 0; i < 4; ++i) floats.push_back(q[i]);
}

class GlbWriter {
 public:
  GlbWriter(const Skeleton& skeleton, const Clip& clip)
      : skeleton_(skeleton), clip_(clip), nodeOf_(skeleton.size(), -1) {}

  std::vector<std::uint8_t> write() {
    model_.asset.version = "2.0";
    model_.asset.generator = "Stridegraph";
    addNodes();
    if (clip_.frameCount() > 0) addAnimation();
    addBody();
    model_.scenes.emplace_back();
    model_.scenes.back().nodes = {0, static_cast<int>(model_.nodes.size() - 1)};
    model_.defaultScene = 0;
    std::ostringstream stream;
    tinygltf::TinyGLTF writer;
    STRIDEGRAPH_CHECK(writer.WriteGltfSceneToStream(&model_, stream, false, true));
    const std::string text = stream.str();
    return {text.begin(), text.end()};
  }

 private:
  /// A node for each joint that can turn, placed as in the first frame.
  void addNodes() {
    for (std::size_t j = 0; j < skeleton_.size(); ++j) {
      const Joint& joint = skeleton_.joints[j];
      if (joint.isEndSite) continue;
      nodeOf_[j] = static_cast<int>(model_.nodes.size());
      tinygltf::Node& node = model_.nodes.emplace_back();
      node.name = joint.name;
      const bool hasPose = clip_.frameCount() > 0;
      const Vec3 place = !joint.parent && hasPose ? clip_.rootPositions[0] : joint.offset;
      node.translation = {place.x(), place.y(), place.z()};
      if (hasPose) {
        const Quat q = clip_.rotations[j].normalized();
        node.rotation = {q.x(), q.y(), q.z(), q.w()};
      }
      if (joint.parent) {
        model_.nodes[static_cast<std::size_t>(nodeOf_[joint.parent->value])].children.push_back(nodeOf_[j]);
      }
    }
  }

  void addAnimation() {
    std::vector<float> times;
    std::vector<float> translations;
    for (std::size_t f = 0; f < clip_.frameCount(); ++f) {
      times.push_back(static_cast<float>(static_cast<double>(f) / clip_.framesPerSecond));
      appendFloats(clip_.rootPositions[f], translations);
    }
    tinygltf::Animation animation;
    animation.name = clip_.name;
    const int timesIndex = addGlbAccessor(model_, bytesOf(times), kTimes);
    addChannel(animation, 0, "translation",
               {timesIndex, addGlbAccessor(model_, bytesOf(translations), kTranslations)});
    for (std::size_t j = 0; j < skeleton_.size(); ++j) {
      if (nodeOf_[j] < 0) continue;
      std::vector<float> rotations;
      for (std::size_t f = 0; f < clip_.frameCount(); ++f)
        appendFloats(clip_.pose(f).rotations[j], rotations);
      addChannel(animation, nodeOf_[j], "rotation",
                 {timesIndex, addGlbAccessor(model_, bytesOf(rotations), kRotations)});
    }
    model_.animations.push_back(std::move(animation));
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

  void addBody() {
    const BodyMesh body = buildBodyMesh(skeleton_);
    std::vector<std::uint16_t> carriers;
    std::vector<std::uint8_t> weights;
    for (const std::uint16_t joint : body.joints) {
      carriers.insert(carriers.end(), {static_cast<std::uint16_t>(nodeOf_[joint]), 0, 0, 0});
      weights.insert(weights.end(), {255, 0, 0, 0});
    }
    tinygltf::Primitive primitive;
    primitive.mode = TINYGLTF_MODE_TRIANGLES;
    primitive.material = 0;
    primitive.attributes["POSITION"] = addGlbAccessor(model_, bytesOf(body.positions), kPositions);
    primitive.attributes["NORMAL"] = addGlbAccessor(model_, bytesOf(body.normals), kNormals);
    primitive.attributes["JOINTS_0"] = addGlbAccessor(model_, bytesOf(carriers), kJointIndices);
    primitive.attributes["WEIGHTS_0"] = addGlbAccessor(model_, bytesOf(weights), kWeights);
    primitive.indices = addGlbAccessor(model_, bytesOf(body.indices), kIndices);
    tinygltf::Mesh& mesh = model_.meshes.emplace_back();
    mesh.name = "body";
    mesh.primitives.push_back(std::move(primitive));

    tinygltf::Material& material = model_.materials.emplace_back();
    material.name = "plain";
    material.pbrMetallicRoughness.baseColorFactor = {0.55, 0.62, 0.70, 1.0};
    material.pbrMetallicRoughness.metallicFactor = 0.0;
    material.pbrMetallicRoughness.roughnessFactor = 0.7;
    addSkin();
    tinygltf::Node& node = model_.nodes.emplace_back();
    node.name = "body";
    node.mesh = 0;
    node.skin = 0;
  }

  /// The body was made in the rest pose, where no joint is turned: binding takes its place off, no more.
  void addSkin() {
    tinygltf::Skin skin;
    std::vector<float> jointFromRest;
    std::vector<Vec3> rest(skeleton_.size(), Vec3::Zero());
    for (std::size_t j = 0; j < skeleton_.size(); ++j) {
      const Joint& joint = skeleton_.joints[j];
      if (joint.parent) rest[j] = rest[joint.parent->value] + joint.offset;
      if (nodeOf_[j] < 0) continue;
      skin.joints.push_back(nodeOf_[j]);
      for (Eigen::Index column = 0; column < 3; ++column) {
        appendFloats(Vec3(Mat3::Identity().col(column)), jointFromRest);
        jointFromRest.push_back(0.0F);
      }
      appendFloats(Vec3(-rest[j]), jointFromRest);
      jointFromRest.push_back(1.0F);
    }
    skin.skeleton = 0;
    skin.inverseBindMatrices = addGlbAccessor(model_, bytesOf(jointFromRest), kMatrices);
    model_.skins.push_back(std::move(skin));
  }

  const Skeleton& skeleton_;
  const Clip& clip_;
  std::vector<int> nodeOf_;  ///< For each joint its node, -1 for end sites. Also its place in the skin.
  tinygltf::Model model_;
};

}  // namespace

std::vector<std::uint8_t> writeGlb(const Skeleton& skeleton, const Clip& clip) {
  STRIDEGRAPH_CHECK(!skeleton.joints.empty() && clip.jointCount == skeleton.size());
  return GlbWriter(skeleton, clip).write();
}

}  // namespace stridegraph
