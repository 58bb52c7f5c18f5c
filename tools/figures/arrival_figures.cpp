#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "figures/axes.h"
#include "figures/figure.h"
#include "figures/palette.h"
#include "motion/transition_blend.h"

namespace stridegraph::figures {
namespace {

constexpr double kPanel = 380.0;
constexpr double kLeft = 66.0;
constexpr double kGap = 70.0;
constexpr double kTop = 104.0;
constexpr std::size_t kMostPanels = 3;
constexpr double kNarrowest = 600.0;  ///< Paper for heading and legend.
constexpr double kTickMetres = 0.14;
constexpr double kBetweenTicksMetres = 0.15;

/// How far a way ends from the goal.
struct EndError {
  double metres = 0.0;
  double degrees = 0.0;
};

EndError errorOf(const FloorTransform& end, const Placement& goal) {
  EndError error{(end.translation - goal.position).norm(), 0.0};
  if (goal.heading)
    error.degrees = std::abs((end.heading - Heading::fromAngle(*goal.heading)).angle().degrees());
  return error;
}

std::string textOf(const EndError& error) {
  return fmt::format("{:.1f} cm and {:.1f}\u00b0 off", 100.0 * error.metres, error.degrees);
}

/// A walk whose end was bent.
struct Arrival {
  const Scene* scene = nullptr;
  Plan plan;
  std::vector<FloorTransform> bent;  ///< Facing, frame by frame.
};

std::vector<Arrival> arrivalsOf(const FigureInputs& inputs) {
  std::vector<Arrival> arrivals;
  for (const Scene& scene : inputs.scenes) {
    Result<Plan> plan = inputs.planner->plan(scene);
    if (!plan || plan->unbentWay.empty()) continue;
    Arrival arrival{&scene, std::move(*plan), {}};
    for (std::size_t f = 0; f < arrival.plan.walk.frameCount(); ++f) {
      arrival.bent.push_back(rootPlacement(arrival.plan.walk.pose(f)));
      arrival.bent.back().heading = arrival.bent.back().heading - inputs.library().facingOffset;
    }
    arrivals.push_back(std::move(arrival));
  }
  std::stable_sort(arrivals.begin(), arrivals.end(), [](const Arrival& a, const Arrival& b) {
    return errorOf(a.plan.unbentWay.back(), a.scene->goal).metres >
           errorOf(b.plan.unbentWay.back(), b.scene->goal).metres;
  });
  if (arrivals.size() > kMostPanels) arrivals.resize(kMostPanels);
  return arrivals;
}

/// A square around the goal, as large as shows what is left over.
Axes axesFor(const Arrival& arrival, double left) {
  constexpr double kSideMetres = 1.2;
  const Vec2& goal = arrival.scene->goal.position;
  // Where the walk comes from gets more room than what lies behind the goal.
  Vec2 from = Vec2::Zero();
  for (std::size_t f = arrival.bent.size(); f-- > 0 && from.norm() < 0.5 * kSideMetres;)
    from = arrival.bent[f].translation - goal;
  const Vec2 middle = goal + 0.5 * from;
  return {{left, kTop, left + kPanel, kTop + kPanel},
          {middle.x() - 0.5 * kSideMetres, middle.x() + 0.5 * kSideMetres, "x (m)"},
          {middle.y() + 0.5 * kSideMetres, middle.y() - 0.5 * kSideMetres, "z (m)"}};
}

void drawWay(Svg& svg, const Axes& axes, const std::vector<FloorTransform>& way, std::string_view colour) {
  std::vector<Vec2> points;
  for (const FloorTransform& p : way) points.push_back(axes.at(p.translation.x(), p.translation.y()));
  svg.polyline(points, {.stroke = colour, .strokePixels = 2.0});
  const auto tick = [&](const FloorTransform& p, double strokePixels) {
    const Vec2 tip = p.translation + kTickMetres * p.heading.direction();
    svg.line(axes.at(p.translation.x(), p.translation.y()), axes.at(tip.x(), tip.y()),
             {.stroke = colour, .strokePixels = strokePixels});
  };
  tick(way.back(), 3.0);
  const FloorTransform* last = &way.back();
  for (std::size_t f = way.size(); f-- > 0;) {
    if ((way[f].translation - last->translation).norm() < kBetweenTicksMetres) continue;
    last = &way[f];
    tick(*last, 1.0);
  }
  svg.circle(points.back(), 4.0, {.fill = colour});
}

void drawGoal(Svg& svg, const Axes& axes, const Placement& goal) {
  const Vec2 centre = axes.at(goal.position.x(), goal.position.y());
  svg.circle(centre, 9.0, {.stroke = palette::kGoal, .strokePixels = 1.6});
  svg.line(centre - Vec2(13.0, 0.0), centre + Vec2(13.0, 0.0), {.stroke = palette::kGoal});
  svg.line(centre - Vec2(0.0, 13.0), centre + Vec2(0.0, 13.0), {.stroke = palette::kGoal});
  if (!goal.heading) return;
  const Vec2 tip = goal.position + 1.9 * kTickMetres * Heading::fromAngle(*goal.heading).direction();
  svg.line(centre, axes.at(tip.x(), tip.y()),
           {.stroke = palette::kGoal, .strokePixels = 1.6, .dashes = "4 3"});
}

void drawArrival(Svg& svg, const Arrival& arrival, double left) {
  const Axes axes = axesFor(arrival, left);
  const EndError before = errorOf(arrival.plan.unbentWay.back(), arrival.scene->goal);
  const EndError after = errorOf(arrival.bent.back(), arrival.scene->goal);
  axes.drawGrid(svg);
  svg.beginClip(axes.frame());
  drawGoal(svg, axes, arrival.scene->goal);
  drawWay(svg, axes, arrival.plan.unbentWay, palette::kRoadmap);
  drawWay(svg, axes, arrival.bent, palette::kCaptured);
  svg.endClip();
  axes.drawFrame(svg);
  svg.text({left, kTop - 46.0}, arrival.scene->name, {13.0, Anchor::kStart, palette::kInk, true});
  svg.text({left, kTop - 28.0}, "before: " + textOf(before), {12.0, Anchor::kStart, palette::kQuiet});
  svg.text({left, kTop - 11.0}, "after: " + textOf(after), {12.0, Anchor::kStart, palette::kCaptured});
  const ArrivalWarp& warp = arrival.plan.report.arrivalWarp;
  svg.text({left, kTop + kPanel + 54.0},
           fmt::format("last {:.2f} m bent; steps by at most {:.1f} %, {:.1f}\u00b0/m", warp.metres,
                       100.0 * warp.stretch, std::abs(warp.turnPerMetre.degrees())),
           {12.0, Anchor::kStart, palette::kQuiet});
}

}  // namespace

std::vector<Figure> arrivalFigures(const FigureInputs& inputs) {
  const std::vector<Arrival> arrivals = arrivalsOf(inputs);
  if (arrivals.empty()) return {};
  Svg svg(std::max(kNarrowest, kLeft + static_cast<double>(arrivals.size()) * (kPanel + kGap) - kGap + 24.0),
          kTop + kPanel + 102.0, "Arrival at the goal");
  drawHeading(svg, {24.0, 30.0}, "The last metre before and after the walk is bent to its goal");
  for (std::size_t i = 0; i < arrivals.size(); ++i)
    drawArrival(svg, arrivals[i], kLeft + static_cast<double>(i) * (kPanel + kGap));
  drawLegend(svg, {kLeft, svg.height() - 18.0},
             {{{.stroke = palette::kRoadmap, .strokePixels = 2.0}, "as the search found it"},
              {{.stroke = palette::kCaptured, .strokePixels = 2.0}, "as walked"},
              {{.stroke = palette::kGoal, .strokePixels = 1.6}, "goal and heading asked for"}});
  std::vector<Figure> figures;
  figures.push_back({"arrival",
                     "The search ends near the goal, since a library's steps are what they are; what is left "
                     "over is spread along the last steps as small changes of length and turn, so that the "
                     "walk ends on the goal and faces as asked. Ticks show where the body faces.",
                     std::move(svg)});
  return figures;
}

}  // namespace stridegraph::figures
