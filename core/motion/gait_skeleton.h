#pragma once

#include <array>
#include <cstddef>

#include "motion/bvh_layout.h"
#include "motion/leg_ik.h"
#include "motion/skeleton.h"

namespace stridegraph {

/// Joints of the gait model's body, in the order of the files of the CMU Graphics Lab Motion Capture Database
/// that the model was measured on.
enum class GaitJoint : std::size_t {
  kPelvis,
  kLeftFemur,
  kLeftTibia,
  kLeftFoot,
  kLeftToes,
  kLeftToesEnd,
  kRightFemur,
  kRightTibia,
  kRightFoot,
  kRightToes,
  kRightToesEnd,
  kThorax,
  kHead,
  kHeadEnd,
  kLeftClavicle,
  kLeftHumerus,
  kLeftRadius,
  kLeftHand,
  kLeftHandEnd,
  kRightClavicle,
  kRightHumerus,
  kRightRadius,
  kRightHand,
  kRightHandEnd,
};
inline constexpr std::size_t kGaitJointCount = 24;

constexpr std::size_t indexOf(GaitJoint joint) {
  return static_cast<std::size_t>(joint);
}

enum class Side { kLeft, kRight };

/// The joint of the same name on the other side; central joints are their own.
GaitJoint otherSide(GaitJoint joint);

/// The body: subject 16's bones in metres, rest pose standing with legs and arms straight down, facing +z.
Skeleton gaitSkeleton();

/// Written as those files are: centimetres, position on the root, rotations in ZXY order.
BvhLayout gaitBvhLayout();

/// Hip, knee and ankle of one side.
Leg gaitLeg(Side side);

/// Height of the toe end over y = 0 when it touches the floor: the thickness of a shod foot below its joints.
inline constexpr double kGaitSoleMetres = 0.0335;

}  // namespace stridegraph
