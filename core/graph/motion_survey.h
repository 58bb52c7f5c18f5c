#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "graph/library.h"
#include "graph/survival.h"

namespace stridegraph {

/// What stretches of clips show, in figures.
struct MotionSurvey {
  std::size_t frames = 0;
  double longestSeconds = 0.0;  ///< Of the stretches.
  double pathMetres = 0.0;      ///< Way of the root over the floor, all stretches together.
  /// Speeds of the root over the floor, means over kSpeedSeconds or, of shorter stretches, over all.
  double slowestMetresPerSecond = 0.0;
  double fastestMetresPerSecond = 0.0;
  /// No joint but the root turns by more than a degree away from how it is in the first frame.
  bool isOnePose = true;
};
inline constexpr double kSpeedSeconds = 0.5;

/// Surveys the frames of a library that `runs` tell, a list for each clip.
MotionSurvey surveyOf(const MotionLibrary& library, std::span<const std::vector<PlayedRun>> runs);

/// Every clip of a library from end to end.
std::vector<std::vector<PlayedRun>> wholeClips(const MotionLibrary& library);

}  // namespace stridegraph
