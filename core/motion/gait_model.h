#pragma once

#include <array>

#include "math/angle.h"
#include "motion/clip.h"
#include "motion/gait_skeleton.h"
#include "motion/gait_table.h"

namespace stridegraph {

/// A moment of going: Fourier series over the gait cycle after Unuma, Anjyo and Takeuchi (1995) and Troje
/// (2002), steered by speed and turn rate.
struct GaitState {
  double phase = 0.0;     ///< rad; 0 when the left foot is foremost, grows by 2 pi with every two steps
  double speed = 0.0;     ///< m/s along the path; measured at 0.5..2.3 (walk) and 1.6..3.3 (jog)
  double turnRate = 0.0;  ///< rad/s, positive to the left (headings grow from +z towards +x)
  double turnAcceleration = 0.0;  ///< rad/s^2
  double acceleration = 0.0;      ///< m/s^2 along the path
};

/// The same moment of the mirrored walk: half a cycle later, turning the other way.
GaitState mirrored(const GaitState& state);

/// The factors that a GaitCurve's series are multiplied with, in their order.
std::array<double, kGaitRegressorCount> gaitRegressors(double referenceSpeed, const GaitState& state);

/// 1, cos phase, sin phase .. cos 5 phase, sin 5 phase: what a series' terms are multiplied with.
std::array<double, kGaitTermCount> gaitHarmonics(double phase);

/// The phases between which a foot is down, rad; off - on in 0..2 pi.
struct ContactPhases {
  double on = 0.0;
  double off = 0.0;
  double middle() const { return 0.5 * (on + off); }
  double halfWidth() const { return 0.5 * (off - on); }
};

/// The body at one moment, seen from the frame that moves with the smooth path and faces its heading (+z):
/// the root's place is (lateral, height, forward) in that frame. Mirrored exactly when phase moves by pi and
/// the turn rate changes sign.
Pose gaitPose(Gait gait, const GaitState& state);

/// The same from any table.
Pose gaitPose(const GaitTable& table, const GaitState& state);

/// The left or central joint that each stored rotation belongs to.
GaitJoint gaitJointOf(StoredJoint joint);

/// The mean pose of standing still, mirror-symmetrical, in the same frame.
Pose standingPose();

/// How fast the phase grows, rad/s.
double gaitCadence(Gait gait, double speed, double turnRate);

/// The direction of the path less the heading: a body looks into a turn a little before it goes there.
/// `turnAcceleration` in rad/s^2.
Angle gaitSlip(Gait gait, double turnRate, double turnAcceleration);

/// When the left foot is down; the right foot is half a cycle later.
ContactPhases gaitContact(Gait gait, double speed);

/// Where the heel touches the floor, in the foot joint's own axes, metres. Heel and toe end are level in the
/// flat foot.
Vec3 gaitHeel(Gait gait);

/// The pose reflected in the plane x = 0: left and right joints change places.
Pose mirrored(const Pose& pose);

}  // namespace stridegraph
