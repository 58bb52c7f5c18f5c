#include "gait_fit/fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>

namespace stridegraph::gait_fit {
namespace {

using Eigen::Index;

constexpr double kFramesPerSecond = 30.0;

std::optional<Error> faultOf(const std::vector<Clip>& clips) {
  if (clips.empty())
    return Error{ErrorCode::kInvalidArgument, "found no clips to fit a gait to, expected at least one"};
  for (const Clip& clip : clips) {
    if (clip.jointCount != kGaitJointCount || std::abs(clip.framesPerSecond - kFramesPerSecond) > 1e-3)
      return Error{
          ErrorCode::kInvalidArgument,
          fmt::format(
              "found a clip of {} joints at {:g} frames a second, expected the gait body's {} at {:g}",
              clip.jointCount, clip.framesPerSecond, kGaitJointCount, kFramesPerSecond),
          {clip.name}};
    if (clip.frameCount() < kShortestClip)
      return Error{ErrorCode::kClipTooShort,
                   fmt::format("found {} frames, expected at least {} to see a stride in", clip.frameCount(),
                               kShortestClip),
                   {clip.name}};
  }
  return std::nullopt;
}

std::optional<Error> faultOf(const std::vector<Track>& tracks, double minimumSpeed) {
  double strides = 0.0;
  double fastest = 0.0;
  for (const Track& track : tracks) {
    strides += stridesOf(track);
    fastest = std::max(fastest, track.speed.maxCoeff());
  }
  if (fastest <= minimumSpeed)
    return Error{ErrorCode::kClipTooShort,
                 fmt::format("found nobody who goes faster than {:.2f} m/s, expected more than {:g}", fastest,
                             minimumSpeed)};
  if (strides < kFewestStrides)
    return Error{
        ErrorCode::kClipTooShort,
        fmt::format("found {:.1f} strides in all clips, expected at least {:g}", strides, kFewestStrides)};
  return std::nullopt;
}

/// Splits and estimates in turn: a phase needs the heading, a good split the phase.
Track firstTrack(Clip clip, const FitParams& params) {
  Track track;
  track.clip = std::move(clip);
  splitRoot(params.split, track);
  estimatePhase(params.minimumSpeed, track);
  for (int round = 0; round < 2; ++round) {
    splitRoot(params.split, track);
    estimatePhase(params.minimumSpeed, track);
  }
  splitRoot(params.split, track);
  return track;
}

/// Moves all phases so that on the mean the left foot is foremost at phase 0.
void centrePhases(std::vector<Track>& tracks) {
  std::complex<double> sum = 0.0;
  for (const Track& track : tracks) {
    const Eigen::VectorXd ahead = ankleSeparation(track);
    for (Index f = 0; f < track.frames(); ++f)
      sum += track.going[f] * ahead[f] * std::polar(1.0, track.phase[f]);
  }
  for (Track& track : tracks) track.phase.array() -= std::arg(sum);
}

}  // namespace

FitParams fitParamsFor(Gait gait) {
  FitParams params;
  params.gait = gait;
  if (gait == Gait::kWalk) return params;
  params.minimumSpeed = 1.5;
  params.series.referenceSpeed = 2.8;
  return params;
}

double stridesOf(const Track& track) {
  double turns = 0.0;
  for (Index f = 1; f < track.frames(); ++f)
    turns += track.going[f] * track.going[f - 1] * (track.phase[f] - track.phase[f - 1]);
  return turns / (2.0 * std::numbers::pi);
}

Series solveWithout(const GaitFit& fit, std::span<const NormalEquations> equations, std::size_t leftOut) {
  NormalEquations sum;
  for (std::size_t t = 0; t < equations.size(); ++t)
    if (t != leftOut) sum += equations[t];
  Series series = fit.series;
  series.coefficients = solve(fit.params.series, sum);
  return series;
}

Result<GaitFit> fitGait(std::vector<Clip> clips, const FitParams& params) {
  if (auto fault = faultOf(clips)) return tl::unexpected<Error>(std::move(*fault));
  GaitFit fit;
  fit.params = params;
  for (Clip& clip : clips) fit.tracks.push_back(firstTrack(std::move(clip), params));
  if (auto fault = faultOf(fit.tracks, params.minimumSpeed)) return tl::unexpected<Error>(std::move(*fault));
  fit.series.referenceSpeed = params.series.referenceSpeed;
  fit.series.means = meanRotations(fit.tracks);
  for (const Track& track : fit.tracks) fit.channels.push_back(channelsOf(track, fit.series.means));
  for (int round = 0; round <= params.rounds; ++round) {
    if (round > 0)
      for (std::size_t t = 0; t < fit.tracks.size(); ++t)
        refinePhase(params.phase, fit.series, fit.channels[t], fit.tracks[t]);
    centrePhases(fit.tracks);
    NormalEquations sum;
    for (std::size_t t = 0; t < fit.tracks.size(); ++t)
      sum += equationsOf(params.series.referenceSpeed, fit.tracks[t], fit.channels[t]);
    fit.series.coefficients = solve(params.series, sum);
  }
  return fit;
}

}  // namespace stridegraph::gait_fit
