#include <fmt/format.h>

#include <algorithm>

#include "figures/axes.h"
#include "figures/figure.h"
#include "figures/palette.h"
#include "figures/room_view.h"
#include "figures/walk_drawing.h"

namespace stridegraph::figures {
namespace {

constexpr double kWidth = 900.0;
constexpr double kMargin = 22.0;
constexpr double kTop = 66.0;
constexpr double kLegendPixels = 40.0;

Figure walkFigure(const FigureInputs& inputs, const Scene& scene, const Plan& plan) {
  const double roomWidth = kWidth - 2.0 * kMargin;
  Svg svg(kWidth, kTop + roomHeight(scene, roomWidth) + kLegendPixels, "Walk through " + scene.name);
  drawHeading(svg, {kMargin, 32.0}, scene.name, figuresOf(plan));
  const RoomView view(scene, {kMargin, kTop, kMargin + roomWidth, svg.height() - kLegendPixels});
  view.drawRoom(svg);
  view.drawEnds(svg);
  svg.polyline(view.at(plan.path), {.stroke = palette::kPath, .strokePixels = 1.2, .dashes = "5 4"});
  drawWalk(svg, view, inputs.library(), plan);
  drawWalkLegend(svg, {kMargin + 40.0, svg.height() - 18.0});
  return {
      "walk_" + fileNameFrom(scene.name),
      fmt::format("The walk through \u201c{}\u201d from above: {}. Pale zones are where the middle of the "
                  "body's disc, {:.2f} m in radius, must not go; the root's way stays out of them.",
                  scene.name, figuresOf(plan), plan.report.radiusMetres),
      std::move(svg)};
}

}  // namespace

std::vector<Figure> walkFigures(const FigureInputs& inputs) {
  std::vector<Figure> figures;
  for (const Scene& scene : inputs.scenes) {
    const Result<Plan> plan = inputs.planner->plan(scene);
    if (plan && plan->report.status == PlanStatus::kArrived)
      figures.push_back(walkFigure(inputs, scene, *plan));
  }
  return figures;
}

}  // namespace stridegraph::figures
