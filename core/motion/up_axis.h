#pragma once

#include <array>

#include "base/error.h"
#include "motion/body_evidence.h"
#include "motion/bvh_layout.h"

namespace stridegraph {

/// How likely each direction is up (they add to 1), from all that a clip tells: a body mostly stands, posed
/// and at rest, so that it reaches far along up and has its head above its feet; it hardly travels along up;
/// its lowest joint keeps to one level and, while the body goes, mostly stands. A naive Bayes; the shapes are
/// mixtures with bodies that lie or crawl, so that shape alone never outweighs how the body moves. Directions
/// other than +y and +z are rare. The weights were set on captured walks and jogs, turned and cut.
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
