#pragma once

#include <cmath>
#include <compare>
#include <numbers>

namespace stridegraph {

/// An angle. Radians inside; degrees only at the edges. Headings: 0 faces +z and grows towards +x.
class Angle {
 public:
  constexpr Angle() = default;
  static constexpr Angle radians(double value) { return Angle(value); }
  static constexpr Angle degrees(double value) { return Angle(value * std::numbers::pi / 180.0); }

  constexpr double radians() const { return radians_; }
  constexpr double degrees() const { return radians_ * 180.0 / std::numbers::pi; }

  constexpr Angle operator-() const { return Angle(-radians_); }
  constexpr Angle operator+(Angle other) const { return Angle(radians_ + other.radians_); }
  constexpr Angle operator-(Angle other) const { return Angle(radians_ - other.radians_); }
  constexpr Angle operator*(double factor) const { return Angle(radians_ * factor); }
  constexpr auto operator<=>(const Angle&) const = default;

  /// The same direction in -pi..pi.
  Angle wrapped() const {
    // Most angles are there already, and a remainder costs more than all else that is done with them.
    if (std::abs(radians_) <= std::numbers::pi) return *this;
    return Angle(std::remainder(radians_, 2.0 * std::numbers::pi));
  }

 private:
  constexpr explicit Angle(double value) : radians_(value) {}
  double radians_ = 0.0;
};

}  // namespace stridegraph
