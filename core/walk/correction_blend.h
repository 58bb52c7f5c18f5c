#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "walk/footprints.h"

namespace stridegraph {

/// Corrections for every frame of a clip from those of its pinned stances: between two stances a cubic
/// Hermite curve leads from the one to the other with the slopes that they end and begin with; where they are
/// farther apart than twice `blendFrames` (>= 1), the correction fades out and in over that many frames and
/// is exactly zero between. Before the first and after the last stance it fades likewise.
std::vector<FootCorrection> carryCorrections(std::span<const PinnedStance> stances, std::size_t frameCount,
                                             std::size_t blendFrames);

/// A curve without corners that is nowhere below `values` (all >= 0) and zero where they are zero for more
/// than 2 `reach` frames around: each value becomes the largest within `reach` frames, then a bell-shaped
/// mean.
std::vector<double> smoothEnvelope(std::span<const double> values, std::size_t reach);

/// Bell-shaped means of the values over those frames that have weight, within `reach` frames on either side.
/// Zero where no frame near has any, and growing from there without a corner.
std::vector<double> smoothMean(std::span<const double> values, std::span<const double> weights,
                               std::size_t reach);

}  // namespace stridegraph
