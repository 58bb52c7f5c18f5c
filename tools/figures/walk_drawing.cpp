#include "figures/walk_drawing.h"

#include <fmt/format.h>

#include <cmath>

#include "figures/palette.h"
#include "figures/planted_feet.h"
#include "motion/transition_blend.h"

namespace stridegraph::figures {
namespace {

constexpr double kTickMetres = 0.35;

void drawRoot(Svg& svg, const RoomView& view, const Plan& plan) {
  std::size_t begin = 0;
  const std::size_t count = plan.walk.frameCount();
  for (std::size_t f = 1; f <= count; ++f) {
    if (f < count && plan.frameKinds[f] == plan.frameKinds[begin]) continue;
    std::vector<Vec2> run;
    // Runs share a frame, so that the line has no gaps.
    for (std::size_t g = begin > 0 ? begin - 1 : 0; g < f; ++g)
      run.push_back(view.at(onFloor(plan.walk.rootPositions[g])));
    const bool blended = plan.frameKinds[begin] == EdgeKind::kTransition;
    svg.polyline(run, {.stroke = blended ? palette::kBlended : palette::kCaptured, .strokePixels = 2.2});
    begin = f;
  }
}

}  // namespace

void drawWalk(Svg& svg, const RoomView& view, const MotionLibrary& library, const Plan& plan) {
  for (const PlantedFoot& foot : plantedFeet(library, plan.walk, plan.contacts)) {
    svg.polygon(view.at(soleOutline(foot)),
                {.fill = foot.left ? palette::kLeft : palette::kRight, .opacity = 0.7});
  }
  const auto every = static_cast<std::size_t>(std::lround(0.5 * plan.walk.framesPerSecond));
  for (std::size_t f = 0; f < plan.walk.frameCount(); f += every) {
    const FloorTransform root = rootPlacement(plan.walk.pose(f));
    const Vec2 facing = (root.heading - library.facingOffset).direction();
    svg.line(view.at(root.translation), view.at(Vec2(root.translation + kTickMetres * facing)),
             {.stroke = palette::kInk, .strokePixels = 1.0});
  }
  drawRoot(svg, view, plan);
}

void drawWalkLegend(Svg& svg, const Vec2& at) {
  drawLegend(svg, at,
             {{{.stroke = palette::kCaptured, .strokePixels = 2.2}, "root, from a clip"},
              {{.stroke = palette::kBlended, .strokePixels = 2.2}, "in a transition"},
              {{.stroke = palette::kPath, .strokePixels = 1.2, .dashes = "5 4"}, "planned path"},
              {{.stroke = palette::kInk}, "facing"},
              {{.fill = palette::kLeft}, "left foot"},
              {{.fill = palette::kRight}, "right foot"}});
}

std::string figuresOf(const Plan& plan) {
  const PlanReport& report = plan.report;
  return fmt::format("{:.1f} m in {:.1f} s, {} transitions, clearance {:.2f} m", report.motionLengthMetres,
                     report.durationSeconds, report.transitions, report.clearanceMetres);
}

}  // namespace stridegraph::figures
