#include "walk/plan.h"

namespace stridegraph {

std::string_view planStatusName(PlanStatus status) {
  switch (status) {
    case PlanStatus::kArrived:
      return "arrived";
    case PlanStatus::kStartBlocked:
      return "start_blocked";
    case PlanStatus::kGoalBlocked:
      return "goal_blocked";
    case PlanStatus::kNoPath:
      return "no_path";
    case PlanStatus::kNoMotion:
      return "no_motion";
    case PlanStatus::kBudgetSpent:
      return "budget_spent";
  }
  return "unknown";
}

}  // namespace stridegraph
