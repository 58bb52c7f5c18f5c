#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "math/angle.h"
#include "math/types.h"

namespace stridegraph {

/// A heading as a unit vector (sin, cos) of the angle from +z towards +x: the direction faced on the floor.
/// Composing headings this way needs no trigonometry, so that long sums stay the same, bit for bit, on every
/// machine.
struct Heading {
  double sin = 0.0;
  double cos = 1.0;

  /// Computed by a fixed series, not by the platform's libm, so that it is the same everywhere.
  static Heading fromAngle(Angle angle);
  /// That of a vector (sin, cos) of any length; {0, 1} for a zero vector.
  static Heading normalised(double sin, double cos) {
    const double length = std::sqrt(sin * sin + cos * cos);
    if (length == 0.0) return {};
    return {sin / length, cos / length};
  }
  /// The heading of a floor direction; {0, 1} for a zero vector.
  static Heading alongDirection(const Vec2& direction);

  Angle angle() const;
  /// The unit floor vector (x, z) that this heading faces.
  Vec2 direction() const { return {sin, cos}; }
  /// This heading turned further by `turn`.
  Heading operator+(const Heading& turn) const {
    return normalised(sin * turn.cos + cos * turn.sin, cos * turn.cos - sin * turn.sin);
  }
  /// The turn that leads from `other` to this heading.
  Heading operator-(const Heading& other) const {
    return normalised(sin * other.cos - cos * other.sin, cos * other.cos + sin * other.sin);
  }
  /// A floor vector turned by this heading about +y.
  Vec2 rotate(const Vec2& v) const { return {v.x() * cos + v.y() * sin, v.y() * cos - v.x() * sin}; }
  /// The same rotation in space: R_y of eq. 3.5.
  Quat rotation() const;
};

/// Rises from 0 to 4 as a heading turns once around from +z, without trigonometry: not evenly, but by 1 in
/// each quarter. Of (sin, cos) only the ratio counts.
inline double quarterTurns(const Heading& heading) {
  const double p = heading.sin / (std::abs(heading.sin) + std::abs(heading.cos));
  if (heading.cos < 0.0) return 2.0 - p;
  return p < 0.0 ? 4.0 + p : p;
}

/// How far a heading is turned from +z, 0 to 1 for once around, within 2e-5 of a turn; computed without libm,
/// so that it is the same everywhere. Of (sin, cos) only the ratio counts.
inline double turnFraction(const Heading& heading) {
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

/// The heading `fraction` of the way from one to the other along the shorter arc, by normalised linear
/// interpolation: within 2e-4 rad of the arc's own division for turns below 0.2 rad.
Heading blend(const Heading& from, const Heading& to, double fraction);

/// A rigid motion of the floor, T_xz(translation) R_y(heading) of eq. 3.2: turn first, then move.
struct FloorTransform {
  Vec2 translation = Vec2::Zero();
  Heading heading = {};

  Vec2 operator*(const Vec2& point) const { return translation + heading.rotate(point); }
  /// First `inner`, then this.
  FloorTransform operator*(const FloorTransform& inner) const {
    return {*this * inner.translation, heading + inner.heading};
  }
  FloorTransform inverse() const {
    const Heading back{-heading.sin, heading.cos};
    return {back.rotate(-translation), back};
  }
  /// Moves a point in space; its height stays.
  Vec3 apply(const Vec3& point) const;
};

}  // namespace stridegraph
