#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "walk/synthesis.h"
#include "walk/walk_feet.h"

namespace stridegraph {

/// What the clean-up did.
struct FootCleanupReport {
  std::size_t stances = 0;            ///< Of all feet, each pinned to one place.
  double meanCorrectionMetres = 0.0;  ///< How far planted ankles were moved, over the frames of all stances.
  double worstCorrectionMetres = 0.0;
  double worstLoweringMetres = 0.0;        ///< How far the root was lowered for a leg that would not reach.
  std::vector<std::string> feetLeftAlone;  ///< Contact joints above which no leg can be made out.
};

/// Takes out what blends and warped floors leave to be seen of a walk's feet (Kovar, Schreiner and Gleicher
/// 2002). Planted feet are pinned to one place for each stance; corrections fade in and out before and after;
/// legs are solved in closed form; the root goes up and down with what the standing feet need, slowly, and is
/// lowered where a leg would get straighter than it should. Feet that sink below the floor are lifted. Where
/// the walk is bent the body leans into the curve over its feet (Lean).
/// Nothing else changes: frames that need no correction stay as they are bit for bit, and so do all joints
/// outside the legs and the root's place over the floor; the root's rotation where nothing is bent. Made once
/// for a library; immutable.
class FootCleanup {
 public:
  explicit FootCleanup(const MotionLibrary& library);

  /// The walk is one of this library: its skeleton, and contacts for every frame.
  FootCleanupReport apply(const MotionLibrary& library, SynthesisedWalk& walk) const;

  /// For each contact joint how high it is while it stands, the median over the library; NaN where it never
  /// does. Metres, world.
  const std::vector<double>& levelsMetres() const { return levelsMetres_; }

  /// The feet that were made out.
  const WalkFeet& feet() const { return feet_; }

 private:
  WalkFeet feet_;
  std::vector<double> levelsMetres_;
};

}  // namespace stridegraph
