#include <fmt/format.h>

#include <algorithm>

#include "figures/figure.h"
#include "figures/foot_traces.h"
#include "figures/palette.h"
#include "figures/planted_feet.h"
#include "motion/contacts.h"

namespace stridegraph::figures {
namespace {

constexpr double kShownSeconds = 5.0;
constexpr double kPanelWidth = 980.0;
constexpr double kPanelHeight = 132.0;
constexpr double kLeft = 74.0;
constexpr double kTop = 72.0;
constexpr double kFastMetresPerSecond = 5.0;
constexpr double kBarPixels = 8.0;
constexpr std::string_view kColours[] = {palette::kLeft, palette::kCaptured, palette::kBlended,
                                         palette::kRight};

/// What is drawn of one foot: a joint of it, its bit and its colour.
struct FootLine {
  JointIndex joint;
  ContactMask bit;
  std::string_view colour;
};

std::vector<FootLine> linesOf(const MotionLibrary& library, const Foot& foot) {
  std::vector<FootLine> lines;
  for (std::size_t k = 0; k < library.contactJoints.size(); ++k) {
    const auto bit = static_cast<ContactMask>(1U << k);
    if ((foot.mask & bit) != 0)
      lines.push_back({library.contactJoints[k], bit, kColours[lines.size() % std::size(kColours)]});
  }
  return lines;
}

void drawFootLegend(Svg& svg, double top, const MotionLibrary& library, const Foot& foot) {
  svg.text({kLeft, top}, foot.left ? "Left foot" : "Right foot", {13.0, Anchor::kStart, palette::kInk, true});
  std::vector<LegendEntry> entries;
  for (const FootLine& line : linesOf(library, foot))
    entries.push_back(
        {{.stroke = line.colour, .strokePixels = 2.0}, library.skeleton.joints[line.joint.value].name});
  entries.push_back({{.fill = palette::kGrown}, "stands"});
  drawLegend(svg, {kLeft + 100.0, top}, entries);
}

/// A bar for each joint, drawn while it stands.
void drawContactBars(Svg& svg, const Axes& axes, const FootTraces& traces,
                     std::span<const ContactMask> contacts, const std::vector<FootLine>& lines) {
  double y = axes.frame().bottom + 6.0;
  for (const FootLine& line : lines) {
    for (const FrameRun& run : runsOf(contacts, line.bit)) {
      svg.rectangle({axes.at(traces.secondsAt(run.first), 0.0).x(), y,
                     axes.at(traces.secondsAt(run.last), 0.0).x(), y + kBarPixels - 3.0},
                    {.fill = line.colour}, 2.0);
    }
    y += kBarPixels;
  }
}

/// Height and speed of one foot, one above the other; returns where the next foot may begin.
double drawFoot(Svg& svg, double top, const MotionLibrary& library, const Plan& plan, const Foot& foot,
                bool isLast) {
  const FootTraces traces = footTraces(library, plan.walk, kShownSeconds);
  const auto contacts = std::span(plan.contacts).first(traces.frameCount());
  const std::vector<FootLine> lines = linesOf(library, foot);
  const auto height = [&](std::size_t f, JointIndex joint) {
    return 100.0 * (traces.positions[f][joint.value].y() - library.floorHeightMetres);
  };
  double most = 10.0;
  for (std::size_t f = 0; f < traces.frameCount(); ++f) {
    for (const FootLine& line : lines) most = std::max(most, height(f, line.joint));
  }
  drawFootLegend(svg, top + 14.0, library, foot);
  top += 26.0;
  const Axes heights({kLeft, top, kLeft + kPanelWidth, top + kPanelHeight}, {0.0, traces.endSeconds(), ""},
                     {-1.5, 1.06 * most, "height (cm)"});
  top += kPanelHeight + 12.0;
  const Axes speeds({kLeft, top, kLeft + kPanelWidth, top + kPanelHeight}, {0.0, traces.endSeconds(), ""},
                    {0.0, kFastMetresPerSecond, "speed (m/s)"});
  for (const Axes* axes : {&heights, &speeds}) {
    drawStances(svg, *axes, traces, runsOf(contacts, foot.mask));
    axes->drawGrid(svg);
  }
  for (const FootLine& line : lines) {
    const Style style{.stroke = line.colour, .strokePixels = 1.6};
    drawTrace(svg, heights, traces, style, [&](std::size_t f) { return height(f, line.joint); });
    drawTrace(svg, speeds, traces, style,
              [&](std::size_t f) { return traces.velocity(f, line.joint).norm(); });
  }
  heights.drawFrame(svg);
  speeds.drawFrame(svg);
  drawContactBars(svg, speeds, traces, contacts, lines);
  const double bottom = speeds.frame().bottom + 8.0 + kBarPixels * static_cast<double>(lines.size());
  if (isLast) drawTimes(svg, speeds, bottom);
  return bottom + 12.0;
}

}  // namespace

std::vector<Figure> footFigures(const FigureInputs& inputs) {
  const MotionLibrary& library = inputs.library();
  const Result<Plan> plan = inputs.planner->plan(straightWalkScene());
  if (!plan || plan->report.status != PlanStatus::kArrived) return {};
  const std::vector<Foot> feet = feetOf(library, plan->walk);
  if (feet.empty()) return {};
  const double perFoot = 26.0 + 2.0 * kPanelHeight + 12.0 + 20.0 + 4.0 * kBarPixels;
  Svg svg(kLeft + kPanelWidth + 24.0, kTop + perFoot * static_cast<double>(feet.size()) + 44.0,
          "Heights and speeds of the feet");
  const ContactParams contacts;
  drawHeading(svg, {24.0, 30.0}, "Heights and speeds of the feet in a planned walk, and the contacts found",
              fmt::format("A contact begins below {:g} cm over the joint's own level and {:g} m/s, and ends "
                          "above {:g} cm or {:g} m/s",
                          100.0 * contacts.beginHeightMetres, contacts.beginSpeedMetresPerSecond,
                          100.0 * contacts.endHeightMetres, contacts.endSpeedMetresPerSecond));
  double top = kTop;
  for (std::size_t i = 0; i < feet.size(); ++i)
    top = drawFoot(svg, top, library, *plan, feet[i], i + 1 == feet.size());
  std::vector<Figure> figures;
  figures.push_back({"foot_contacts",
                     "Each foot is low and slow together: these stretches are its contacts (bands, and a bar "
                     "for each joint under the speeds). Feet swing at 3 to 4 m/s between them, and their "
                     "heels rise before the toes.",
                     std::move(svg)});
  return figures;
}

}  // namespace stridegraph::figures
