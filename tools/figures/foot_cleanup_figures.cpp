#include <fmt/format.h>

#include <algorithm>

#include "figures/figure.h"
#include "figures/foot_traces.h"
#include "figures/palette.h"

namespace stridegraph::figures {
namespace {

constexpr double kShownSeconds = 6.0;
constexpr double kPanelWidth = 980.0;
constexpr double kPanelHeight = 150.0;
constexpr double kLeft = 74.0;
constexpr double kTop = 98.0;
constexpr double kShownCmPerSecond = 40.0;  ///< Feet that stand are slower, feet that swing much faster.
const Style kBefore{.stroke = palette::kGoal, .strokePixels = 1.4};
const Style kAfter{.stroke = palette::kLeft, .strokePixels = 2.0};

/// The same walk without and with the clean-up.
struct Cleaned {
  Plan before;
  Plan after;
};

std::optional<Cleaned> cleanedWalk(const WalkPlanner& planner) {
  PlanOptions options;
  options.footCleanup = false;
  Result<Plan> before = planner.plan(straightWalkScene(), options);
  Result<Plan> after = planner.plan(straightWalkScene());
  if (!before || !after || before->report.status != PlanStatus::kArrived) return std::nullopt;
  return Cleaned{std::move(*before), std::move(*after)};
}

/// The speed over the floor of the joint of a foot that stands longest.
Axes drawSpeeds(Svg& svg, double top, const MotionLibrary& library, const Cleaned& walk, const Foot& foot) {
  const FootTraces before = footTraces(library, walk.before.walk, kShownSeconds);
  const FootTraces after = footTraces(library, walk.after.walk, kShownSeconds);
  const auto contacts = std::span(walk.after.contacts).first(after.frameCount());
  svg.text(
      {kLeft, top - 8.0},
      fmt::format("{} foot: {}", foot.left ? "Left" : "Right", library.skeleton.joints[foot.toe.value].name),
      {13.0, Anchor::kStart, palette::kInk, true});
  const Axes axes({kLeft, top, kLeft + kPanelWidth, top + kPanelHeight}, {0.0, after.endSeconds(), ""},
                  {0.0, kShownCmPerSecond, "floor speed (cm/s)"});
  drawStances(svg, axes, after, runsOf(contacts, foot.mask));
  axes.drawGrid(svg);
  const auto speedIn = [&](const FootTraces& traces) {
    return [&](std::size_t f) { return 100.0 * onFloor(traces.velocity(f, foot.toe)).norm(); };
  };
  drawTrace(svg, axes, before, kBefore, speedIn(before));
  drawTrace(svg, axes, after, kAfter, speedIn(after));
  axes.drawFrame(svg);
  return axes;
}

}  // namespace

std::vector<Figure> footCleanupFigures(const FigureInputs& inputs) {
  const MotionLibrary& library = inputs.library();
  const std::optional<Cleaned> walk = cleanedWalk(*inputs.planner);
  if (!walk) return {};
  const std::vector<Foot> feet = feetOf(library, walk->after.walk);
  if (feet.empty()) return {};
  const PlanReport& report = walk->after.report;
  const double perFoot = kPanelHeight + 40.0;
  Svg svg(kLeft + kPanelWidth + 24.0, kTop + perFoot * static_cast<double>(feet.size()) + 56.0,
          "Clean-up of the feet");
  drawHeading(svg, {24.0, 30.0}, "Planted feet before and after the clean-up",
              fmt::format("Foot skate {:.1f} cm/s before, {:.1f} after, {:.1f} in the clips; planted feet "
                          "moved by {:.1f} cm on average, {:.1f} at most",
                          walk->before.report.footSkateCmPerSecond, report.footSkateCmPerSecond,
                          report.footSkateSourceCmPerSecond, 100.0 * report.feetCorrectedMeanMetres,
                          100.0 * report.feetCorrectedWorstMetres));
  double top = kTop;
  for (std::size_t i = 0; i < feet.size(); ++i) {
    const Axes axes = drawSpeeds(svg, top, library, *walk, feet[i]);
    if (i + 1 == feet.size()) drawTimes(svg, axes, axes.frame().bottom);
    top += perFoot;
  }
  drawLegend(svg, {kLeft, svg.height() - 18.0},
             {{kBefore, "as blended"}, {kAfter, "feet pinned"}, {{.fill = palette::kGrown}, "stands"}});
  std::vector<Figure> figures;
  figures.push_back({"foot_cleanup",
                     "How fast the tip of each foot goes over the floor, cut off where it swings. While the "
                     "foot stands, it should not go at all: blends let it creep (red), and the clean-up pins "
                     "it to one place (green).",
                     std::move(svg)});
  return figures;
}

}  // namespace stridegraph::figures
