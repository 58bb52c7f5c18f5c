#include "walk_values.h"

#include <string>
#include <utility>
#include <vector>

#include "js_values.h"
#include "motion/bvh_writer.h"
#include "motion/glb_writer.h"
#include "motion/kinematics.h"
#include "motion/round_body.h"

namespace stridegraph::bindings {
namespace {

using emscripten::val;

std::vector<double> rootPositionsOf(const Clip& clip) {
  std::vector<double> numbers;
  numbers.reserve(clip.rootPositions.size() * 3);
  for (const Vec3& position : clip.rootPositions) {
    numbers.insert(numbers.end(), {position.x(), position.y(), position.z()});
  }
  return numbers;
}

std::vector<double> rotationsOf(const Clip& clip) {
  std::vector<double> numbers;
  numbers.reserve(clip.rotations.size() * 4);
  for (const Quat& rotation : clip.rotations) {
    numbers.insert(numbers.end(), {rotation.w(), rotation.x(), rotation.y(), rotation.z()});
  }
  return numbers;
}

std::vector<float> worldPositionsOf(const Skeleton& skeleton, const Clip& clip) {
  std::vector<float> numbers;
  numbers.reserve(clip.rotations.size() * 3);
  std::vector<JointPlacement> placements(skeleton.size());
  for (std::size_t frame = 0; frame < clip.frameCount(); ++frame) {
    placeJoints(skeleton, clip.pose(frame), placements);
    for (const JointPlacement& placement : placements) {
      for (const double coordinate : placement.position) numbers.push_back(static_cast<float>(coordinate));
    }
  }
  return numbers;
}

std::vector<std::uint8_t> blendedFrames(const Plan& plan) {
  std::vector<std::uint8_t> flags;
  flags.reserve(plan.frameKinds.size());
  for (const EdgeKind kind : plan.frameKinds) flags.push_back(kind == EdgeKind::kTransition ? 1 : 0);
  return flags;
}

std::vector<Vec2> roadmapEnds(const Plan& plan) {
  std::vector<Vec2> ends;
  ends.reserve(plan.roadmap.size() * 2);
  for (const auto& [from, to] : plan.roadmap) ends.insert(ends.end(), {from, to});
  return ends;
}

val jointValue(const Joint& joint) {
  val value = val::object();
  value.set("name", textValue(joint.name));
  value.set("parent", joint.parent ? static_cast<double>(joint.parent->value) : -1.0);
  value.set("isEndSite", joint.isEndSite);
  val offset = val::array();
  for (const double coordinate : joint.offset) offset.call<void>("push", coordinate);
  value.set("offset", offset);
  return value;
}

Joint jointFrom(const val& value) {
  Joint joint;
  joint.name = textFrom(value["name"]);
  const double parent = value["parent"].as<double>();
  if (parent >= 0) joint.parent = JointIndex(static_cast<std::size_t>(parent));
  joint.isEndSite = value["isEndSite"].as<bool>();
  for (int axis = 0; axis < 3; ++axis) joint.offset[axis] = value["offset"][axis].as<double>();
  return joint;
}

/// Calls take(number) for every number of a body's part; what it returns takes the number's place.
template <typename Take>
void visitNumbers(BodyPart& part, const Take& take) {
  for (PartEnd* const end : {&part.from, &part.to}) {
    end->joint = JointIndex(static_cast<std::size_t>(take(static_cast<double>(end->joint.value))));
    for (double& coordinate : end->offset) coordinate = take(coordinate);
    end->radius = take(end->radius);
  }
}
constexpr std::size_t kNumbersOfPart = 10;

val bodyValue(const RoundBody& body) {
  std::vector<double> standing(body.standing.rootPosition.begin(), body.standing.rootPosition.end());
  for (const Quat& q : body.standing.rotations) standing.insert(standing.end(), {q.w(), q.x(), q.y(), q.z()});
  std::vector<double> parts;
  for (BodyPart part : body.parts) {
    visitNumbers(part, [&](double number) {
      parts.push_back(number);
      return number;
    });
  }
  val value = val::object();
  value.set("standing", copyOut<double>(standing));
  value.set("parts", copyOut<double>(parts));
  value.set("lift", body.liftMetres);
  return value;
}

RoundBody readBody(const val& value) {
  RoundBody body;
  const auto standing = emscripten::convertJSArrayToNumberVector<double>(value["standing"]);
  const auto parts = emscripten::convertJSArrayToNumberVector<double>(value["parts"]);
  body.liftMetres = value["lift"].as<double>();
  body.standing.rootPosition = {standing[0], standing[1], standing[2]};
  for (std::size_t i = 3; i + 3 < standing.size(); i += 4)
    body.standing.rotations.emplace_back(standing[i], standing[i + 1], standing[i + 2], standing[i + 3]);
  std::size_t next = 0;
  for (std::size_t i = 0; i < parts.size() / kNumbersOfPart; ++i)
    visitNumbers(body.parts.emplace_back(), [&](double) { return parts[next++]; });
  return body;
}

val vectorValue(const Vec3& vector) {
  val value = val::array();
  for (const double coordinate : vector) value.call<void>("push", coordinate);
  return value;
}

Vec3 vectorFrom(const val& value) {
  Vec3 vector;
  for (int axis = 0; axis < 3; ++axis) vector[axis] = value[axis].as<double>();
  return vector;
}

val channelsValue(const std::vector<BvhChannel>& channels) {
  val list = val::array();
  for (const BvhChannel channel : channels) list.call<void>("push", static_cast<int>(channel));
  return list;
}

std::vector<BvhChannel> channelsFrom(const val& value) {
  std::vector<BvhChannel> channels;
  for (const int channel : emscripten::vecFromJSArray<int>(value))
    channels.push_back(static_cast<BvhChannel>(channel));
  return channels;
}

val stillPartValue(const BvhStillPart& still) {
  val joints = val::array();
  for (const BvhStillJoint& entry : still.joints) {
    val value = jointValue(entry.joint);
    const Quat& q = entry.rotation;
    val rotation = val::array();
    for (const double part : {q.w(), q.x(), q.y(), q.z()}) rotation.call<void>("push", part);
    value.set("rotation", rotation);
    value.set("channels", channelsValue(entry.channels));
    value.set("endSiteName", textValue(entry.endSiteName));
    joints.call<void>("push", value);
  }
  val value = val::object();
  value.set("joints", joints);
  value.set("before", static_cast<double>(still.before));
  value.set("holder", static_cast<double>(still.holder));
  value.set("rootOffset", vectorValue(still.rootOffset));
  return value;
}

BvhStillPart stillPartFrom(const val& value) {
  BvhStillPart still;
  for (const val& entry : emscripten::vecFromJSArray<val>(value["joints"])) {
    const val rotation = entry["rotation"];
    const auto part = [&](int i) { return rotation[i].as<double>(); };
    still.joints.push_back({jointFrom(entry),
                            {part(0), part(1), part(2), part(3)},
                            channelsFrom(entry["channels"]),
                            textFrom(entry["endSiteName"])});
  }
  still.before = static_cast<std::size_t>(value["before"].as<double>());
  still.holder = static_cast<std::size_t>(value["holder"].as<double>());
  still.rootOffset = vectorFrom(value["rootOffset"]);
  return still;
}

/// What skeletonValue made, back in core's own types.
struct ExportedSkeleton {
  Skeleton skeleton;
  BvhLayout layout;
  RoundBody body;
};

ExportedSkeleton readSkeleton(const val& value) {
  ExportedSkeleton exported;
  const auto joints = emscripten::vecFromJSArray<val>(value["joints"]);
  const auto channels = emscripten::vecFromJSArray<val>(value["channels"]);
  for (std::size_t i = 0; i < joints.size(); ++i) {
    exported.skeleton.joints.push_back(jointFrom(joints[i]));
    exported.layout.channels.push_back(channelsFrom(channels[i]));
  }
  for (const val& name : emscripten::vecFromJSArray<val>(value["endSiteNames"]))
    exported.layout.endSiteNames.push_back(textFrom(name));
  exported.layout.unitsPerMetre = value["unitsPerMetre"].as<double>();
  exported.layout.up = static_cast<UpAxis>(value["up"].as<int>());
  exported.body = readBody(value["body"]);
  exported.layout.still = stillPartFrom(value["still"]);
  return exported;
}

Clip readClip(const val& value, std::size_t jointCount) {
  Clip clip;
  const auto roots = emscripten::convertJSArrayToNumberVector<double>(value["rootPositions"]);
  const auto rotations = emscripten::convertJSArrayToNumberVector<double>(value["rotations"]);
  clip.name = "walk";
  clip.framesPerSecond = value["fps"].as<double>();
  clip.jointCount = jointCount;
  for (std::size_t i = 0; i + 2 < roots.size(); i += 3)
    clip.rootPositions.emplace_back(roots[i], roots[i + 1], roots[i + 2]);
  for (std::size_t i = 0; i + 3 < rotations.size(); i += 4)
    clip.rotations.emplace_back(rotations[i], rotations[i + 1], rotations[i + 2], rotations[i + 3]);
  return clip;
}

}  // namespace

val jointValues(const Skeleton& skeleton) {
  val joints = val::array();
  for (const Joint& joint : skeleton.joints) joints.call<void>("push", jointValue(joint));
  return joints;
}

val skeletonValue(const MotionLibrary& library) {
  const BvhLayout& layout = library.layout;
  val channels = val::array();
  for (const auto& channelsOfJoint : layout.channels)
    channels.call<void>("push", channelsValue(channelsOfJoint));
  val endSiteNames = val::array();
  for (const std::string& name : layout.endSiteNames) endSiteNames.call<void>("push", textValue(name));

  val value = val::object();
  value.set("joints", jointValues(library.skeleton));
  value.set("channels", channels);
  value.set("endSiteNames", endSiteNames);
  value.set("unitsPerMetre", layout.unitsPerMetre);
  value.set("up", static_cast<int>(layout.up));
  value.set("body", bodyValue(roundBody(library.skeleton, library.frames)));
  value.set("still", stillPartValue(layout.still));
  return value;
}

val planValue(const Skeleton& skeleton, const Plan& plan) {
  val value = val::object();
  value.set("status", std::string(planStatusName(plan.report.status)));
  value.set("report", textValue(toJson(plan)));
  value.set("kept", plan.kept);
  value.set("fps", plan.walk.framesPerSecond);
  value.set("frames", static_cast<double>(plan.walk.frameCount()));
  value.set("rootPositions", copyOut<double>(rootPositionsOf(plan.walk)));
  value.set("rotations", copyOut<double>(rotationsOf(plan.walk)));
  value.set("positions", copyOut<float>(worldPositionsOf(skeleton, plan.walk)));
  value.set("blended", copyOut<std::uint8_t>(blendedFrames(plan)));
  value.set("contacts", copyOut<ContactMask>(plan.contacts));
  value.set("path", floorPoints(plan.path));
  value.set("subgoals", floorPoints(plan.subgoals));
  value.set("roadmap", floorPoints(roadmapEnds(plan)));
  val others = val::array();
  for (const Plan& other : plan.others) others.call<void>("push", planValue(skeleton, other));
  value.set("others", others);
  return value;
}

val walkToBvh(const val& skeleton, const val& walk) {
  const ExportedSkeleton exported = readSkeleton(skeleton);
  return succeed(
      textValue(writeBvh(exported.skeleton, exported.layout, readClip(walk, exported.skeleton.size()))));
}

val walksToGlb(const val& skeleton, const val& walks) {
  const ExportedSkeleton exported = readSkeleton(skeleton);
  std::vector<Clip> clips;
  std::vector<WalkerClip> all;
  for (const val& walk : emscripten::vecFromJSArray<val>(walks)) {
    clips.push_back(readClip(walk, exported.skeleton.size()));
    all.push_back({nullptr, static_cast<std::size_t>(walk["walker"].as<double>())});
  }
  for (std::size_t i = 0; i < all.size(); ++i) all[i].clip = &clips[i];
  const std::vector<std::uint8_t> bytes = writeGlb(exported.skeleton, exported.body, all);
  return succeed(copyOut<std::uint8_t>(bytes));
}

}  // namespace stridegraph::bindings
