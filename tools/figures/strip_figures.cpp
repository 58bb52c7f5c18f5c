#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "figures/axes.h"
#include "figures/body_painter.h"
#include "figures/figure.h"
#include "figures/palette.h"
#include "figures/planted_feet.h"

namespace stridegraph::figures {
namespace {

constexpr double kPixelsPerMetre = 158.0;
constexpr double kElevationDegrees = 20.0;
constexpr double kHeightPixels = 400.0;
constexpr double kMiddlePixels = 318.0;  ///< Of the floor.
constexpr double kSoleMetres = 0.033;    ///< Soles lie so far below the lowest joints.
constexpr double kBetweenPosesMetres = 0.66;
constexpr double kLengthMetres = 9.2;
constexpr double kMiddleMetres = 0.8;  ///< Of the corridor, from its side.

/// From standing to standing along a corridor, so that the walk stays in the picture.
Scene stripScene() {
  Scene scene;
  scene.name = "strip";
  scene.widthMetres = kLengthMetres + 2.4;
  scene.depthMetres = 2.0 * kMiddleMetres;
  scene.start = {{1.2, kMiddleMetres}, Angle::degrees(90.0)};
  scene.goal = {{1.2 + kLengthMetres, kMiddleMetres}, Angle::degrees(90.0)};
  return scene;
}

/// The frames to show: evenly along the strip, the first and the last among them.
std::vector<std::size_t> framesToShow(const Clip& walk) {
  const auto along = [&](std::size_t frame) { return walk.rootPositions[frame].x(); };
  const std::size_t last = walk.frameCount() - 1;
  const double length = along(last) - along(0);
  const auto poses = static_cast<std::size_t>(std::lround(std::max(1.0, length / kBetweenPosesMetres)));
  std::vector<std::size_t> frames = {0};
  for (std::size_t i = 1; i < poses; ++i) {
    const double target = along(0) + length * static_cast<double>(i) / static_cast<double>(poses);
    std::size_t f = frames.back();
    while (f < last && along(f) < target) ++f;
    frames.push_back(f);
  }
  frames.push_back(last);
  return frames;
}

void drawFloor(Svg& svg, const View& view, double widthMetres, double floorMetres) {
  const auto at = [&](double x, double z) { return view.atFloor({x, z}, floorMetres); };
  constexpr double kFarMetres = kMiddleMetres - 0.9;
  constexpr double kNearMetres = kMiddleMetres + 0.8;
  const Vec2 corners[] = {at(0.0, kFarMetres), at(widthMetres, kFarMetres), at(widthMetres, kNearMetres),
                          at(0.0, kNearMetres)};
  svg.polygon(corners, {.fill = palette::kFloor});
  svg.line(corners[0], corners[1], {.stroke = palette::kFrame});
  for (double x = 1.0; x < widthMetres; x += 1.0)
    svg.line(at(x, kFarMetres), at(x, kNearMetres), {.stroke = palette::kFaint});
}

void drawFootprints(Svg& svg, const View& view, const MotionLibrary& library, const Plan& plan) {
  for (const PlantedFoot& foot : plantedFeet(library, plan.walk, plan.contacts)) {
    std::vector<Vec2> outline;
    for (const Vec2& point : soleOutline(foot))
      outline.push_back(view.atFloor(point, library.floorHeightMetres - kSoleMetres));
    svg.polygon(outline, {.fill = foot.left ? palette::kLeft : palette::kRight, .opacity = 0.5});
  }
}

void drawShadow(Svg& svg, const View& view, const Vec3& root, double floorMetres) {
  const double flat = view.toward.y();
  for (const double radius : {0.34, 0.31, 0.28, 0.25, 0.22, 0.18, 0.14}) {
    const double across = radius * view.pixelsPerMetre;
    svg.ellipse(view.atFloor(onFloor(root), floorMetres), {across, flat * across},
                {.fill = palette::kInk, .opacity = 0.03});
  }
}

}  // namespace

std::vector<Figure> stripFigures(const FigureInputs& inputs) {
  const MotionLibrary& library = inputs.library();
  const Scene scene = stripScene();
  const Result<Plan> plan = inputs.planner->plan(scene);
  if (!plan || plan->report.status != PlanStatus::kArrived) return {};
  const double floor = library.floorHeightMetres - kSoleMetres;
  View view = View::from(Angle::degrees(0.0), Angle::degrees(kElevationDegrees), kPixelsPerMetre);
  Svg svg(scene.widthMetres * kPixelsPerMetre, kHeightPixels, "A planned walk, pose by pose");
  view.originPixels = {0.0,
                       kMiddlePixels + view.pixelsPerMetre * view.up.dot(Vec3(0.0, floor, kMiddleMetres))};
  svg.beginClip({0.0, 0.0, svg.width(), svg.height()});
  drawFloor(svg, view, scene.widthMetres, floor);
  svg.endClip();
  drawFootprints(svg, view, library, *plan);
  const RoundBody body = roundBody(library.skeleton, library.frames);
  const std::vector<std::size_t> frames = framesToShow(plan->walk);
  for (const std::size_t f : frames) drawShadow(svg, view, plan->walk.rootPositions[f], floor);
  for (const std::size_t f : frames) {
    const bool blended = plan->frameKinds[f] == EdgeKind::kTransition;
    drawBody(svg, placeParts(body, library.skeleton, plan->walk.pose(f)), view,
             blended ? "#8f7fe0" : "#e88a5a");
    svg.text(view.atFloor({plan->walk.rootPositions[f].x(), kMiddleMetres + 1.12}, floor),
             fmt::format("{:.1f} s", static_cast<double>(f) / plan->walk.framesPerSecond),
             {13.0, Anchor::kMiddle, palette::kQuiet});
  }
  std::vector<Figure> figures;
  figures.push_back(
      {"strip",
       fmt::format("A walk of {:.1f} m from standing to standing, planned along a corridor: {} poses of {} "
                   "frames, violet where two clips are blended. Footprints, left green and right red, are "
                   "where the feet stay while the body goes on.",
                   plan->report.motionLengthMetres, frames.size(), plan->report.frames),
       std::move(svg)});
  return figures;
}

}  // namespace stridegraph::figures
