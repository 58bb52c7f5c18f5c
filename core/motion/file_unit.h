#pragma once

#include "base/error.h"
#include "motion/body_evidence.h"
#include "motion/bvh_layout.h"

namespace stridegraph {

/// The unit of a file's lengths.
struct UnitGuess {
  double perMetre = 100.0;  ///< File units in a metre.
  double confidence = 0.0;  ///< 0..1: the likelihood of this unit.
};

/// The likeliest of metres, decimetres, feet, CMU units of 5.6444 cm (0.45 of them in an inch), inches,
/// centimetres and millimetres, from the body's height along `up`, posed or at rest. Bodies of 1.3 to 1.9 m
/// between their joints are usual, half as much where the names of joints tell of legs or of an upper body
/// alone, others from 0.5 to 3.5 m possible, and a unit that is none of these is never ruled out. Warns when
/// the unit is not centimetres, when the body is not 0.9 to 2.4 m tall even so, and when the guess is
/// doubtful.
UnitGuess inferUnit(const BodyEvidence& evidence, UpAxis up, Warnings& warnings);

}  // namespace stridegraph
