#pragma once

#include <array>

#include "math/floor_transform.h"
#include "math/types.h"

namespace stridegraph {

enum class Axis { kX, kY, kZ };

/// The order in which a file multiplies rotations about single axes: kZ, kX, kY means R_z R_x R_y.
using EulerOrder = std::array<Axis, 3>;

/// Rotation by `angle` about one axis.
Quat axisRotation(Axis axis, Angle angle);

/// R_order[0](angles[0]) R_order[1](angles[1]) R_order[2](angles[2]), for any order, repeated axes included.
Quat fromEuler(const EulerOrder& order, const std::array<Angle, 3>& angles);

/// Angles that give `rotation` in an order of three different axes. The middle one lies in -90..90 degrees;
/// at its ends, where the outer two turn about the same axis, the last is zero.
std::array<Angle, 3> toEuler(const EulerOrder& order, const Quat& rotation);

/// Spherical linear interpolation along the shorter arc, eq. 5.10; fraction in 0..1. Rotations less than some
/// 50 degrees apart are interpolated by a series (Eberly 2011), exact to rounding and the same everywhere.
Quat slerp(const Quat& from, const Quat& to, double fraction);

/// Axis times angle in radians (the exponential map of rotations), and back. The angle that comes back lies
/// in 0..pi.
Quat fromRotationVector(const Vec3& vector);
Vec3 toRotationVector(const Quat& rotation);

/// The angle of the rotation that leads from one to the other, 0..pi.
Angle angleBetween(const Quat& a, const Quat& b);

/// A root rotation taken apart: q = R_y(heading) tilt, where tilt = R_x R_z (zxy order, eq. 3.5 and 3.6).
struct HeadingAndTilt {
  Heading heading;
  Quat tilt;
};
HeadingAndTilt separateHeading(const Quat& rotation);
/// Only the heading of it.
Heading headingOf(const Quat& rotation);

}  // namespace stridegraph
