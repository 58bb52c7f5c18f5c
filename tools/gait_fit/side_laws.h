#pragma once

#include "gait_fit/fit.h"

namespace stridegraph::gait_fit {

/// What a gait is besides poses.
struct SideLaws {
  std::array<double, 4> cadence{};  ///< rad/s of phase: a + b u + c u^2 + d w^2
  std::array<double, 2> slip{};     ///< Path direction less heading, rad: a w + b w'
  std::array<ContactKnot, 3> contacts{};
  Angle flatFootPitch;  ///< Toes down, of the foot that rests flat in the middle of its stance.
};

/// Measures them on the going frames of a fit, ends of clips left out, where splines invent turn rates.
/// Fails with kClipTooShort when no whole stance is seen.
Result<SideLaws> measureSideLaws(const GaitFit& fit);

/// Where the heel touches the floor in the foot's axes: level with the toe end when the foot is pitched by
/// `flatFootPitch`, a little behind the ankle. Metres.
std::array<double, 3> heelInFoot(Angle flatFootPitch);

}  // namespace stridegraph::gait_fit
