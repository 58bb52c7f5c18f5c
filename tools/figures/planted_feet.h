#pragma once

#include <span>
#include <string>
#include <vector>

#include "graph/library.h"
#include "math/types.h"

namespace stridegraph::figures {

/// A foot that stands for a while.
struct PlantedFoot {
  bool left = false;
  std::size_t firstFrame = 0;
  std::size_t lastFrame = 0;
  Vec2 heel = Vec2::Zero();  ///< Under the ankle, metres on the floor,
  Vec2 toe = Vec2::Zero();   ///< and the joint farthest from it.
};

/// One of the body's feet: its contact joints, as bits of a ContactMask.
struct Foot {
  bool left = false;
  ContactMask mask = 0;
  JointIndex ankle;
  JointIndex toe;  ///< The last of the chain.
};

/// Contact joints that hang on each other make up a foot. Left is what lies so for most of the clip.
std::vector<Foot> feetOf(const MotionLibrary& library, const Clip& clip);

/// Where the feet of a clip stand, in the order in which they are put down; contacts as in the library, one
/// for each frame. The place is the mean over the frames in which most of the foot touches the floor.
std::vector<PlantedFoot> plantedFeet(const MotionLibrary& library, const Clip& clip,
                                     std::span<const ContactMask> contacts);

/// The outline of the sole, on the floor.
std::vector<Vec2> soleOutline(const PlantedFoot& foot);

}  // namespace stridegraph::figures
