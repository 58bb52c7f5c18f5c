#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "math/floor_transform.h"
#include "scene/scene.h"

namespace stridegraph {

/// How a body sets its feet where it goes no farther than some steps. Lengths are shares of the leg's. The
/// limits are those of an unhurried adult, who steps a little more than half a leg's length ahead and less to
/// the side or backwards.
struct StepParams {
  double legMetres = 0.85;               ///< From hip to ankle, > 0.
  double ahead = 0.55;                   ///< Longest step to the front,
  double behind = 0.3;                   ///< to the back,
  double aside = 0.34;                   ///< and to the side of the foot that steps.
  double narrowing = 0.4;                ///< Of the feet's distance, how much a step may take away.
  Angle outward = Angle::degrees(50.0);  ///< Widest turn of the body in a step of the inner foot of the turn,
  Angle inward = Angle::degrees(32.0);   ///< and of the outer foot, whose toes come closer to the other foot.
  std::size_t mostSteps = 16;            ///< A plan with more of them is none.
};

/// A step: one foot goes from one place to another while the other one stands.
struct Footfall {
  std::size_t foot = 0;  ///< 0 or 1.
  FloorTransform from;   ///< Of the body, by which the foot stood.
  FloorTransform to;     ///< Of the body, by which the foot stands then.
};

/// Steps from standing to standing; without steps where the body is there already.
struct StepPlan {
  FloorTransform start;  ///< Of the body.
  FloorTransform goal;
  std::vector<Footfall> steps;

  /// What the steps are like for who takes them, as a number of plain steps: those to the side or backwards
  /// count for more.
  double effort = 0.0;
  double turnRadians = 0.0;  ///< All turns of the body together, to either side.
};

/// Where the feet of a standing body are, relative to its placement on the floor: which one is on the left
/// and how far apart they are.
struct FeetApart {
  std::array<double, 2> leftMetres = {0.1, -0.1};  ///< To the body's left; of the right foot negative.
  double metres() const;
};

/// Nearer than this, and turned by less, a body that stands is where it should be.
inline constexpr double kThereMetres = 0.01;
inline constexpr Angle kThereTurn = Angle::degrees(1.0);

/// The least effort in steps from one placement to another along a straight line. Where the start or the goal
/// asks for no heading the body faces as suits best. It may step ahead, to the side or back and turn while it
/// goes, or turn on the spot, go ahead, and turn on the spot again. Feet take turns; each stays on its own
/// side, and no step is longer or turns farther than the limits. Nothing where it takes more steps than the
/// limit.
std::optional<StepPlan> planSteps(const Placement& start, const Placement& goal, const FeetApart& feet,
                                  const StepParams& params);

}  // namespace stridegraph
