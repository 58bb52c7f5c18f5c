#include "motion/travelling_root.h"

#include <gtest/gtest.h>

#include "math/random.h"
#include "motion/bvh_interpretation.h"
#include "motion/bvh_texts.h"
#include "motion/bvh_writer.h"
#include "motion/parsed_motions.h"
#include "motion/test_motions.h"

namespace stridegraph {
namespace {

using testing::addBody;
using testing::kRotationChannels;
using testing::kSixChannels;
using testing::ParsedBvh;
using testing::relativeTo;
using testing::rootOf;
using testing::warningsOf;

constexpr double kCentimetres = 100.0;
const BvhReadParams kKnown = {kCentimetres, UpAxis::kY};

BvhDocument interpreted(const ParsedBvh& parsed) {
  Result<BvhDocument> document = interpretBvh(parsed.hierarchy, parsed.motion, "body.bvh", kKnown);
  EXPECT_TRUE(document) << describe(document.error());
  return document ? *std::move(document) : BvhDocument{};
}

Clip walk() {
  return testing::walkOf({.frames = 50, .turnPerSecond = Angle::degrees(30)});
}

/// The greatest distance, in metres, of a joint of the document from the walker's joint of the same name.
double greatestDistanceFrom(const Clip& clip, const BvhDocument& document) {
  const Skeleton walker = testing::walker();
  double greatest = 0.0;
  for (std::size_t f = 0; f < clip.frameCount(); ++f) {
    const std::vector<Vec3> expected = jointPositions(walker, clip.pose(f));
    const std::vector<Vec3> found = jointPositions(document.skeleton, document.clip.pose(f));
    for (std::size_t j = 0; j < walker.size(); ++j) {
      const auto joint = document.skeleton.find(walker.joints[j].name);
      if (!joint) return 1e9;
      greatest = std::max(greatest, (found[joint->value] - expected[j]).norm());
    }
  }
  return greatest;
}

Quat anyRotation(Random& random) {
  const auto part = [&] { return random.uniform(-1.0, 1.0); };
  return Quat(part(), part(), part(), part()).normalized();
}

Vec3 anyPosition(Random& random) {
  return {random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0)};
}

/// Where the lowest of joints that stand still lies, after rows were set for all.
JointPlacement placeStill(ParsedBvh& parsed, std::size_t count, Random& random) {
  JointPlacement world{Quat::Identity(), Vec3::Zero()};
  for (std::size_t j = 0; j < count; ++j) {
    const BvhJoint& joint = parsed.hierarchy.joints[j];
    const Quat rotation = joint.channels.empty() ? Quat::Identity() : anyRotation(random);
    const Vec3 position = joint.channels.size() == 6 ? anyPosition(random) : joint.offset / kCentimetres;
    for (std::size_t f = 0; f < parsed.motion.frameCount; ++f)
      parsed.place(j, f, position * kCentimetres, rotation);
    world = {world.rotation * rotation, world.position + world.rotation * position};
  }
  return world;
}

/// A walk below `count` joints that stand still anywhere.
ParsedBvh walkBelow(std::size_t count, const Clip& clip, std::uint64_t seed) {
  Random random(seed);
  ParsedBvh parsed;
  for (std::size_t j = 0; j < count; ++j) {
    const std::size_t kind = random.below(3);
    parsed.addJoint("still" + std::to_string(j), j == 0 ? std::nullopt : std::optional(j - 1),
                    anyPosition(random) * kCentimetres,
                    kind == 0   ? std::vector<BvhChannel>()
                    : kind == 1 ? kRotationChannels
                                : kSixChannels);
  }
  ParsedBvh whole = parsed;
  addBody(whole, testing::walker(), clip, count - 1, kCentimetres, [](std::size_t) {
    return JointPlacement{Quat::Identity(), Vec3::Zero()};
  });
  const JointPlacement holder = placeStill(whole, count, random);
  for (std::size_t f = 0; f < clip.frameCount(); ++f) {
    const JointPlacement root = relativeTo(holder, rootOf(clip, f));
    whole.place(count, f, root.position * kCentimetres, root.rotation);
  }
  return whole;
}

TEST(TravellingRoot, isTheJointBelowAnyJointsThatStandStill) {
  const Clip clip = walk();
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const BvhDocument document = interpreted(walkBelow(1 + seed % 3, clip, seed));
    ASSERT_EQ(document.skeleton.joints.front().name, "hips") << seed;
    EXPECT_EQ(differenceBetween(document.skeleton, testing::walker(), 1e-9), "") << seed;
    EXPECT_LT(greatestDistanceFrom(clip, document), 1e-9) << seed;
  }
}

TEST(TravellingRoot, isWrittenBackBelowTheJointsThatStandStill) {
  const Clip clip = walk();
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const ParsedBvh parsed = walkBelow(1 + seed % 3, clip, seed);
    const BvhDocument document = interpreted(parsed);
    const std::string text = writeBvh(document.skeleton, document.layout, document.clip);
    const BvhDocument back = testing::read(text, kKnown);
    EXPECT_LT(greatestDistanceFrom(clip, back), 1e-4) << seed;
    EXPECT_EQ(back.layout.channels, document.layout.channels) << seed;
    ASSERT_EQ(back.layout.still.joints.size(), 1 + seed % 3) << seed;
    for (std::size_t s = 0; s < back.layout.still.joints.size(); ++s) {
      const BvhStillJoint& expected = document.layout.still.joints[s];
      const BvhStillJoint& found = back.layout.still.joints[s];
      EXPECT_EQ(found.joint.name, parsed.hierarchy.joints[s].name);
      EXPECT_EQ(found.channels, parsed.hierarchy.joints[s].channels);
      EXPECT_LT((found.joint.offset - expected.joint.offset).norm(), 1e-6);
      EXPECT_LT(angleBetween(found.rotation, expected.rotation).degrees(), 1e-3);
    }
  }
}

TEST(TravellingRoot, goesTheWayOfTwoJointsThatTravelTogether) {
  const Clip clip = walk();
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Random random(seed);
    const double share = random.uniform(0.2, 1.0);
    const double swayMetres = random.uniform(0.02, 0.5);
    const auto trajectory = [&](std::size_t f) {
      const JointPlacement root = rootOf(clip, f);
      const Vec3 sway(swayMetres * std::sin(0.2 * static_cast<double>(f)), 0.0, 0.0);
      const Vec3 onFloor(root.position.x(), 0.0, root.position.z());
      return JointPlacement{headingOf(root.rotation).rotation(), onFloor * share + sway};
    };
    ParsedBvh parsed;
    parsed.addJoint("trajectory", {}, Vec3::Zero(), kSixChannels);
    addBody(parsed, testing::walker(), clip, 0, kCentimetres,
            [&](std::size_t f) { return relativeTo(trajectory(f), rootOf(clip, f)); });
    for (std::size_t f = 0; f < clip.frameCount(); ++f)
      parsed.place(0, f, trajectory(f).position * kCentimetres, trajectory(f).rotation);
    const BvhDocument document = interpreted(parsed);
    ASSERT_EQ(document.skeleton.joints.front().name, "hips") << seed;
    EXPECT_LT(greatestDistanceFrom(clip, document), 1e-9) << seed;
    EXPECT_EQ(warningsOf(document),
              "body.bvh: joint \"hips\" is taken as the root of the motion: it moves against \"trajectory\" "
              "above it, and both movements together are its path\n");
  }
}

/// A walk below a root that stands still, with a prop, a camera and two targets beside the hips.
ParsedBvh walkAmongOthers(const Clip& clip) {
  ParsedBvh parsed;
  parsed.addJoint("Reference", {}, Vec3::Zero(), kSixChannels);
  const std::size_t camera = parsed.addJoint("camera", 0, Vec3(0, 300, 500), kRotationChannels);
  parsed.addEndSite(camera, Vec3(0, 0, 10));
  addBody(parsed, testing::walker(), clip, 0, kCentimetres, [&](std::size_t f) { return rootOf(clip, f); });
  const std::size_t body = parsed.hierarchy.joints.size();
  parsed.addJoint("leftTarget", 0, Vec3::Zero(), kSixChannels);
  parsed.addJoint("chair", 0, Vec3(50, 0, 0), {});
  ParsedBvh whole = parsed;
  whole.setFrames(clip.frameCount());
  for (std::size_t f = 0; f < clip.frameCount(); ++f) {
    const std::vector<Vec3> positions = jointPositions(testing::walker(), clip.pose(f));
    whole.place(body, f, positions[3] * kCentimetres, Quat::Identity());
    whole.place(3, f, clip.rootPositions[f] * kCentimetres, clip.pose(f).rotations[0]);
    for (std::size_t j = 1; j < testing::walker().size(); ++j)
      whole.place(3 + j, f, Vec3::Zero(), clip.pose(f).rotations[j]);
  }
  return whole;
}

TEST(TravellingRoot, leavesOutWhatIsBesideTheBodyAndSaysSo) {
  const Clip clip = walk();
  const BvhDocument document = interpreted(walkAmongOthers(clip));
  EXPECT_EQ(differenceBetween(document.skeleton, testing::walker(), 1e-9), "");
  EXPECT_LT(greatestDistanceFrom(clip, document), 1e-9);
  EXPECT_EQ(
      warningsOf(document),
      "body.bvh: joint \"hips\" is taken as the root of the motion: it travels, and \"Reference\" above "
      "it stands still\n"
      "body.bvh: \"camera\", \"leftTarget\" and \"chair\" beside \"hips\" are not part of the body: left "
      "out, and still in BVH files that are written\n");
  for (const Warning& warning : document.warnings) EXPECT_EQ(warning.topic, WarningTopic::kTravel);
}

TEST(TravellingRoot, isWrittenBackBesideTheOthersInTheirOrder) {
  const ParsedBvh parsed = walkAmongOthers(walk());
  const BvhDocument document = interpreted(parsed);
  EXPECT_EQ(document.layout.still.before, 3U);
  const BvhDocument back = testing::read(writeBvh(document.skeleton, document.layout, document.clip), kKnown);
  EXPECT_LT(testing::greatestDistance(document, back), 1e-4);
  ASSERT_EQ(back.layout.still.joints.size(), 5U);
  std::vector<std::string> names;
  for (const BvhStillJoint& entry : back.layout.still.joints) names.push_back(entry.joint.name);
  EXPECT_EQ(names, (std::vector<std::string>{"Reference", "camera", "camera#end", "leftTarget", "chair"}));
  EXPECT_TRUE(back.layout.still.joints[1].joint.offset.isApprox(Vec3(0, 3, 5), 1e-6));
}

TEST(TravellingRoot, isTheSameInAWalkAndInAnIdleClip) {
  // The hips sway by a few millimetres, with the camera and the chair still there.
  Clip idle = walk();
  for (std::size_t f = 0; f < idle.frameCount(); ++f)
    idle.rootPositions[f] = Vec3(0.004 * std::sin(0.3 * static_cast<double>(f)), 0.9, 0.0);
  ParsedBvh parsed;
  parsed.addJoint("Reference", {}, Vec3::Zero(), kSixChannels);
  parsed.addJoint("camera", 0, Vec3(0, 300, 500), kRotationChannels);
  addBody(parsed, testing::walker(), idle, 0, kCentimetres, [&](std::size_t f) { return rootOf(idle, f); });
  EXPECT_EQ(interpreted(parsed).skeleton.joints.front().name, "hips");
}

TEST(TravellingRoot, isTheRootOfTheFileThatTravelsWhateverShakesBelowIt) {
  // Thighs and chest have position channels with marker noise, some centimetres of it.
  const Clip clip = walk();
  ParsedBvh parsed;
  const Skeleton walker = testing::walker();
  for (const Joint& joint : walker.joints) {
    const auto parent = joint.parent ? std::optional<std::size_t>(joint.parent->value) : std::nullopt;
    if (joint.isEndSite) {
      parsed.addEndSite(*parent, joint.offset * kCentimetres);
    } else {
      parsed.addJoint(joint.name, parent, joint.offset * kCentimetres, kSixChannels);
    }
  }
  parsed.setFrames(clip.frameCount());
  Random random(5);
  for (std::size_t f = 0; f < clip.frameCount(); ++f) {
    for (std::size_t j = 0; j < walker.size(); ++j) {
      const Vec3 noise(random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0));
      parsed.place(j, f, (j == 0 ? clip.rootPositions[f] : walker.joints[j].offset) * kCentimetres + noise,
                   clip.pose(f).rotations[j]);
    }
  }
  const BvhDocument document = interpreted(parsed);
  EXPECT_EQ(document.skeleton.size(), walker.size());
  EXPECT_TRUE(document.layout.still.joints.empty());
  for (const Warning& warning : document.warnings) {
    EXPECT_EQ(warning.topic, WarningTopic::kSkeleton) << describe(warning);
    EXPECT_NE(warning.message.find("its mean offset is used"), std::string::npos) << describe(warning);
  }
}

TEST(TravellingRoot, isTheFirstPlacedJointOfAPoseThatStandsStill) {
  Clip pose = walk();
  pose.rootPositions.resize(1);
  pose.rotations.resize(pose.jointCount);
  ParsedBvh parsed;
  parsed.addJoint("Armature", {}, Vec3::Zero(), {});
  parsed.addJoint("Reference", 0, Vec3::Zero(), kSixChannels);
  addBody(parsed, testing::walker(), pose, 1, kCentimetres, [&](std::size_t f) { return rootOf(pose, f); });
  const BvhDocument document = interpreted(parsed);
  EXPECT_EQ(document.skeleton.joints.front().name, "hips");
  EXPECT_LT(greatestDistanceFrom(pose, document), 1e-9);
}

}  // namespace
}  // namespace stridegraph
