#include "graph/motion_survey.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "math/rotation.h"

namespace stridegraph {
namespace {

double stepMetres(const Clip& frames, std::size_t frame) {
  return (onFloor(frames.rootPositions[frame + 1]) - onFloor(frames.rootPositions[frame])).norm();
}

/// Adds the speeds of frames first..last.
void addSpeeds(const Clip& frames, std::size_t first, std::size_t last, MotionSurvey& survey) {
  const double rate = frames.framesPerSecond;
  const auto window = std::min(
      last - first, std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(kSpeedSeconds * rate))));
  if (window == 0) return;
  double metres = 0.0;
  for (std::size_t f = first; f < last; ++f) {
    const double step = stepMetres(frames, f);
    survey.pathMetres += step;
    metres += step;
    if (f - first >= window) metres -= stepMetres(frames, f - window);
    if (f + 1 - first < window) continue;
    const double speed = metres * rate / static_cast<double>(window);
    survey.slowestMetresPerSecond = std::min(survey.slowestMetresPerSecond, speed);
    survey.fastestMetresPerSecond = std::max(survey.fastestMetresPerSecond, speed);
  }
}

bool isSamePose(const PoseView& a, const PoseView& b) {
  constexpr Angle kSame = Angle::degrees(1);
  for (std::size_t j = 1; j < a.rotations.size(); ++j) {
    if (angleBetween(a.rotations[j], b.rotations[j]) > kSame) return false;
  }
  return true;
}

}  // namespace

MotionSurvey surveyOf(const MotionLibrary& library, std::span<const std::vector<PlayedRun>> runs) {
  const Clip& frames = library.frames;
  MotionSurvey survey;
  survey.slowestMetresPerSecond = std::numeric_limits<double>::infinity();
  std::optional<std::size_t> reference;
  for (std::size_t c = 0; c < runs.size(); ++c) {
    for (const PlayedRun& run : runs[c]) {
      const std::size_t first = library.clips[c].firstFrame + run.first;
      const std::size_t last = library.clips[c].firstFrame + run.last;
      if (!reference) reference = first;
      survey.frames += last - first + 1;
      survey.longestSeconds =
          std::max(survey.longestSeconds, static_cast<double>(last - first + 1) / frames.framesPerSecond);
      addSpeeds(frames, first, last, survey);
      for (std::size_t f = first; f <= last && survey.isOnePose; ++f)
        survey.isOnePose = isSamePose(frames.pose(*reference), frames.pose(f));
    }
  }
  if (survey.slowestMetresPerSecond > survey.fastestMetresPerSecond) survey.slowestMetresPerSecond = 0.0;
  return survey;
}

std::vector<std::vector<PlayedRun>> wholeClips(const MotionLibrary& library) {
  std::vector<std::vector<PlayedRun>> runs;
  for (const LibraryClip& clip : library.clips) {
    runs.emplace_back();
    if (clip.frameCount > 0) runs.back().push_back({0, clip.frameCount - 1});
  }
  return runs;
}

}  // namespace stridegraph
