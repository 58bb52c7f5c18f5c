#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>

#include "walk/search_graph.h"
#include "walk/search_tables.h"
#include "walk/standing_body.h"
#include "walk/step_plan.h"
#include "walk/stepped_walk.h"

namespace stridegraph {

/// A goal is near when it is at most so far from the start, in lengths of a leg: about 2 m. Farther ones are
/// walked to.
inline constexpr double kNearLegs = 2.5;

/// A walk of small steps to a near goal.
struct StepsToGoal {
  StepPlan plan;
  SynthesisedWalk walk;
  double costMetres = 0.0;  ///< In the terms of WalkCost: a walk that costs less is better.
};

/// Whether a captured walk of this length leads to the goal as directly as people go who need not step: at
/// most 1.3 times the straight way and 0.3 m, and what turning round takes while they go.
bool isDirect(const StepsToGoal& steps, double walkMetres);

/// Small steps from a start to a goal that is near, where the straight way is free: `isFree` is asked for the
/// whole way of the body, frame by frame. In narrow places the hips keep to the line. Nothing where the goal
/// is far, something is in the way, or it takes too many steps.
std::optional<StepsToGoal> stepsToGoal(const MotionLibrary& library, const StandingBody& body,
                                       const Placement& start, const Placement& goal,
                                       const std::function<bool(std::span<const FloorTransform>)>& isFree);

/// The length of the shortest walk that a library's clips make from standing to standing, metres: of those
/// that lead on by at least a short step, as swaying does not. Nothing where it knows none.
std::optional<double> shortestWalkMetres(const SearchTables& tables);

/// What keeps a walk from a goal that is so near, as a clause behind another sentence: that the library never
/// stands, or that its shortest walk is longer. Empty where neither is so.
std::string nearGoalNote(const SearchTables& tables, double metres);

}  // namespace stridegraph
