#include "walk/plan_measures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "motion/transition_blend.h"
#include "walk/constraint_cost.h"
#include "walk/standing.h"
#include "walk/walk_measures.h"

namespace stridegraph {
namespace {

/// A walk stands where its first or last so many steps show no more than swaying.
constexpr std::size_t kStillFrames = 4;

/// Nearer than this to the goal and its heading a walk is said to have arrived there.
constexpr double kArrivedMetres = 0.02;
constexpr double kArrivedDegrees = 3.0;

/// Less than this of a walk in the pace asked for is worth a word.
constexpr double kMostlyKept = 0.8;

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
  report.arrivalErrorMetres = (last.translation - done.goal.position).norm();
  if (done.goal.heading) {
    const Heading facing = last.heading - done.library.facingOffset;
    report.arrivalHeadingError =
        Angle::radians(std::abs((facing - Heading::fromAngle(*done.goal.heading)).angle().radians()));
  }
  const std::size_t end = walk.frameCount() - 1;
  const std::size_t few = std::min(end, kStillFrames);
  report.startsStanding = few > 0 && isStill(walk, 0, few);
  report.endsStanding = few > 0 && isStill(walk, end - few, end);
}

/// Speeds are means over so many frames: about a step.
constexpr std::size_t kPaceFrames = 16;

/// The share of the walk that keeps to the pace asked for.
double paceKept(const WalkConstraints& constraints, const Clip& walk) {
  const std::size_t window = std::min(kPaceFrames, walk.frameCount() - 1);
  std::size_t kept = 0;
  std::size_t looked = 0;
  for (std::size_t f = window; f < walk.frameCount(); ++f, ++looked) {
    double metres = 0.0;
    for (std::size_t k = f - window; k < f; ++k) {
      const Vec3 step = walk.rootPositions[k + 1] - walk.rootPositions[k];
      metres += std::hypot(step.x(), step.z());
    }
    const double speed = metres * walk.framesPerSecond / static_cast<double>(window);
    if (keepsTo(constraints, speed)) ++kept;
  }
  return looked > 0 ? static_cast<double>(kept) / static_cast<double>(looked) : 1.0;
}

/// What the walk has to do with whatever moves, and with what the scene asks for.
void measureScene(const FinishedWalk& done, PlanReport& report) {
  if (!done.traffic.empty()) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t f = 0; f < done.walk.frameCount(); ++f) {
      const Vec3& root = done.walk.rootPositions[f];
      least = std::min(least, done.traffic.clearance({root.x(), root.z()}, static_cast<std::uint32_t>(f)));
    }
    report.movingClearanceMetres = least;
    const Vec3& last = done.walk.rootPositions.back();
    const auto end = static_cast<std::uint32_t>(done.walk.frameCount() - 1);
    if (const auto touched = done.traffic.touchedFrom({last.x(), last.z()}, end))
      report.goalFreeUntilSeconds = *touched / done.walk.framesPerSecond;
  }
  const WalkConstraints& constraints = done.scene.constraints;
  if (constraints.asksForPace()) report.constraintsKept = paceKept(constraints, done.walk);
}

/// What a walk that arrives leaves to be wished for, in sentences.
std::string caveats(const FinishedWalk& done, const PlanReport& report) {
  std::vector<std::string> sentences;
  if (report.clearanceMetres < -FloorPlan::kTouchToleranceMetres) {
    sentences.push_back(fmt::format(
        "the walk reaches {:.2f} m into an obstacle or a wall: the {} search does not look at them",
        -report.clearanceMetres, searchName(report.search)));
  }
  if (report.movingClearanceMetres && *report.movingClearanceMetres < 0.0)
    sentences.push_back(
        fmt::format("it comes {:.2f} m into something that moves", -*report.movingClearanceMetres));
  if (report.goalFreeUntilSeconds)
    sentences.push_back(fmt::format("it can stand there until {:.1f} s, when something that moves comes by",
                                    *report.goalFreeUntilSeconds));
  if (report.constraintsKept && *report.constraintsKept < kMostlyKept)
    sentences.push_back(fmt::format("it keeps to the gait and speed asked for only {:.0f} % of the time",
                                    100.0 * *report.constraintsKept));
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

/// Notes which frames of the library the walk plays, a clip piece may be entered and left on its way, and how
/// many of them are bent.
void noteEdges(const MotionPath& motion, PlanReport& report) {
  std::size_t shown = 1;
  std::size_t bent = 0;
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
    if (step.turnPerMetre != Angle{}) bent += step.end - step.begin;
  }
  report.bentShare = static_cast<double>(bent) / static_cast<double>(shown);
}

}  // namespace

void measurePlan(const FinishedWalk& done, PlanReport& report) {
  report.frames = done.walk.frameCount();
  report.durationSeconds = static_cast<double>(report.frames - 1) / done.walk.framesPerSecond;
  report.motionLengthMetres = rootPathLength(done.walk);
  report.clearanceMetres = smallestClearance(done.floor, done.walk);
  measureMotion(done, report);
  measureEnds(done, report);
  measureScene(done, report);
  noteEdges(done.motion, report);
  report.explanation = caveats(done, report);
}

}  // namespace stridegraph
