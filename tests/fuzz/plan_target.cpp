#include <memory>

#include "graph/test_library.h"
#include "made_scene.h"
#include "plan_checks.h"
#include "scene/scene_json.h"
#include "target.h"
#include "text_checks.h"
#include "walk/test_library.h"
#include "walk/walk_planner.h"

namespace stridegraph::fuzz {
namespace {

const WalkPlanner& plannerOf(std::size_t which) {
  static const WalkPlanner arcs(std::make_shared<const MotionLibrary>(testing::threeArcs()));
  static const WalkPlanner stop(std::make_shared<const MotionLibrary>(testing::threeArcsAndAStop()));
  static const WalkPlanner walks(
      std::make_shared<const MotionLibrary>(testing::builtFrom(testing::threeWalks()).library));
  return which == 0 ? arcs : which == 1 ? stop : walks;
}

PlanOptions madeOptions(Input& input) {
  constexpr std::uint64_t kImprovements[] = {0, 0, 0, 100, 1000};
  PlanOptions options;
  const unsigned what = input.byte();
  if ((what & 1U) != 0) options.seed = input.byte();
  if ((what & 2U) != 0) options.radiusMetres = input.oddNumber(0.05, 1.0);
  if ((what & 4U) != 0) options.planner = PlannerKind::kRrtConnect;
  if ((what & 24U) == 24U) options.search = input.chance() ? SearchKind::kThesis : SearchKind::kThesisChecked;
  options.standing = (what & 32U) == 0;
  options.footCleanup = (what & 64U) == 0;
  if ((what & 128U) != 0) {
    options.goalRadiusMetres = input.oddNumber(0.01, 1.0);
    options.subgoalSpacingMetres = input.oddNumber(0.2, 5.0);
    options.enoughRatio = input.oddNumber(1.0, 2.0);
  }
  options.improvementExpansions = kImprovements[input.below(5)];
  options.clock = countingClock();
  options.budgetMilliseconds = 20.0;
  return options;
}

/// Of the room under way another block comes or goes.
Scene changed(Input& input, Scene scene) {
  if (!scene.obstacles.empty() && input.chance()) scene.obstacles.pop_back();
  if (input.chance()) scene.obstacles.push_back(madeBlock(input, scene));
  if (input.chance()) scene.goal.position = {input.number(0.0, scene.widthMetres), scene.depthMetres / 2.0};
  return scene;
}

bool allArrive(const Plan& plan) {
  if (plan.report.status != PlanStatus::kArrived) return false;
  for (const Plan& other : plan.others)
    if (other.report.status != PlanStatus::kArrived) return false;
  return true;
}

}  // namespace

void tryPlan(Bytes bytes) {
  Input input(bytes);
  const WalkPlanner& planner = plannerOf(input.below(3));
  PlanOptions options = madeOptions(input);
  const Scene scene = madeScene(input);
  const Result<Plan> plan = planner.plan(scene, options);
  if (!plan) return requireSound(plan.error(), 0);
  require(checkScene(scene).has_value(), "a scene out of range is refused");
  requireSound(*plan, scene);
  if (input.bytesLeft() == 0 || !allArrive(*plan)) return;
  const std::size_t frame = input.word() % (plan->walk.frameCount() + 3);
  options.clock = countingClock();
  const Scene next = changed(input, scene);
  const Result<Plan> onward = planner.replan(*plan, frame, next, options);
  if (!onward) return requireSound(onward.error(), 0);
  require(checkScene(next).has_value(), "a changed scene out of range is refused");
  require(onward->others.size() == next.walkers.size(), "each walker has a plan");
}

}  // namespace stridegraph::fuzz
