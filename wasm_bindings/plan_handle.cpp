#include "plan_handle.h"

#include <cstdint>
#include <utility>

#include "walk_values.h"

namespace stridegraph::bindings {
namespace {

/// A few milliseconds.
constexpr std::uint64_t kExpansionsPerStep = 1000;

}  // namespace

PlanHandle::PlanHandle(std::shared_ptr<Session> session, AnytimePlan plan)
    : session_(std::move(session)), plan_(std::move(plan)) {
  remember();
}

emscripten::val PlanHandle::walk() const {
  return planValue(session_->planner.library().skeleton, plan_.best());
}

bool PlanHandle::step() {
  const bool better = plan_.step(kExpansionsPerStep);
  if (better) remember();
  return better;
}

void PlanHandle::remember() {
  if (plan_.best().report.status == PlanStatus::kArrived) session_->underWay.emplace(plan_.best());
}

}  // namespace stridegraph::bindings
