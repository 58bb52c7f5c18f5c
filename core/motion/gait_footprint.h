#pragma once

#include <vector>

#include "math/types.h"
#include "motion/gait_track.h"

namespace stridegraph {

/// A foot at one frame: a piece that touches the floor with its heel, and toes that bend against it.
struct FootMotion {
  Vec3 ankle = Vec3::Zero();         ///< World, metres.
  Quat rotation = Quat::Identity();  ///< World.
  Vec3 heelInFoot = Vec3::Zero();    ///< In the foot's own axes; level with the toe end in the flat foot.
  Vec3 ballInFoot = Vec3::Zero();    ///< Where the toes are hinged.
  Vec3 toeFromBall = Vec3::Zero();   ///< Toe end from there, toes not bent, in the foot's axes.
  double toeBend = 0.0;              ///< Of the toes against the foot, upwards, rad.

  Vec3 heel() const { return ankle + rotation * heelInFoot; }
  Vec3 ball() const { return ankle + rotation * ballInFoot; }
  Vec3 toe() const { return ankle + rotation * toeInFoot(); }
  Vec3 toeInFoot() const;
  /// Which way the foot points, from its sideways axis, so that it holds when the foot stands on its tip.
  Angle yaw() const;
  /// 1 when it rests on the heel, 0 when on the toe end, between over some millimetres.
  double heelShare() const;
};

/// Frames first..last in which a foot rests on one place.
struct Stance {
  std::size_t first = 0;
  std::size_t last = 0;
};

/// What planting adds to the model's foot.
struct FootCorrection {
  Vec3 place = Vec3::Zero();  ///< To the ankle's place, metres.
  double yaw = 0.0;           ///< About the vertical, rad.
  double pitch = 0.0;         ///< About the foot's sideways axis, toes down, rad.
  double toeBend = 0.0;       ///< Of the toes, upwards, rad.
};

/// Where a foot rests during a stance.
struct Footprint {
  Vec2 heel = Vec2::Zero();  ///< Floor point under the heel, metres.
  Angle yaw;
};

/// Runs of frames in which the foot of `side` is down.
std::vector<Stance> stancesOf(const GaitTrack& track, Side side);

/// One place for a stance: the mean of where the frames near 45 % of it put the foot, or, where the body
/// stands still, of those frames alone.
Footprint footprintOf(const std::vector<FootMotion>& foot, const GaitTrack& track, const Stance& stance);

/// What brings the foot onto its footprint, rolling over heel or toe end.
FootCorrection correctionTo(const Footprint& print, const FootMotion& foot);

/// Lifts the heel further, toe end where it is, until the ankle is within `reachMetres` of the hip or the
/// foot is lifted by 20 degrees more. Does nothing to a foot that rests on its heel.
void liftHeel(const FootMotion& foot, const Vec3& hip, double reachMetres, FootCorrection& correction);

/// The foot with the correction applied.
FootMotion corrected(const FootMotion& foot, const FootCorrection& correction);

/// Fills the frames between stances (where `fixed` is false) from those beside them.
void carryThroughSwing(const std::vector<bool>& fixed, std::vector<FootCorrection>& corrections);

}  // namespace stridegraph
