#include "motion/glb_writer.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <array>
#include <sstream>
#include <string>
#include <string_view>
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
  GlbWriter(const Skeleton& skeleton, std::span<const Clip* const> clips)
      : skeleton_(skeleton), clips_(clips), placeOf_(skeleton.size(), -1) {
    int places = 0;
    for (std::size_t j = 0; j < skeleton.size(); ++j)
      if (!skeleton.joints[j].isEndSite) placeOf_[j] = places++;
  }

  std::vector<std::uint8_t> write() {
    model_.asset.version = "2.0";
    model_.asset.generator = "Stridegraph";
    model_.scenes.emplace_back();
    model_.defaultScene = 0;
    tinygltf::Animation animation;
    animation.name = clips_.size() == 1 ? clips_.front()->name : "walks";
    for (const Clip* clip : clips_) {
      addNodes(*clip);
      if (clip->frameCount() > 0) addTracks(*clip, animation);
    }
    if (!animation.channels.empty()) model_.animations.push_back(std::move(animation));
    addMesh();
    const int matrices = addMatrices();
    for (std::size_t walker = 0; walker < clips_.size(); ++walker) addBody(walker, matrices);
    std::ostringstream stream;
    tinygltf::TinyGLTF writer;
    STRIDEGRAPH_CHECK(writer.WriteGltfSceneToStream(&model_, stream, false, true));
    const std::string text = stream.str();
    return {text.begin(), text.end()};
  }

 private:
  /// Of a file with several bodies each is named for its walker.
  std::string named(std::string_view what, std::size_t walker) const {
    return clips_.size() == 1 ? std::string(what)
                              : fmt::format("walker_{}{}{}", walker + 1, what.empty() ? "" : "_", what);
  }

  int nodeCount() const { return static_cast<int>(model_.nodes.size()); }

  /// A node for each joint that can turn, placed as in the first frame; below one of their own where there
  /// are several walkers.
  void addNodes(const Clip& clip) {
    const std::size_t walker = firstNodes_.size();
    const int top = nodeCount();
    model_.scenes.front().nodes.push_back(top);
    if (clips_.size() > 1) {
      model_.nodes.emplace_back().name = named("", walker);
      model_.nodes.back().children.push_back(top + 1);
    }
    firstNodes_.push_back(nodeCount());
    for (std::size_t j = 0; j < skeleton_.size(); ++j) {
      const Joint& joint = skeleton_.joints[j];
      if (joint.isEndSite) continue;
      const int index = nodeCount();
      tinygltf::Node& node = model_.nodes.emplace_back();
      node.name = joint.name;
      const bool hasPose = clip.frameCount() > 0;
      const Vec3 place = !joint.parent && hasPose ? clip.rootPositions[0] : joint.offset;
      node.translation = {place.x(), place.y(), place.z()};
      if (hasPose) {
        const Quat q = clip.rotations[j].normalized();
        node.rotation = {q.x(), q.y(), q.z(), q.w()};
      }
      if (joint.parent)
        model_.nodes[static_cast<std::size_t>(nodeOf(joint.parent->value, walker))].children.push_back(index);
    }
  }

  int nodeOf(std::size_t joint, std::size_t walker) const { return firstNodes_[walker] + placeOf_[joint]; }

  /// Adds what moves the walker whose nodes were added last.
  void addTracks(const Clip& clip, tinygltf::Animation& animation) {
    const std::size_t walker = firstNodes_.size() - 1;
    std::vector<float> times;
    std::vector<float> translations;
    for (std::size_t f = 0; f < clip.frameCount(); ++f) {
      times.push_back(static_cast<float>(static_cast<double>(f) / clip.framesPerSecond));
      appendFloats(clip.rootPositions[f], translations);
    }
    const int timesIndex = addGlbAccessor(model_, bytesOf(times), kTimes);
    addChannel(animation, nodeOf(0, walker), "translation",
               {timesIndex, addGlbAccessor(model_, bytesOf(translations), kTranslations)});
    for (std::size_t j = 0; j < skeleton_.size(); ++j) {
      if (placeOf_[j] < 0) continue;
      std::vector<float> rotations;
      for (std::size_t f = 0; f < clip.frameCount(); ++f) appendFloats(clip.pose(f).rotations[j], rotations);
      addChannel(animation, nodeOf(j, walker), "rotation",
                 {timesIndex, addGlbAccessor(model_, bytesOf(rotations), kRotations)});
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

  /// The body that all walkers share.
  void addMesh() {
    const BodyMesh body = buildBodyMesh(skeleton_);
    std::vector<std::uint16_t> carriers;
    std::vector<std::uint8_t> weights;
    for (const std::uint16_t joint : body.joints) {
      carriers.insert(carriers.end(), {static_cast<std::uint16_t>(placeOf_[joint]), 0, 0, 0});
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
  }

  /// The body was made in the rest pose, where no joint is turned: binding takes its place off, no more.
  int addMatrices() {
    std::vector<float> jointFromRest;
    std::vector<Vec3> rest(skeleton_.size(), Vec3::Zero());
    for (std::size_t j = 0; j < skeleton_.size(); ++j) {
      const Joint& joint = skeleton_.joints[j];
      if (joint.parent) rest[j] = rest[joint.parent->value] + joint.offset;
      if (placeOf_[j] < 0) continue;
      for (Eigen::Index column = 0; column < 3; ++column) {
        appendFloats(Vec3(Mat3::Identity().col(column)), jointFromRest);
        jointFromRest.push_back(0.0F);
      }
      appendFloats(Vec3(-rest[j]), jointFromRest);
      jointFromRest.push_back(1.0F);
    }
    return addGlbAccessor(model_, bytesOf(jointFromRest), kMatrices);
  }

  /// Skins the body to a walker's joints. Skinned nodes stand at the top of a scene, else viewers disagree.
  void addBody(std::size_t walker, int matrices) {
    tinygltf::Skin& skin = model_.skins.emplace_back();
    for (std::size_t j = 0; j < skeleton_.size(); ++j)
      if (placeOf_[j] >= 0) skin.joints.push_back(nodeOf(j, walker));
    skin.skeleton = firstNodes_[walker];
    skin.inverseBindMatrices = matrices;
    model_.scenes.front().nodes.push_back(nodeCount());
    tinygltf::Node& node = model_.nodes.emplace_back();
    node.name = named("body", walker);
    node.mesh = 0;
    node.skin = static_cast<int>(walker);
  }

  const Skeleton& skeleton_;
  std::span<const Clip* const> clips_;
  std::vector<int> placeOf_;     ///< For each joint its place in the skins, -1 for end sites.
  std::vector<int> firstNodes_;  ///< For each walker the node of its root joint; the others follow.
  tinygltf::Model model_;
};

}  // namespace

std::vector<std::uint8_t> writeGlb(const Skeleton& skeleton, std::span<const Clip* const> clips) {
  STRIDEGRAPH_CHECK(!skeleton.joints.empty() && !clips.empty());
  for (const Clip* clip : clips) STRIDEGRAPH_CHECK(clip->jointCount == skeleton.size());
  return GlbWriter(skeleton, clips).write();
}

std::vector<std::uint8_t> writeGlb(const Skeleton& skeleton, const Clip& clip) {
  return writeGlb(skeleton, std::array{&clip});
}

}  // namespace stridegraph
