#pragma once

#include "graph/library.h"
#include "motion/test_motions.h"
#include "walk/synthesis.h"

namespace stridegraph::testing {

inline constexpr std::size_t kLeftFoot = 3;
inline constexpr std::size_t kLeftTip = 4;
inline constexpr std::size_t kRightFoot = 7;
inline constexpr std::size_t kRightTip = 8;
inline constexpr ContactMask kAllDown = 0b1111;

/// The walker with both feet level and its knees bent to the front by twice `thighDegrees`, hips over `at`.
inline Pose standing(double thighDegrees, const Vec3& at) {
  Pose pose = restPose(walker(), at);
  const auto aboutX = [](double degrees) { return axisRotation(Axis::kX, Angle::degrees(degrees)); };
  for (const std::size_t thigh : {1, 5}) {
    pose.rotations[thigh] = aboutX(-thighDegrees);
    pose.rotations[thigh + 1] = aboutX(2.0 * thighDegrees);
    pose.rotations[thigh + 2] = aboutX(-thighDegrees);
  }
  return pose;
}

/// How high the hips of that pose are when the feet's tips touch y = 0.
inline double hipHeight(double thighDegrees) {
  const Pose pose = standing(thighDegrees, Vec3::Zero());
  return -jointPositions(walker(), pose.view())[kLeftTip].y();
}

/// A library of a second in which the walker stands still, knees bent a little. It has no graph.
inline MotionLibrary standingLibrary() {
  MotionLibrary library;
  library.skeleton = walker();
  library.frames.jointCount = library.skeleton.size();
  for (const std::size_t joint : {kLeftFoot, kLeftTip, kRightFoot, kRightTip})
    library.contactJoints.emplace_back(joint);
  for (int f = 0; f < 30; ++f) {
    library.frames.append(standing(15, {0, hipHeight(15), 0}).view());
    library.contacts.push_back(kAllDown);
  }
  library.clips = {{"standing", 0, 30, false}};
  return library;
}

/// Adds a frame to a walk of the walker.
inline void appendFrame(SynthesisedWalk& walk, const Pose& pose, ContactMask contacts) {
  walk.clip.jointCount = pose.rotations.size();
  walk.clip.append(pose.view());
  walk.contacts.push_back(contacts);
  walk.accelerations.emplace_back(Vec2::Zero());
  walk.frameKinds.push_back(EdgeKind::kClipPiece);
}

/// The walker stands with its feet on the floor and slides stiffly along z, evenly, by so much in all.
inline SynthesisedWalk slidingWalk(double thighDegrees, std::size_t frames, double wayMetres) {
  SynthesisedWalk walk;
  for (std::size_t f = 0; f < frames; ++f) {
    const double z = wayMetres * static_cast<double>(f) / static_cast<double>(frames - 1);
    appendFrame(walk, standing(thighDegrees, {0, hipHeight(thighDegrees), z}), kAllDown);
  }
  return walk;
}

/// Where a joint of the walker is, frame by frame.
inline std::vector<Vec3> trackOf(const SynthesisedWalk& walk, std::size_t joint) {
  std::vector<Vec3> track;
  for (std::size_t f = 0; f < walk.clip.frameCount(); ++f)
    track.push_back(jointPositions(walker(), walk.clip.pose(f))[joint]);
  return track;
}

}  // namespace stridegraph::testing
