#include "graph/build_advice.h"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "graph/motion_survey.h"
#include "graph/pose_distance.h"
#include "graph/turning_reach.h"

namespace stridegraph {
namespace {

/// A stride of walking, two steps, takes about so long (Inman 1981: 105 to 130 steps a minute).
constexpr double kStrideSeconds = 1.1;
/// Faster is not standing, and slower not walking, metres a second.
constexpr double kStandingSpeed = 0.15;
constexpr double kWalkingSpeed = 0.3;
/// Blends between poses farther apart show, metres.
constexpr double kVisibleThreshold = 0.1;
/// Walks that turn less go straight on.
constexpr Angle kStraightPerSecond = Angle::degrees(3);

std::string sentences(const std::vector<std::string>& all) {
  return fmt::format("{}", fmt::join(all, ". "));
}

/// "With a threshold of 0.082 m (--threshold 0.082) instead of 0.05 m", or with mirror images, or both.
std::string withWhat(const ThresholdFinding& finding, double presentMetres, bool mirrored) {
  const bool sameThreshold = finding.thresholdMetres == presentMetres;
  if (mirrored && sameThreshold) return "With mirror images of the clips (--mirror)";
  return fmt::format("With {}a threshold of {:.4g} m ({}--threshold {:.4g}) instead of {:.4g} m",
                     mirrored ? "mirror images of the clips and " : "", finding.thresholdMetres,
                     mirrored ? "--mirror " : "", finding.thresholdMetres, presentMetres);
}

/// What was tried and did it: "With ... PREDICATE, and N of M frames would take part".
std::vector<std::string> findingsText(const MotionLibrary& library, const TrialFindings& findings,
                                      std::string_view predicate, std::string_view nothing) {
  std::vector<std::string> texts;
  const auto add = [&](const ThresholdFinding& finding, std::size_t frames, bool mirrored) {
    texts.push_back(fmt::format(
        "{} {}: {} of {} frames would take part{}",
        withWhat(finding, library.params.thresholdMetres, mirrored), predicate, finding.playedFrames, frames,
        finding.thresholdMetres > kVisibleThreshold ? ", but blends between poses that far apart can be seen"
                                                    : ""));
  };
  if (findings.asTheyAre) add(*findings.asTheyAre, library.frames.frameCount(), false);
  if (findings.mirrored) add(*findings.mirrored, findings.mirroredFrames, true);
  if (texts.empty() && findings.largestTriedMetres > library.params.thresholdMetres)
    texts.push_back(fmt::format("No threshold up to {:.4g} m {}", findings.largestTriedMetres, nothing));
  return texts;
}

std::string lengthText(const MotionLibrary& library, double longestSeconds) {
  const double rate = library.params.framesPerSecond;
  const std::size_t around = library.params.transitionFrames + 2 * kWindowReach;
  const double needed = kStrideSeconds + static_cast<double>(around) / rate;
  if (longestSeconds >= needed) return {};
  return fmt::format(
      "The longest clip lasts {:.1f} s. A stride of walking takes about {:.1f} s, and the way back "
      "into it {} frames ({:.1f} s) more, so that clips of steady walking should last {:.1f} s at least",
      longestSeconds, kStrideSeconds, around, static_cast<double>(around) / rate, needed);
}

Warning limit(std::string message) {
  return {std::move(message), {}, WarningTopic::kGraph};
}

std::string mirrorHint(const MotionLibrary& library, std::string_view side) {
  if (library.params.mirror) return fmt::format("clips that turn {} would help", side);
  return fmt::format(
      "mirror images of the clips (--mirror) turn {} as much and help where they connect with them, or "
      "add clips that do",
      side);
}

/// "12 to 30 degrees a second".
std::string ratesText(double least, double most) {
  const long low = std::lround(least);
  const long high = std::lround(most);
  return low == high ? fmt::format("{} degrees a second", high)
                     : fmt::format("{} to {} degrees a second", low, high);
}

/// Which way walks can turn; empty when both ways.
std::string turningText(const MotionLibrary& library) {
  const std::optional<TurningReach> reach = turningReachOf(library);
  if (!reach) return {};
  const double least = reach->leastPerSecond.degrees();
  const double most = reach->mostPerSecond.degrees();
  const double straight = kStraightPerSecond.degrees();
  if (least >= -straight && most <= straight)
    return fmt::format(
        "walks go straight on only: they turn by {:.1f} degrees a second at most; clips that turn "
        "would help",
        std::max(std::abs(least), std::abs(most)));
  if (least > straight)
    return fmt::format("walks can only curve to the left, by {}: {}", ratesText(least, most),
                       mirrorHint(library, "right"));
  if (most < -straight)
    return fmt::format("walks can only curve to the right, by {}: {}", ratesText(-most, -least),
                       mirrorHint(library, "left"));
  if (least >= -straight)
    return fmt::format("walks can turn to the left only, by {:.1f} degrees a second at most: {}", most,
                       mirrorHint(library, "right"));
  if (most <= straight)
    return fmt::format("walks can turn to the right only, by {:.1f} degrees a second at most: {}", -least,
                       mirrorHint(library, "left"));
  return {};
}

std::string tinyShareText(const MotionLibrary& library, const BuildReport& report,
                          const TrialFindings& findings) {
  std::vector<std::string> texts = {
      fmt::format("only {} of {} frames are in the graph: walks can use next to nothing of these clips",
                  static_cast<std::size_t>(
                      std::lround(report.survivingShare * static_cast<double>(library.frames.frameCount()))),
                  library.frames.frameCount())};
  for (std::string& text : findingsText(library, findings, "it would hold more", "brings in a third of them"))
    texts.push_back(std::move(text));
  return sentences(texts);
}

}  // namespace

std::string adviceOnNoGraph(const MotionLibrary& library, const BuildReport& report,
                            const TrialFindings& findings) {
  const LibraryParams& params = library.params;
  const MotionSurvey survey = surveyOf(library, wholeClips(library));
  if (survey.isOnePose && survey.fastestMetresPerSecond < kWalkingSpeed)
    return "no walk could go on for ever: every frame shows the same pose";
  std::vector<std::string> texts;
  if (report.transitionsBeforePruning == 0) {
    texts.push_back(
        fmt::format("no walk could go on for ever: no {} frames of these clips come within {:.4g} m of "
                    "any other {}",
                    params.transitionFrames, params.thresholdMetres, params.transitionFrames));
  } else {
    texts.push_back(
        fmt::format("no walk could go on for ever: of the {} transitions found within {:.4g} m none "
                    "leads back to where another began",
                    report.transitionsBeforePruning, params.thresholdMetres));
  }
  for (std::string& text : findingsText(library, findings, "one could", "would do"))
    texts.push_back(std::move(text));
  const std::string length = lengthText(library, survey.longestSeconds);
  if (!length.empty()) texts.push_back(length);
  if (survey.fastestMetresPerSecond < kWalkingSpeed)
    texts.push_back(fmt::format("Nothing in the clips walks: the fastest half second goes at {:.2f} m/s",
                                survey.fastestMetresPerSecond));
  return sentences(texts);
}

Warnings limitsOf(const MotionLibrary& library, const BuildReport& report, const TrialFindings& findings) {
  Warnings limits;
  const bool isThinned = report.transitions < report.transitionsBeforeThinning;
  if (report.survivingShare < kTinyShare && !isThinned)
    limits.push_back(limit(tinyShareText(library, report, findings)));
  const MotionSurvey survey = surveyOf(library, playedRuns(library, library.graph));
  if (survey.fastestMetresPerSecond < kWalkingSpeed) {
    limits.push_back(limit(fmt::format(
        "nothing walks: the fastest half second of the graph goes at {:.2f} m/s, so that walks lead nowhere; "
        "clips that walk are needed",
        survey.fastestMetresPerSecond)));
    return limits;
  }
  if (survey.slowestMetresPerSecond > kStandingSpeed)
    limits.push_back(limit(
        fmt::format("nothing stands: the slowest half second of the graph goes at {:.2f} m/s, so that "
                    "walks begin and end in motion; a clip that sets off from standing and stops would help",
                    survey.slowestMetresPerSecond)));
  if (const std::string turning = turningText(library); !turning.empty()) limits.push_back(limit(turning));
  return limits;
}

}  // namespace stridegraph
