#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "walk/walk_feet.h"

namespace stridegraph {

/// What brings a foot to where it should be: x, y, z of the ankle in metres, and the foot's turns about the
/// ankle in radians, one about the vertical and, before it, one about the foot's own sideways axis.
using FootCorrection = Eigen::Matrix<double, 5, 1>;

/// A turn about the vertical, as Heading.
Quat yawTurn(double radians);

/// Frames first..last during which some joint of the foot stands.
struct FootStance {
  std::size_t first = 0;
  std::size_t last = 0;
};

/// A stance with what holds the foot in place through it.
struct PinnedStance {
  FootStance stance;
  std::vector<FootCorrection> corrections;  ///< One for each frame of the stance.
};

/// Fastest change of a correction from frame to frame: a foot that the clip pulls along faster has let go.
inline constexpr double kLargestPlaceSlope = 0.008;  // metres
inline constexpr double kLargestTurnSlope = 0.08;    // rad

/// How far pins may pull.
struct PinParams {
  double farthestMetres = 0.08;           ///< Over the floor; a foot that wanders farther has moved.
  Angle widestTurn = Angle::degrees(25);  ///< About the vertical; bent ways turn bodies over their feet.
  double sameLevelMetres = 0.015;         ///< Stances so near their level stay at their own height.
  std::size_t leastFrames = 3;            ///< Shorter stances are touches, not stances.
};

/// Runs of frames in which some contact joint of the foot holds.
std::vector<FootStance> findStances(const FootTrack& track, const PinParams& params = {});

/// How high each contact joint of the foot is while it stands in a stance, metres; NaN where it never does.
std::vector<double> standingHeights(const FootTrack& track, const FootStance& stance);

/// Pins each stance to one footprint (Kovar, Schreiner and Gleicher 2002, section 3.1, for rigid feet): each
/// contact joint keeps one place on the floor while it holds, so that the foot rolls over heel, ball and tip
/// in turn as in the clip, and the foot keeps one yaw while two of its joints stand. Up and down the foot
/// moves as in the clip, lifted or lowered so that each joint stands at its level (`levelsMetres`, world;
/// NaN where that is not known).
/// Stances that wander farther than the limits are divided where the foot is fastest, and end where it is
/// pulled along.
std::vector<PinnedStance> pinStances(const FootTrack& track, std::span<const double> levelsMetres,
                                     const PinParams& params = {});

}  // namespace stridegraph
