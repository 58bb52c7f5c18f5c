#include "math/rotation.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"

namespace stridegraph {
namespace {

int indexOf(Axis axis) {
  return static_cast<int>(axis);
}

}  // namespace

Quat axisRotation(Axis axis, Angle angle) {
  Vec3 direction = Vec3::Zero();
  direction[indexOf(axis)] = 1.0;
  return Quat(Eigen::AngleAxisd(angle.radians(), direction));
}

Quat fromEuler(const EulerOrder& order, const std::array<Angle, 3>& angles) {
  return axisRotation(order[0], angles[0]) * axisRotation(order[1], angles[1]) *
         axisRotation(order[2], angles[2]);
}

std::array<Angle, 3> toEuler(const EulerOrder& order, const Quat& rotation) {
  const int i = indexOf(order[0]);
  const int j = indexOf(order[1]);
  const int k = indexOf(order[2]);
  STRIDEGRAPH_CHECK(i != j && j != k && i != k);
  // For an even permutation (xyz, yzx, zxy) of R_i R_j R_k: m(i,k) = sin(b), and the outer angles follow from
  // the rows and columns through it; an odd permutation changes the sign of every angle.
  const double sign = (j - i + 3) % 3 == 1 ? 1.0 : -1.0;
  const Mat3 m = rotation.normalized().toRotationMatrix();
  const double middle = std::asin(std::clamp(sign * m(i, k), -1.0, 1.0));
  double first = 0.0;
  double last = 0.0;
  if (std::hypot(m(i, i), m(i, j)) > 1e-9) {
    first = std::atan2(-sign * m(j, k), m(k, k));
    last = std::atan2(-sign * m(i, j), m(i, i));
  } else {
    first = std::atan2(sign * m(k, j), m(j, j));
  }
  return {Angle::radians(first), Angle::radians(middle), Angle::radians(last)};
}

Quat slerp(const Quat& from, const Quat& to, double fraction) {
  return from.slerp(fraction, to).normalized();
}

Quat fromRotationVector(const Vec3& vector) {
  const double angle = vector.norm();
  return angle > 1e-12 ? Quat(Eigen::AngleAxisd(angle, vector / angle)) : Quat::Identity();
}

Vec3 toRotationVector(const Quat& rotation) {
  const double sine = rotation.vec().norm();
  if (sine < 1e-12) return Vec3::Zero();
  const double sign = rotation.w() < 0.0 ? -1.0 : 1.0;
  return rotation.vec() * (sign * 2.0 * std::atan2(sine, sign * rotation.w()) / sine);
}

Angle angleBetween(const Quat& a, const Quat& b) {
  return Angle::radians(a.angularDistance(b));
}

HeadingAndTilt separateHeading(const Quat& rotation) {
  const Quat unit = rotation.normalized();
  // The rotated z axis, seen from above: entries (0, 2) and (2, 2) of the rotation matrix.
  const double x = 2.0 * (unit.x() * unit.z() + unit.w() * unit.y());
  const double z = 1.0 - 2.0 * (unit.x() * unit.x() + unit.y() * unit.y());
  const Heading heading = Heading::alongDirection({x, z});
  return {heading, heading.rotation().conjugate() * unit};
}

}  // namespace stridegraph
