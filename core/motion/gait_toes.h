#pragma once

#include "motion/gait_footprint.h"

namespace stridegraph {

/// How far the toes bend up against the foot, rad, when it is pitched down by `pitch` more than flat: as much
/// as the foot, so that the ball and the toes stay flat while the heel rises, up to what the joint does with
/// ease (Bojsen-Moller and Lamoreux 1979: 50 to 60 degrees barefoot; less in a shoe). 0 for a foot that is
/// flat or rests on its heel; smooth.
double toeBend(double pitch);

/// Pitch of a foot, toes down, beyond the flat foot, rad, -pi..pi.
double pitchBeyondFlat(const FootMotion& foot);

/// What a stance makes of the model's foot, which is a mean over many strides: it comes down flat within
/// `slapSeconds` of the heel strike, and lies flat until the heel leaves the floor. `seconds` since the
/// strike.
void settleSole(double seconds, double slapSeconds, FootMotion& foot);

}  // namespace stridegraph
