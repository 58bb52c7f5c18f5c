#include "math/rotation.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"

namespace stridegraph {
namespace {

int indexOf(Axis axis) {
  return static_cast<int>(axis);
}

/// Cosines less 1 of half the angle between two rotations down to which their slerp is a series.
constexpr double kFarthestInSeries = -0.1;

constexpr std::size_t kMostTerms = 12;

/// Of the n-th term of sineRatio() by the one before it: the factors of the squared fraction, and the rest.
struct SineSeries {
  std::array<double, kMostTerms + 1> bySquare{};
  std::array<double, kMostTerms + 1> constant{};
};

constexpr SineSeries makeSineSeries() {
  SineSeries series;
  for (std::size_t i = 1; i <= kMostTerms; ++i) {
    const auto n = static_cast<double>(i);
    series.bySquare[i] = 1.0 / (n * (2.0 * n + 1.0));
    series.constant[i] = n / (2.0 * n + 1.0);
  }
  return series;
}

constexpr SineSeries kSineSeries = makeSineSeries();

/// Terms of sineRatio() that leave less than rounding: each is smaller by half of `lessThanOne` or more.
std::size_t termsFor(double lessThanOne) {
  if (lessThanOne > -0.005) return 6;
  return lessThanOne > -0.03 ? 8 : kMostTerms;
}

/// sin(fraction a) / sin(a) for the angle a whose cosine is 1 + lessThanOne (Eberly 2011, A Fast and Accurate
/// Algorithm for Computing SLERP).
double sineRatio(double fraction, double lessThanOne, std::size_t terms) {
  const double squared = fraction * fraction;
  double sum = 1.0;
  for (std::size_t i = terms; i > 0; --i)
    sum = 1.0 + (kSineSeries.bySquare[i] * squared - kSineSeries.constant[i]) * lessThanOne * sum;
  return fraction * sum;
}

/// The rotated z axis, seen from above: entries (0, 2) and (2, 2) of the rotation matrix.
Heading headingOfUnit(const Quat& unit) {
  const double x = 2.0 * (unit.x() * unit.z() + unit.w() * unit.y());
  const double z = 1.0 - 2.0 * (unit.x() * unit.x() + unit.y() * unit.y());
  return Heading::alongDirection({x, z});
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
  const double cosine = from.dot(to);
  const double lessThanOne = std::abs(cosine) - 1.0;
  if (lessThanOne < kFarthestInSeries) return from.slerp(fraction, to).normalized();
  const std::size_t terms = termsFor(lessThanOne);
  const double atFrom = sineRatio(1.0 - fraction, lessThanOne, terms);
  const double atTo = std::copysign(sineRatio(fraction, lessThanOne, terms), cosine);
  return Quat(atFrom * from.coeffs() + atTo * to.coeffs()).normalized();
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
  const Heading heading = headingOfUnit(unit);
  return {heading, heading.rotation().conjugate() * unit};
}

Heading headingOf(const Quat& rotation) {
  return headingOfUnit(rotation.normalized());
}

}  // namespace stridegraph
