#include "walk/plan_measures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "motion/transition_blend.h"
#include "walk/standing.h"
#include "walk/walk_measures.h"

namespace stridegraph {
namespace {

/// A walk stands where its first or last so many steps show no more than swaying.
constexpr std::size_t kStillFrames = 4;

/// Nearer than this to the goal and its heading a walk is said to have arrived there.
constexpr double kArrivedMetres = 0.02;
constexpr double kArrivedDegrees = 3.0;

JointRatio named(const MotionLibrary& library, const WorstRatio& worst) {
  return {worst.ratio, worst.frame, library.skeleton.joints[worst.joint.value].name};
}

void measureMotion(const FinishedWalk& done, PlanReport& report) {
  const Clip& walk = done.walk;
  const FootPaths feet = footPaths(done.library.skeleton, wholeOf(walk), done.library.contactJoints);
  report.footSkateCmPerSecond = footSkate(feet, walk.framesPerSecond);
  report.footSkateSourceCmPerSecond = done.sources.footSkateCmPerSecond;
  report.penetrationMetres = footPenetration(feet, done.sources.footFloorsMetres);
  const WorstRatios worst = worstRatios(done.sources.limits, walk);
  report.jointSpeed = named(done.library, worst.speed);
  report.jointAcceleration = named(done.library, worst.acceleration);
}

void measureEnds(const FinishedWalk& done, PlanReport& report) {
  const Clip& walk = done.walk;
  const FloorTransform last = rootPlacement(walk.pose(walk.frameCount() - 1));
  report.arrivalErrorMetres = (last.translation - done.scene.goal.position).norm();
  if (done.scene.goal.heading) {
    const Heading facing = last.heading - done.library.facingOffset;
    report.arrivalHeadingError =
        Angle::radians(std::abs((facing - Heading::fromAngle(*done.scene.goal.heading)).angle().radians()));
  }
  const std::size_t end = walk.frameCount() - 1;
  const std::size_t few = std::min(end, kStillFrames);
  report.startsStanding = few > 0 && isStill(walk, 0, few);
  report.endsStanding = few > 0 && isStill(walk, end - few, end);
}

/// What a walk that arrives leaves to be wished for, in sentences.
std::string caveats(const FinishedWalk& done, const PlanReport& report) {
  std::vector<std::string> sentences;
  if (report.clearanceMetres < -FloorPlan::kTouchToleranceMetres) {
    sentences.push_back(fmt::format(
        "the walk reaches {:.2f} m into an obstacle or a wall: the {} search does not look at them",
        -report.clearanceMetres, searchName(report.search)));
  }
  if (!done.scene.moving.empty()) sentences.emplace_back("moving obstacles are not looked at yet");
  if (report.arrivalErrorMetres > kArrivedMetres)
    sentences.push_back(fmt::format("the walk ends {:.2f} m from the goal", report.arrivalErrorMetres));
  if (report.arrivalHeadingError && report.arrivalHeadingError->degrees() > kArrivedDegrees)
    sentences.push_back(fmt::format("it ends turned {:.0f} degrees from the heading asked for",
                                    report.arrivalHeadingError->degrees()));
  if (done.options.standing && done.graph.canStartStanding() && !report.startsStanding)
    sentences.emplace_back("it begins in motion: no way that begins with standing was found");
  if (done.options.standing && done.graph.canEndStanding() && !report.endsStanding)
    sentences.emplace_back("it ends in motion: no way that comes to a stand was found");
  return fmt::format("{}", fmt::join(sentences, "; "));
}

/// Notes which frames of the library the walk plays: a clip piece may be entered and left on its way.
void noteEdges(const MotionPath& motion, PlanReport& report) {
  std::size_t shown = 1;
  for (const WalkStep& step : motion.steps) {
    FrameIndex from = step.piece.from;
    FrameIndex to = step.piece.to;
    if (step.piece.kind == EdgeKind::kClipPiece) {
      to = FrameIndex(std::size_t{from.value + step.end});
      from = FrameIndex(std::size_t{from.value + step.begin});
    } else {
      ++report.transitions;
      report.seams.push_back({shown, from, to, static_cast<double>(step.piece.distanceMetres)});
    }
    report.edges.emplace_back(from, to);
    shown += step.end - step.begin;
  }
}

}  // namespace

void measurePlan(const FinishedWalk& done, PlanReport& report) {
  report.frames = done.walk.frameCount();
  report.durationSeconds = static_cast<double>(report.frames - 1) / done.walk.framesPerSecond;
  report.motionLengthMetres = rootPathLength(done.walk);
  report.clearanceMetres = smallestClearance(done.floor, done.walk);
  measureMotion(done, report);
  measureEnds(done, report);
  noteEdges(done.motion, report);
  report.explanation = caveats(done, report);
}

}  // namespace stridegraph
