#include <fmt/format.h>

#include <algorithm>

#include "figures/axes.h"
#include "figures/figure.h"
#include "figures/palette.h"
#include "figures/room_view.h"
#include "figures/walk_drawing.h"

namespace stridegraph::figures {
namespace {

constexpr double kRoomWidth = 580.0;
constexpr double kMargin = 22.0;
constexpr double kTop = 92.0;

/// The walks of both searches through a room, thesis search first; nothing unless both arrive.
std::vector<Plan> plansOfBoth(const WalkPlanner& planner, const Scene& scene) {
  std::vector<Plan> plans;
  for (const SearchKind search : {SearchKind::kThesis, SearchKind::kGuided}) {
    PlanOptions options;
    options.search = search;
    Result<Plan> plan = planner.plan(scene, options);
    if (!plan || plan->report.status != PlanStatus::kArrived) return {};
    plans.push_back(std::move(*plan));
  }
  return plans;
}

/// The most telling room for which the searches differ: where the thesis search reaches farthest into a wall.
struct Comparison {
  const Scene* scene = nullptr;
  std::vector<Plan> plans;
};
Comparison mostTelling(const FigureInputs& inputs) {
  Comparison best;
  for (const Scene& scene : inputs.scenes) {
    std::vector<Plan> plans = plansOfBoth(*inputs.planner, scene);
    if (plans.empty()) continue;
    if (best.scene == nullptr || plans[0].report.clearanceMetres < best.plans[0].report.clearanceMetres)
      best = {&scene, std::move(plans)};
  }
  return best;
}

}  // namespace

std::vector<Figure> searchFigures(const FigureInputs& inputs) {
  const Comparison comparison = mostTelling(inputs);
  if (comparison.scene == nullptr) return {};
  const Scene& scene = *comparison.scene;
  const double height = roomHeight(scene, kRoomWidth);
  Svg svg(3.0 * kMargin + 2.0 * kRoomWidth, kTop + height + 40.0, "Two searches");
  drawHeading(svg, {kMargin, 30.0}, fmt::format("Two searches of the graph through {}", scene.name));
  const std::string titles[] = {"Thesis: best first by (2 \u2212 cos \u03b1) d",
                                "Guided: every frame checked"};
  for (std::size_t i = 0; i < comparison.plans.size(); ++i) {
    const Plan& plan = comparison.plans[i];
    const double left = kMargin + static_cast<double>(i) * (kRoomWidth + kMargin);
    const RoomView view(scene, {left, kTop, left + kRoomWidth, kTop + height});
    svg.text({view.frame().left, kTop - 28.0}, titles[i], {13.0, Anchor::kStart, palette::kInk, true});
    svg.text({view.frame().left, kTop - 11.0},
             fmt::format("{}, {} expansions", figuresOf(plan), plan.report.expansions),
             {12.0, Anchor::kStart, palette::kQuiet});
    view.drawRoom(svg);
    view.drawEnds(svg);
    svg.polyline(view.at(plan.path), {.stroke = palette::kPath, .strokePixels = 1.2, .dashes = "5 4"});
    drawWalk(svg, view, inputs.library(), plan);
  }
  drawWalkLegend(svg, {kMargin + 52.0, svg.height() - 16.0});
  std::vector<Figure> figures;
  figures.push_back(
      {"searches",
       "The search of the thesis (section 5.5) follows the subgoals but looks at no obstacle, so that its "
       "walk may run into the pale zones and blocks; a negative clearance says how far. The guided search "
       "checks every frame and arrives standing.",
       std::move(svg)});
  return figures;
}

}  // namespace stridegraph::figures
