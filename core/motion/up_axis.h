#pragma once

#include <array>

#include "base/error.h"
#include "motion/body_evidence.h"
#include "motion/bvh_layout.h"

namespace stridegraph {

/// How likely each direction is up (they add to 1), from all that a clip tells: along up a body reaches far,
/// posed and at rest; its head lies above its feet; it hardly travels; its lowest joint keeps to one level
/// and, while the body goes, mostly stands. A naive Bayes of logistic pieces; y up is the likelier before
/// anything is seen, and directions other than +y and +z are rare.
std::array<double, kDirections> upLikelihoods(const BodyEvidence& evidence);

/// Which way a file is up.
struct UpGuess {
  UpAxis up = UpAxis::kY;
  double confidence = 0.0;  ///< 0..1: the likelihood of `up`.
};
/// The likelier of +y and +z. Warns when it is z, when the guess is doubtful, and when another direction is
/// likelier than both.
UpGuess inferUpAxis(const BodyEvidence& evidence, Warnings& warnings);

}  // namespace stridegraph
