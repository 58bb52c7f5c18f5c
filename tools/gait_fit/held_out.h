#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gait_fit/fit.h"

namespace stridegraph::gait_fit {

/// How far a model's poses are from captured ones; angles as root of the mean square, degrees.
struct PoseErrors {
  std::array<double, kStoredJointCount> joints{};  ///< Both sides together.
  double allJoints = 0.0;                          ///< Of the pelvis and the 14 joints that move.
  double withoutPelvis = 0.0;
  Vec3 rootCentimetres = Vec3::Zero();  ///< Lateral, height, forward.
};

/// One clip against a model that has not seen it.
struct ClipErrors {
  std::string name;
  double speed = 0.0;  ///< Mean, m/s
  double degrees = 0.0;
  /// Straight, steady clips: mean distance of the body's 24 points from those of the straight walk of the
  /// same mean speed, root on root, heading on heading.
  std::optional<double> straightCentimetres;
};

/// Lean of the trunk over the foot in the middle of its stance, degrees for each m/s^2 of sideways
/// acceleration.
struct Lean {
  double captured = 0.0;
  double heldOut = 0.0;  ///< Of models that have not seen the clip.
  double trained = 0.0;  ///< Of the model of all clips.
};

struct HeldOutFigures {
  PoseErrors trained;  ///< Of the model of all clips.
  PoseErrors heldOut;
  std::vector<ClipErrors> clips;
  double straightMeanCentimetres = 0.0;  ///< Over the straight clips; 0 without one.
  double straightWorstCentimetres = 0.0;
  Lean lean;
};

/// Leaves one clip out at a time, solves the series from the others and fits only the phase of the one left
/// out. Poses are those that core makes of the rounded table. At least two clips.
Result<HeldOutFigures> measureHeldOut(const GaitFit& fit);

/// Both gaits as a table in Markdown and as JSON.
struct NamedFigures {
  std::string gait;
  HeldOutFigures figures;
};
std::string toMarkdown(const std::vector<NamedFigures>& gaits);
std::string toJson(const std::vector<NamedFigures>& gaits);

}  // namespace stridegraph::gait_fit
