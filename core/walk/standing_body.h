#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "graph/library.h"
#include "walk/step_plan.h"
#include "walk/walk_cycle.h"
#include "walk/walk_feet.h"

namespace stridegraph {

/// A foot of a body that stands, relative to the body's placement on the floor (heights as in the library).
struct StandingFoot {
  WalkFoot foot;
  JointPlacement ankle;
  Vec3 ball = Vec3::Zero();        ///< What the foot rolls over when its heel rises.
  std::optional<JointIndex> toes;  ///< Turn there, where the skeleton has such a joint.
  Quat toesRotation = Quat::Identity();
  double reachMetres = 0.0;  ///< Longest that its leg may be.
  ContactMask contacts = 0;  ///< Bits of the foot.
};

/// How the body of a library stands: the captured frames that small steps are taken from. Made once for a
/// library; immutable.
struct StandingBody {
  FrameIndex frame{std::size_t{0}};  ///< Its feet stand so.
  std::uint32_t firstFrame = 0;      ///< The body stands from here
  std::uint32_t lastFrame = 0;       ///< to here, `frame` among them.
  std::array<StandingFoot, 2> feet;
  FeetApart apart;
  StepParams steps;                ///< For legs of this length.
  std::vector<JointIndex> upper;   ///< Joints of the upper body,
  std::optional<WalkCycle> cycle;  ///< and what they do in a walk, where a clip shows one.
};

/// The steadiest stand of a library: of the frames where it stands with both feet down, the one whose feet
/// are most nearly side by side, below the middle of the body. Nothing where no clip stands, or where the
/// body does not have two legs, one on each side.
std::optional<StandingBody> standingBody(const MotionLibrary& library, const WalkFeet& feet);

}  // namespace stridegraph
