#include "math/floor_transform.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace stridegraph {
namespace {

/// Sine by its Taylor series to x^15, below 1e-15 for |x| <= pi / 4.
double sineSeries(double x) {
  const double xx = x * x;
  double sum = 0.0;
  for (int k = 15; k >= 3; k -= 2) sum = (1.0 + sum) * (-xx / static_cast<double>(k * (k - 1)));
  return x * (1.0 + sum);
}

/// Cosine by its Taylor series to x^16.
double cosineSeries(double x) {
  const double xx = x * x;
  double sum = 0.0;
  for (int k = 16; k >= 2; k -= 2) sum = (1.0 + sum) * (-xx / static_cast<double>(k * (k - 1)));
  return 1.0 + sum;
}

Heading normalised(double sin, double cos) {
  const double length = std::sqrt(sin * sin + cos * cos);
  if (length == 0.0) return {};
  return {sin / length, cos / length};
}

}  // namespace

Heading Heading::fromAngle(Angle angle) {
  constexpr double kQuarter = std::numbers::pi / 2.0;
  const double wrapped = angle.wrapped().radians();
  const double quarters = std::nearbyint(wrapped / kQuarter);
  const double rest = wrapped - quarters * kQuarter;
  const double s = sineSeries(rest);
  const double c = cosineSeries(rest);
  switch ((static_cast<int>(quarters) + 4) % 4) {
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    case 3:
      return {-c, s};
    default:
      return {s, c};
  }
}

Heading Heading::alongDirection(const Vec2& direction) {
  return normalised(direction.x(), direction.y());
}

Angle Heading::angle() const {
  return Angle::radians(std::atan2(sin, cos));
}

Heading Heading::operator+(const Heading& turn) const {
  return normalised(sin * turn.cos + cos * turn.sin, cos * turn.cos - sin * turn.sin);
}

Heading Heading::operator-(const Heading& other) const {
  return normalised(sin * other.cos - cos * other.sin, cos * other.cos + sin * other.sin);
}

Quat Heading::rotation() const {
  // Half-angle formulas; the larger of the two is taken from the root, so that nothing cancels.
  if (cos >= 0.0) {
    const double w = std::sqrt((1.0 + cos) / 2.0);
    return {w, 0.0, sin / (2.0 * w), 0.0};
  }
  const double y = std::copysign(std::sqrt((1.0 - cos) / 2.0), sin);
  return {sin / (2.0 * y), 0.0, y, 0.0};
}

Heading blend(const Heading& from, const Heading& to, double fraction) {
  return normalised(from.sin + (to.sin - from.sin) * fraction, from.cos + (to.cos - from.cos) * fraction);
}

FloorTransform FloorTransform::operator*(const FloorTransform& inner) const {
  return {*this * inner.translation, heading + inner.heading};
}

FloorTransform FloorTransform::inverse() const {
  const Heading back{-heading.sin, heading.cos};
  return {back.rotate(-translation), back};
}

Vec3 FloorTransform::apply(const Vec3& point) const {
  const Vec2 floor = *this * onFloor(point);
  return {floor.x(), point.y(), floor.y()};
}

double quarterTurns(const Heading& heading) {
  const double p = heading.sin / (std::abs(heading.sin) + std::abs(heading.cos));
  if (heading.cos < 0.0) return 2.0 - p;
  return p < 0.0 ? 4.0 + p : p;
}

double turnFraction(const Heading& heading) {
  const double quarters = quarterTurns(heading);
  const double whole = std::min(std::floor(quarters), 3.0);
  // Within a quarter, tan(angle - 45 degrees) is linear in quarterTurns.
  const double x = 2.0 * (quarters - whole) - 1.0;
  const double xx = x * x;
  // Arc tangent for |x| <= 1, minimax (Abramowitz and Stegun 1964, 4.4.47 is its like), error below 2e-5 rad.
  const double arc =
      x * (0.9998660 + xx * (-0.3302995 + xx * (0.1801410 + xx * (-0.0851330 + xx * 0.0208351))));
  return 0.25 * (whole + 0.5 + arc * (2.0 / std::numbers::pi));
}

}  // namespace stridegraph
