#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace stridegraph {

/// The two ways of going that the model knows. Both count the same phase: 0 when the left foot is foremost.
enum class Gait { kWalk, kJog };

/// Unit of the stored coefficients: 1e-4 rad for rotation vectors, 1e-4 m for offsets.
inline constexpr double kGaitTableUnit = 1e-4;

/// What a quantity of the gait depends on, linearly: 1, u, w, w^2, w', u', w w', u w, u^2, where u = speed -
/// referenceSpeed in m/s, w = turn rate in rad/s, and w', u' their changes in a second. Rates of change tell
/// entering a turn from leaving it and setting off from slowing down.
inline constexpr std::size_t kGaitRegressorCount = 9;

/// Harmonics of a Fourier series, and its terms c0, c1, s1 .. c5, s5. Feet need the fifth; more changes
/// nothing.
inline constexpr std::size_t kGaitHarmonics = 5;
inline constexpr std::size_t kGaitTermCount = 2 * kGaitHarmonics + 1;

/// A quantity over the gait cycle: for each regressor a Fourier series in the phase.
using GaitCurve = std::array<std::array<std::int16_t, kGaitTermCount>, kGaitRegressorCount>;

/// Rotations that the table stores: central joints and those of the left side, in this order. The right side
/// follows by mirroring.
enum class StoredJoint { kPelvis, kThorax, kHead, kFemur, kTibia, kFoot, kHumerus, kRadius, kHand };
inline constexpr std::size_t kStoredJointCount = 9;

/// When the left foot is down, at one speed.
struct ContactKnot {
  double speedMetresPerSecond;
  double onPhase;   ///< rad; may be negative
  double offPhase;  ///< rad, > onPhase
};

/// Everything measured about one gait. Angles in rad, lengths in metres.
struct GaitTable {
  double referenceSpeed;          ///< m/s
  std::array<double, 4> cadence;  ///< rad/s of phase: a + b u + c u^2 + d w^2
  std::array<double, 2> slip;     ///< direction of the path less heading: a w + b dw/dt
  std::array<ContactKnot, 3> contacts;
  std::array<double, 3> heelInFoot;  ///< Where the heel touches the floor, in the foot joint's axes.
  double reach;                      ///< Longest leg in stance, as a share of its full length.
  std::array<std::array<double, 4>, kStoredJointCount> means;      ///< Mean local rotations, w x y z.
  std::array<std::array<GaitCurve, 3>, kStoredJointCount> joints;  ///< Rotation vectors about the means.
  std::array<GaitCurve, 3> offsets;  ///< Root beside the smooth path: lateral (left +), height, forward.
};

/// The mean pose of standing still, facing along +z.
struct StandingTable {
  double heightMetres;                                             ///< Of the root.
  std::array<std::array<double, 4>, kStoredJointCount> rotations;  ///< Local, w x y z.
};

const GaitTable& gaitTable(Gait gait);
const StandingTable& standingTable();

}  // namespace stridegraph
