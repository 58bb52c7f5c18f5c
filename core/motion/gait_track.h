#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "motion/gait_model.h"

namespace stridegraph {

/// One stretch of a walk as it is asked for. Changes from one stretch to the next are smoothed.
struct GaitSegment {
  double seconds = 1.0;   ///< > 0, at most 60
  double speed = 1.3;     ///< m/s: 0..2.3 walking (below 0.75 the walk fades into standing), 1.6..3.4 jogging
  double turnRate = 0.0;  ///< rad/s, positive to the left; -2.5..2.5
  Gait gait = Gait::kWalk;
};

/// A walk as it is asked for.
struct GaitRequest {
  std::string name;
  std::vector<GaitSegment> segments;  ///< At least one.
  /// Phase of the first and of the last frame, rad. With neither the first is 0; with both the cadence is
  /// stretched or squeezed so that the last comes out right but for whole cycles.
  std::optional<double> startPhase = {};
  std::optional<double> endPhase = {};
  double framesPerSecond = 30.0;   ///< 10..240
  double speedBlendSeconds = 0.5;  ///< Half the time that a change of speed takes; 0..2
  double turnBlendSeconds = 0.3;   ///< The same for the turn rate; 0..2
  double gaitBlendSeconds = 0.6;   ///< The same for the change between walk and jog; 0..2
  /// How much one step differs from the next, and of the jolts and fine unrest of a living body: 1 about as
  /// much as people, 0 none; 0..2.
  double variation = 1.0;
  std::uint64_t seed = 1;  ///< Of the variation.
};

/// Where the smooth path is and how one goes there, at one frame.
struct GaitMoment {
  Vec2 place = Vec2::Zero();  ///< On the floor, metres.
  Angle heading;
  double speed = 0.0;             ///< m/s
  double turnRate = 0.0;          ///< rad/s
  double turnAcceleration = 0.0;  ///< rad/s^2
  double jogShare = 0.0;          ///< 0 walking .. 1 jogging
  double phase = 0.0;             ///< rad, not wrapped
  double steps = 0.0;             ///< Since the first moment, not whole.
};

/// Frames of a request with `margin` more before and after, in which the first and the last segment simply go
/// on, so that neither end of the clip is a border for whoever plants feet.
struct GaitTrack {
  std::vector<GaitMoment> moments;
  std::size_t margin = 0;
};

/// Shares between standing, stepping on the spot and walking at a moment; each 0..1.
double walkingShare(const GaitMoment& moment);   ///< 0 standing, 1 from 0.75 m/s on
double steppingShare(const GaitMoment& moment);  ///< 1 when turning on the spot, 0 when standing or walking

/// When the left foot is down at this speed and turn rate; the whole cycle when standing.
ContactPhases contactAt(const GaitMoment& moment);

/// Smooths the segments, gives more of a tight turn to the outer foot's stance (as people do), integrates
/// path and heading (the first frame of the clip is at the origin and faces +z) and advances the phase by the
/// cadence law. Fails with kInvalidArgument when a value is out of range.
Result<GaitTrack> layTrack(const GaitRequest& request);

}  // namespace stridegraph
