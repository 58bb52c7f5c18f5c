#include "ompl_bench/ompl_planners.h"

#include <ompl/base/MotionValidator.h>
#include <ompl/base/PlannerTerminationCondition.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/PathSimplifier.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/prm/PRM.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include "path/path_planner.h"

namespace stridegraph::bench {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;
using Space = ob::RealVectorStateSpace;

Vec2 pointOf(const ob::State* state) {
  const double* values = state->as<Space::StateType>()->values;
  return {values[0], values[1]};
}

/// Segments are asked of the room as they are, not in steps.
class ExactMotions : public ob::MotionValidator {
 public:
  ExactMotions(const ob::SpaceInformationPtr& space, const FloorPlan& plan)
      : ob::MotionValidator(space), plan_(plan) {}

  bool checkMotion(const ob::State* from, const ob::State* to) const override {
    return plan_.isFree(pointOf(from), pointOf(to));
  }

  bool checkMotion(const ob::State* from, const ob::State* to,
                   std::pair<ob::State*, double>& lastValid) const override {
    if (checkMotion(from, to)) return true;
    if (lastValid.first != nullptr) si_->copyState(lastValid.first, from);
    lastValid.second = 0.0;
    return false;
  }

 private:
  const FloorPlan& plan_;
};

ob::SpaceInformationPtr spaceOf(const FloorPlan& plan) {
  auto space = std::make_shared<Space>(2);
  ob::RealVectorBounds bounds(2);
  bounds.setLow(0.0);
  bounds.setHigh(0, plan.widthMetres());
  bounds.setHigh(1, plan.depthMetres());
  space->setBounds(bounds);
  auto information = std::make_shared<ob::SpaceInformation>(space);
  information->setStateValidityChecker(
      [&plan](const ob::State* state) { return plan.isFree(pointOf(state)); });
  information->setMotionValidator(std::make_shared<ExactMotions>(information, plan));
  information->setup();
  return information;
}

ob::ProblemDefinitionPtr problemOf(const ob::SpaceInformationPtr& space, const Vec2& from, const Vec2& to) {
  ob::ScopedState<Space> start(space);
  ob::ScopedState<Space> goal(space);
  for (const unsigned i : {0U, 1U}) {
    start[i] = from[i];
    goal[i] = to[i];
  }
  auto problem = std::make_shared<ob::ProblemDefinition>(space);
  problem->setStartAndGoalStates(start, goal);
  return problem;
}

PathAnswer answerOf(ob::ProblemDefinition& problem, ob::PlannerStatus status, bool cutCorners) {
  if (status == ob::PlannerStatus::INVALID_START) return {"start_blocked", 0.0, {}};
  if (status == ob::PlannerStatus::INVALID_GOAL) return {"goal_blocked", 0.0, {}};
  if (!problem.hasExactSolution()) return {status.asString(), 0.0, {}};
  auto& path = *problem.getSolutionPath()->as<og::PathGeometric>();
  if (cutCorners) og::PathSimplifier(problem.getSpaceInformation()).simplifyMax(path);
  PathAnswer answer{std::string(pathStatusName(PathStatus::kFound)), path.length(), {}};
  for (const ob::State* state : path.getStates()) answer.path.push_back(pointOf(state));
  return answer;
}

/// `improves`: a path found is only taken when improveMilliseconds have passed.
template <typename Planner>
PathMethod methodOf(const std::string& name, bool improves, const OmplParams& params) {
  return {name, true,
          [improves, params](const FloorPlan& plan, const Placement& start, const Placement& goal,
                             std::uint64_t seed) {
            ompl::RNG::setSeed(static_cast<std::uint_fast32_t>(seed + 1));
            const ob::SpaceInformationPtr space = spaceOf(plan);
            const ob::ProblemDefinitionPtr problem = problemOf(space, start.position, goal.position);
            Planner planner(space);
            planner.setProblemDefinition(problem);
            planner.setup();
            bool isThere = false;
            problem->setIntermediateSolutionCallback(
                [&](const ob::Planner*, const std::vector<const ob::State*>&, ob::Cost) { isThere = true; });
            const double begin = params.clock();
            const ob::PlannerStatus status = planner.solve(ob::PlannerTerminationCondition([&] {
              const double passed = params.clock() - begin;
              return passed > params.mostMilliseconds ||
                     (improves && isThere && passed > params.improveMilliseconds);
            }));
            return answerOf(*problem, status, !improves);
          }};
}

}  // namespace

std::vector<PathMethod> omplMethods(const OmplParams& params) {
  ompl::msg::noOutputHandler();
  return {methodOf<og::PRM>("ompl-prm", false, params),
          methodOf<og::RRTConnect>("ompl-rrt-connect", false, params),
          methodOf<og::BITstar>("ompl-bit-star", true, params)};
}

}  // namespace stridegraph::bench
