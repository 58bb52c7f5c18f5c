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

}  // namespace stridegraph::bench
