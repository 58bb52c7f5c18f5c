#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/clock.h"
#include "graph/library.h"
#include "motion/clip.h"
#include "path/path_planner.h"
#include "scene/scene.h"
#include "walk/arrival_warp.h"
#include "walk/motion_search.h"

namespace stridegraph {

/// How a plan ended. Names in reports are planStatusName()'s: "arrived", "start_blocked", ...
enum class PlanStatus { kArrived, kStartBlocked, kGoalBlocked, kNoPath, kNoMotion, kBudgetSpent };

std::string_view planStatusName(PlanStatus status);

/// What may be asked of a plan beside the scene.
struct PlanOptions {
  std::optional<std::uint64_t> seed;   ///< Instead of the scene's.
  std::optional<double> radiusMetres;  ///< Instead of the scene's; 0.05..5.
  double goalRadiusMetres = 0.1;       ///< Tolerance of the search; the end is bent to the goal; 0.01..5.
  PlannerKind planner = PlannerKind::kPrm;
  SearchKind search = SearchKind::kGuided;
  bool standing = true;               ///< Begin and end with a standing body where the library can.
  bool footCleanup = true;            ///< Pin planted feet (FootCleanup); false leaves them as blended.
  double subgoalSpacingMetres = 2.0;  ///< Of the thesis search (5.5), 0.2..20.
  double budgetMilliseconds = 0.0;    ///< For the motion search; 0 means no limit in time.
  /// States looked at beyond those of the first walk, to find better ones (guidedSearch); the same number
  /// gives the same walk everywhere.
  std::uint64_t improvementExpansions = 0;
  /// Looks for no better walk than one at most so many times as long as the way that a disc would have to
  /// take to the goal (DistanceField); 1..10. None when not set.
  std::optional<double> enoughRatio;
  MillisecondClock clock;  ///< For timings and the budget.
};

/// A transition in a walk.
struct WalkSeam {
  std::size_t frame = 0;  ///< First frame of the walk that it shows.
  FrameIndex from, to;    ///< Library frames at both its ends.
  double distanceMetres = 0.0;
};

/// How far a walk goes beyond what the library's joints do at most (MotionLimits), and where.
struct JointRatio {
  double ratio = 0.0;
  std::size_t frame = 0;  ///< Of the walk.
  std::string joint;
};

/// What happened, in figures (DESIGN, section 4).
struct PlanReport {
  PlanStatus status = PlanStatus::kNoPath;
  std::string explanation;  ///< A sentence for people: what stands in the way, or empty.
  std::uint64_t seed = 0;
  PlannerKind planner = PlannerKind::kPrm;
  SearchKind search = SearchKind::kGuided;
  double radiusMetres = 0.0;
  double goalRadiusMetres = 0.0;
  double unitsPerMetre = 100.0;
  double pathMilliseconds = 0.0;
  double motionMilliseconds = 0.0;
  double synthesisMilliseconds = 0.0;
  double totalMilliseconds = 0.0;
  double pathLengthMetres = 0.0;
  double motionLengthMetres = 0.0;
  double durationSeconds = 0.0;
  std::size_t frames = 0;
  std::uint64_t expansions = 0;
  std::size_t transitions = 0;
  std::size_t smallSteps = 0;  ///< Taken from a standing pose to a near goal, where no clip walks there.
  std::vector<std::pair<FrameIndex, FrameIndex>>
      edges;                     ///< Library frames at both ends of every edge played.
  double clearanceMetres = 0.0;  ///< Smallest, of the disc's rim, along the walk; negative when it collides.
  double footSkateCmPerSecond = 0.0;
  double footSkateSourceCmPerSecond = 0.0;  ///< The same of the library's clips.
  double penetrationMetres = 0.0;           ///< How far the lowest foot joint sinks below the clips' floors.
  std::size_t contacts = 0;                 ///< Stances of all feet that were pinned to one place.
  double feetCorrectedMeanMetres = 0.0;     ///< How far planted feet were moved,
  double feetCorrectedWorstMetres = 0.0;    ///< and the farthest.
  std::vector<std::string> feetLeftAlone;   ///< Contact joints above which no leg could be made out.
  std::vector<WalkSeam> seams;
  JointRatio jointSpeed, jointAcceleration;
  double arrivalErrorMetres = 0.0;           ///< From the last root to the goal, over the floor.
  std::optional<Angle> arrivalHeadingError;  ///< From the last facing to the goal's heading, if it has one.
  ArrivalWarp arrivalWarp;                   ///< How the walk's end was bent to get there.
  double bentShare = 0.0;                    ///< Share of the walk's frames that are bent (bentStep).
  /// Smallest distance of the disc's rim from anything that moves, metres; not set where nothing does.
  std::optional<double> movingClearanceMetres;
  /// When something that moves along a track first touches the body where it stands at the walk's end,
  /// seconds after the walk's beginning; not set where nothing ever does.
  std::optional<double> goalFreeUntilSeconds;
  /// Share of the walk that keeps to the scene's gait and speed; not set where it asks for none.
  std::optional<double> constraintsKept;
  bool startsStanding = false;
  bool endsStanding = false;
  std::uint64_t libraryHash = 0;
};

/// A planned walk with all that was on the way to it, for showing.
struct Plan {
  PlanReport report;
  Clip walk;                          ///< Empty unless arrived.
  std::vector<EdgeKind> frameKinds;   ///< For each frame of the walk: captured, or blended or stepped.
  std::vector<ContactMask> contacts;  ///< For each frame of the walk, as in the library.
  /// Placements of the walk's frames before its end was bent to the goal; empty where it was not bent.
  std::vector<FloorTransform> unbentWay;
  std::vector<std::pair<Vec2, Vec2>> roadmap;  ///< Edges of the roadmap or of both trees.
  /// From start to goal; empty when there is none. Where the scene has areas it is the way that heeds them,
  /// and the report's path length is still that of the planner's.
  std::vector<Vec2> path;
  std::vector<Vec2> subgoals;
  /// What the walk plays; without steps unless arrived. Of small steps, the frame of the stand.
  MotionPath motion;
  std::vector<FloorTransform> way;  ///< Where the body stands at each frame of the walk.
  Scene scene;                      ///< What was planned for; of a further walker empty.
  PlanOptions options;              ///< And with which options.
  bool kept = false;                ///< replan() left the walk as it was.
  std::vector<Plan> others;         ///< Walks of the scene's further walkers, in their order.
};

/// The report as the JSON object of DESIGN, section 4.
std::string toJson(const PlanReport& report);

/// The report of a plan, with those of its further walkers as the member "walkers" where it has any.
std::string toJson(const Plan& plan);

}  // namespace stridegraph
