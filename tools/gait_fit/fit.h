#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/result.h"
#include "gait_fit/series.h"

namespace stridegraph::gait_fit {

/// How one gait is fitted. The defaults were chosen by leaving clips out of 26 walks and 8 jogs of one actor.
struct FitParams {
  Gait gait = Gait::kWalk;
  double minimumSpeed = 0.5;  ///< m/s; slower frames have no phase.
  SplitParams split;
  SeriesParams series;
  PhaseParams phase;
  int rounds = 6;  ///< Of fitting series and phases in turn, >= 1.
};
FitParams fitParamsFor(Gait gait);

/// Clips and the series that describe them.
struct GaitFit {
  FitParams params;
  std::vector<Track> tracks;
  std::vector<Channels> channels;
  Series series;
};

/// Fits one gait to clips of the gait body at 30 frames a second. Fails with kInvalidArgument when there is
/// no clip or another body, with kClipTooShort when a clip is shorter than kShortestClip frames, nobody goes
/// fast enough, or all clips together show fewer than kFewestStrides strides.
Result<GaitFit> fitGait(std::vector<Clip> clips, const FitParams& params);
inline constexpr double kFewestStrides = 3.0;

/// Strides (two steps) in the going frames of a track.
double stridesOf(const Track& track);

/// Solves the series from all tracks but `leftOut`; pass tracks.size() to leave none out.
Series solveWithout(const GaitFit& fit, std::span<const NormalEquations> equations, std::size_t leftOut);

}  // namespace stridegraph::gait_fit
