#pragma once

#include <vector>

#include "motion/clip.h"
#include "motion/skeleton.h"

namespace stridegraph {

/// A ball that hangs on a joint: one end of a part of the body.
struct PartEnd {
  JointIndex joint;
  Vec3 offset = Vec3::Zero();  ///< In the joint's own axes, metres.
  double radius = 0.05;        ///< Metres, > 0.
};

/// A round cone: what a ball covers that moves from one end to the other while its radius changes evenly.
struct BodyPart {
  PartEnd from;
  PartEnd to;
};

/// A body of round cones on a skeleton: what the page shows and what exported files wear.
struct RoundBody {
  std::vector<BodyPart> parts;  ///< At least one.
  double liftMetres = 0.0;      ///< What poses are raised by, where the motion's floor is not y = 0.
  Pose standing;                ///< On its feet, lifted, above the floor's origin: what it was made in.
};

/// A part where it is at one moment.
struct Capsule {
  Vec3 from = Vec3::Zero();  ///< World, metres.
  Vec3 to = Vec3::Zero();
  double fromRadius = 0.0;  ///< Metres.
  double toRadius = 0.0;
};

/// Clothes a skeleton that moves as in `frames`: which chain is a leg, an arm or the head is seen from the
/// motion (bodyAnatomy), radii are shares of the height, and soles are as thick as the feet's joints lie over
/// the floor y = 0 when they are down. Where they lie lower or higher than soles can make up for, the motion
/// has another floor, and the body is lifted from that to y = 0. Where a skeleton ends at the neck, the head
/// is set above the shoulders. The same frames give the same body.
RoundBody roundBody(const Skeleton& skeleton, const Clip& frames);

/// The parts at a pose of the motion, lifted.
std::vector<Capsule> placeParts(const RoundBody& body, const Skeleton& skeleton, const PoseView& pose);

}  // namespace stridegraph
