#pragma once

#include <cmath>
#include <numbers>

#include "math/random.h"
#include "math/rotation.h"
#include "motion/clip.h"
#include "motion/test_characters.h"

namespace stridegraph::testing {

/// Two legs and a hand: hips at 0.9 m, feet 0.2 m apart that lie on the floor in the rest pose, with toes
/// 0.15 m in front of the ankles. Left is +x.
inline Skeleton walker() {
  const auto at = [](std::size_t index) { return JointIndex(index); };
  Skeleton skeleton;
  skeleton.joints = {{"hips", {}, {0, 0, 0}},
                     {"leftThigh", at(0), {0.1, 0, 0}},
                     {"leftShin", at(1), {0, -0.45, 0}},
                     {"leftFoot", at(2), {0, -0.4, 0}},
                     {"leftFoot#end", at(3), {0, -0.05, 0.15}, true},
                     {"rightThigh", at(0), {-0.1, 0, 0}},
                     {"rightShin", at(5), {0, -0.45, 0}},
                     {"rightFoot", at(6), {0, -0.4, 0}},
                     {"rightFoot#end", at(7), {0, -0.05, 0.15}, true},
                     {"chest", at(0), {0, 0.5, 0}},
                     {"leftArm", at(9), {0.2, 0, 0}},
                     {"leftHand", at(10), {0, -0.6, 0}},
                     {"leftHand#end", at(11), {0, -0.2, 0}, true}};
  return skeleton;
}

struct WalkShape {
  std::size_t frames = 60;
  double speedMetresPerSecond = 1.2;
  Angle turnPerSecond = {};  ///< Growing headings turn towards +x.
  double cyclesPerSecond = 1.0;
  double phaseCycles = 0.0;
  FloorTransform start = {};
};

/// The walker, walking: legs and arm swing as sines, the root goes where it faces along an arc.
inline Clip walkOf(const WalkShape& shape) {
  Clip clip{.name = "walk",
            .framesPerSecond = 30.0,
            .jointCount = walker().size(),
            .rootPositions = {},
            .rotations = {}};
  FloorTransform placement = shape.start;
  const Heading turn = Heading::fromAngle(shape.turnPerSecond * (1.0 / 30.0));
  const auto aboutX = [](double angleRadians) {
    return axisRotation(Axis::kX, Angle::radians(angleRadians));
  };
  for (std::size_t f = 0; f < shape.frames; ++f) {
    const double cycles = shape.phaseCycles + shape.cyclesPerSecond * static_cast<double>(f) / 30.0;
    const double swing = std::sin(2.0 * std::numbers::pi * cycles);
    const double lift = std::cos(2.0 * std::numbers::pi * cycles);
    Pose pose = restPose(walker(), {placement.translation.x(), 0.9, placement.translation.y()});
    pose.rotations[0] = placement.heading.rotation() * aboutX(0.03 * lift);
    pose.rotations[1] = aboutX(-0.4 * swing);
    pose.rotations[2] = aboutX(std::max(0.0, lift));
    pose.rotations[5] = aboutX(0.4 * swing);
    pose.rotations[6] = aboutX(std::max(0.0, -lift));
    pose.rotations[10] = aboutX(0.3 * swing);
    clip.append(pose.view());
    placement = placement * FloorTransform{{0.0, shape.speedMetresPerSecond / 30.0}, turn};
  }
  return clip;
}

/// A clip whose every joint wanders smoothly and at random: sums of slow sines.
inline Clip wanderingClip(const Skeleton& skeleton, std::size_t frames, std::uint64_t seed) {
  Random random(seed);
  const auto sine = [](double amplitude, double cyclesPerFrame, double phase, std::size_t frame) {
    return amplitude *
           std::sin(2.0 * std::numbers::pi * (cyclesPerFrame * static_cast<double>(frame) + phase));
  };
  std::vector<double> rates;
  std::vector<double> phases;
  for (std::size_t k = 0; k < 3 * (skeleton.size() + 1); ++k) {
    // The root's slower than the joints', so that it goes at a few metres a second at most.
    rates.push_back(k < 3 ? random.uniform(0.002, 0.005) : random.uniform(0.005, 0.04));
    phases.push_back(random.uniform());
  }
  Clip clip{.name = "wandering",
            .framesPerSecond = 30.0,
            .jointCount = skeleton.size(),
            .rootPositions = {},
            .rotations = {}};
  for (std::size_t f = 0; f < frames; ++f) {
    Pose pose =
        restPose(skeleton, {sine(2.0, rates[0], phases[0], f), 0.9 + sine(0.1, rates[1], phases[1], f),
                            sine(3.0, rates[2], phases[2], f)});
    for (std::size_t j = 0; j < skeleton.size(); ++j) {
      if (skeleton.joints[j].isEndSite) continue;
      const std::size_t k = 3 * (j + 1);
      pose.rotations[j] = fromEuler({Axis::kY, Axis::kX, Axis::kZ},
                                    {Angle::radians(sine(j == 0 ? 2.0 : 0.3, rates[k], phases[k], f)),
                                     Angle::radians(sine(0.3, rates[k + 1], phases[k + 1], f)),
                                     Angle::radians(sine(0.3, rates[k + 2], phases[k + 2], f))});
    }
    clip.append(pose.view());
  }
  return clip;
}

/// The clip, moved on the floor as a whole.
inline Clip movedOnFloor(const Clip& clip, const FloorTransform& transform) {
  Clip moved = clip;
  for (std::size_t f = 0; f < clip.frameCount(); ++f) {
    moved.rootPositions[f] = transform.apply(clip.rootPositions[f]);
    moved.rotationsOf(f)[0] = transform.heading.rotation() * clip.pose(f).rotations[0];
  }
  return moved;
}

}  // namespace stridegraph::testing
