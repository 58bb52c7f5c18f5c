#include "bench/bench_run.h"

#include "path/floor_plan.h"
#include "path/path_planner.h"
#include "walk/plan.h"

namespace stridegraph::bench {

bool isSound(const BenchRun& run) {
  if (!run.shortestMetres) {
    return run.status == planStatusName(PlanStatus::kStartBlocked) ||
           run.status == planStatusName(PlanStatus::kGoalBlocked) ||
           run.status == planStatusName(PlanStatus::kNoPath);
  }
  const bool ended =
      run.status == planStatusName(PlanStatus::kArrived) || run.status == pathStatusName(PathStatus::kFound);
  return ended && run.clearanceMetres >= -FloorPlan::kTouchToleranceMetres &&
         run.arrivalErrorMetres <= run.goalRadiusMetres;
}

bool isTime(std::string_view figureName) {
  return figureName.ends_with(" ms") || figureName.ends_with(" s");
}

}  // namespace stridegraph::bench
