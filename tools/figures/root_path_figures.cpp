#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "figures/axes.h"
#include "figures/figure.h"
#include "figures/library_clips.h"
#include "figures/palette.h"
#include "figures/root_slip.h"
#include "graph/pose_distance.h"
#include "motion/transition_blend.h"

namespace stridegraph::figures {
namespace {

constexpr double kBlendSeconds = 1.2;  ///< Long enough for the clips' ways to part clearly.
constexpr double kSlowestMetresPerSecond = 0.6;
constexpr double kFastestMetresPerSecond = 2.0;
constexpr double kStraightDegrees = 12.0;   ///< Hips swing by some degrees in a straight walk, too.
constexpr double kLeastTurnDegrees = 60.0;  ///< Of the turn that is blended into,
constexpr double kMostTurnDegrees = 110.0;  ///< all in all.
constexpr double kPanel = 360.0;
constexpr double kTop = 96.0;

/// What is blended: a straight walk into a turn, from like poses.
struct Pair {
  Clip straight;
  Clip turning;
  TransitionBlend blend;  ///< Borrows both clips.
};

std::vector<FloorTransform> placementsOf(const ClipSpan& span) {
  std::vector<FloorTransform> track;
  for (std::size_t f = span.first; f <= span.last; ++f) track.push_back(rootPlacement(span.clip->pose(f)));
  return track;
}

Angle turnOf(const ClipSpan& span) {
  Angle turn;
  const std::vector<FloorTransform> track = placementsOf(span);
  for (std::size_t f = 0; f + 1 < track.size(); ++f)
    turn = turn + (track[f + 1].heading - track[f].heading).angle();
  return turn;
}

/// How much a root goes across its heading, to and fro, metres.
double swayOf(const ClipSpan& span, const Heading& facingOffset) {
  double sway = 0.0;
  for (const double step : sidewaysSteps(placementsOf(span), facingOffset)) sway += std::abs(step);
  return sway;
}

/// Calls `look` with every clip and span of that many frames at walking speed, as far from a clip's ends as
/// poses can be compared.
void forEachSpan(const MotionLibrary& library, std::size_t frames, const auto& look) {
  for (const LibraryClip& listed : clipsByLength(library)) {
    const Clip clip = clipOf(library, listed);
    for (std::size_t f = kWindowReach; f + frames + kWindowReach <= clip.frameCount(); ++f) {
      const ClipSpan span{&clip, f, f + frames - 1};
      const double speed = (clip.rootPositions[span.last] - clip.rootPositions[f]).norm() / kBlendSeconds;
      if (speed > kSlowestMetresPerSecond && speed < kFastestMetresPerSecond) look(span);
    }
  }
}

/// Sets the blend's target to a clear turn, the one that goes least across its own heading.
bool findTurn(const MotionLibrary& library, Pair& pair) {
  double least = std::numeric_limits<double>::infinity();
  forEachSpan(library, pair.blend.frames, [&](const ClipSpan& span) {
    const double turn = std::abs(turnOf(span).degrees());
    if (turn < kLeastTurnDegrees || turn > kMostTurnDegrees) return;
    const double sway = swayOf(span, library.facingOffset);
    if (sway >= least) return;
    least = sway;
    pair.turning = *span.clip;
    pair.blend.target = {nullptr, span.first, span.last};
  });
  return !pair.turning.rotations.empty();
}

/// Sets the blend's source to where a straight walk is most like the turn's beginning.
bool findSource(const MotionLibrary& library, Pair& pair) {
  double least = std::numeric_limits<double>::infinity();
  forEachSpan(library, pair.blend.frames, [&](const ClipSpan& span) {
    if (std::abs(turnOf(span).degrees()) > kStraightDegrees) return;
    const double distance =
        poseDistanceMetres(library.skeleton, *span.clip, span.first, pair.turning, pair.blend.target.first);
    if (distance >= least) return;
    least = distance;
    pair.straight = *span.clip;
    pair.blend.source = {nullptr, span.first, span.last};
  });
  return !pair.straight.rotations.empty();
}

std::vector<FloorTransform> movedTo(const FloorTransform& start, std::vector<FloorTransform> track) {
  const FloorTransform move = start * track.front().inverse();
  for (FloorTransform& placement : track) placement = move * placement;
  return track;
}

/// The four ways, all from the origin and facing +z.
struct Ways {
  std::vector<FloorTransform> straight, turning, plain, differential;
};

Ways waysOf(const Pair& pair, const Heading& facingOffset) {
  TransitionBlend blend = pair.blend;
  const FloorTransform start{Vec2::Zero(), facingOffset};
  Ways ways;
  ways.straight = movedTo(start, placementsOf(blend.source));
  ways.turning = movedTo(start, placementsOf(blend.target));
  blend.params.root = RootBlend::kPlain;
  ways.plain = movedTo(start, blendTrack(blend));
  blend.params.root = RootBlend::kDifferential;
  ways.differential = movedTo(start, blendTrack(blend));
  return ways;
}

void drawWay(Svg& svg, const Axes& axes, const std::vector<FloorTransform>& way, const Style& style) {
  std::vector<Vec2> points;
  for (const FloorTransform& p : way) points.push_back(axes.at(p.translation.x(), p.translation.y()));
  svg.polyline(points, style);
}

/// The body as a bar across its facing with a nose, every few frames.
void drawBodies(Svg& svg, const Axes& axes, const std::vector<FloorTransform>& way, const Heading& offset,
                std::string_view colour) {
  for (std::size_t f = 0; f < way.size(); f += 5) {
    const FloorTransform body{way[f].translation, way[f].heading - offset};
    const auto at = [&](double side, double forward) {
      const Vec2 point = body * Vec2(side, forward);
      return axes.at(point.x(), point.y());
    };
    svg.line(at(-0.13, 0.0), at(0.13, 0.0), {.stroke = colour, .strokePixels = 3.0, .opacity = 0.75});
    svg.line(at(0.0, 0.0), at(0.0, 0.11), {.stroke = colour, .strokePixels = 2.0, .opacity = 0.75});
  }
}

/// A square in metres that holds all ways, with left (+x, seen along +z) to the left, as the walker sees it.
Axes axesAround(const Ways& ways, const PixelBox& frame, const std::string& yLabel) {
  double low = 0.0, high = 0.0, far = 0.0;
  for (const auto* way : {&ways.straight, &ways.turning, &ways.plain, &ways.differential}) {
    for (const FloorTransform& p : *way) {
      low = std::min(low, p.translation.x());
      high = std::max(high, p.translation.x());
      far = std::max(far, p.translation.y());
    }
  }
  const double side = std::max(high - low, far) + 0.5;
  const double middle = 0.5 * (low + high);
  return {frame, {middle + 0.5 * side, middle - 0.5 * side, "to the left (m)"}, {-0.25, side - 0.25, yLabel}};
}

struct Chart {
  const std::vector<FloorTransform>* way;
  Style style;
};

/// How fast each root goes across its heading, over the blend.
void drawSpeeds(Svg& svg, const PixelBox& frame, const std::vector<Chart>& charts, double framesPerSecond,
                const Heading& offset) {
  double most = 10.0;
  for (const Chart& chart : charts) {
    for (const double step : sidewaysSteps(*chart.way, offset))
      most = std::max(most, std::abs(100.0 * step * framesPerSecond));
  }
  const double seconds = static_cast<double>(charts[0].way->size() - 1) / framesPerSecond;
  const Axes axes(frame, {0.0, seconds, "time in the blend (s)"},
                  {-1.1 * most, 1.1 * most, "speed across the heading (cm/s)"});
  axes.drawGrid(svg);
  for (const Chart& chart : charts) {
    std::vector<Vec2> points;
    double time = 0.5 / framesPerSecond;
    for (const double step : sidewaysSteps(*chart.way, offset)) {
      points.push_back(axes.at(time, 100.0 * step * framesPerSecond));
      time += 1.0 / framesPerSecond;
    }
    svg.polyline(points, chart.style);
  }
  axes.drawFrame(svg);
}

Figure rootPathFigure(const MotionLibrary& library, const Pair& pair) {
  const Heading offset = library.facingOffset;
  const Ways ways = waysOf(pair, offset);
  const auto centimetres = [&](const std::vector<FloorTransform>& way) {
    return 100.0 * sidewaysSlip(way, ways.straight, ways.turning, offset);
  };
  const Style straight{.stroke = palette::kQuiet, .strokePixels = 1.4, .dashes = "2 3"};
  const Style turning{.stroke = palette::kQuiet, .strokePixels = 1.4, .dashes = "7 3"};
  const Style plain{.stroke = palette::kGoal, .strokePixels = 2.2};
  const Style differential{.stroke = palette::kBlended, .strokePixels = 2.2};
  Svg svg(70.0 + 3.0 * kPanel + 2.0 * 34.0 + 66.0, kTop + kPanel + 78.0, "Plain and differential blend");
  drawHeading(svg, {24.0, 30.0},
              fmt::format("The root through a blend of {:g} s from {} into {}", kBlendSeconds,
                          pair.straight.name, pair.turning.name));
  struct Panel {
    std::string title;
    const std::vector<FloorTransform>* way;
    const Style* style;
  };
  const Panel panels[] = {
      {fmt::format("Plain: slips {:.1f} cm sideways", centimetres(ways.plain)), &ways.plain, &plain},
      {fmt::format("Differential: slips {:.1f} cm", centimetres(ways.differential)), &ways.differential,
       &differential}};
  double left = 70.0;
  for (const Panel& panel : panels) {
    const PixelBox frame{left, kTop, left + kPanel, kTop + kPanel};
    const Axes axes = axesAround(ways, frame, &panel == &panels[0] ? "ahead (m)" : "");
    axes.drawGrid(svg);
    drawWay(svg, axes, ways.straight, straight);
    drawWay(svg, axes, ways.turning, turning);
    drawWay(svg, axes, *panel.way, *panel.style);
    drawBodies(svg, axes, *panel.way, offset, panel.style->stroke);
    axes.drawFrame(svg);
    svg.text({left, kTop - 12.0}, panel.title, {14.0, Anchor::kStart, panel.style->stroke, true});
    left += kPanel + 34.0;
  }
  left += 46.0;
  svg.text({left, kTop - 12.0}, "Across the heading", {14.0, Anchor::kStart, palette::kInk, true});
  drawSpeeds(svg, {left, kTop, left + kPanel, kTop + kPanel},
             {{&ways.straight, straight},
              {&ways.turning, turning},
              {&ways.plain, plain},
              {&ways.differential, differential}},
             library.frames.framesPerSecond, offset);
  drawLegend(svg, {70.0, svg.height() - 18.0},
             {{straight, "straight clip alone"},
              {turning, "turning clip alone"},
              {plain, "plain interpolation"},
              {differential, "differential blend"}});
  return {"root_paths",
          fmt::format(
              "From above: the root's way from a straight walk into a turn (thesis, fig. 5.7). Interpolating "
              "places pulls the body across the way it faces, {:.1f} cm farther than either clip goes by "
              "itself; blending each step's own displacement and turn, {:.1f} cm. Right: the red line leaves "
              "the range between the two clips, the violet one does not.",
              centimetres(ways.plain), centimetres(ways.differential)),
          std::move(svg)};
}

}  // namespace

std::vector<Figure> rootPathFigures(const FigureInputs& inputs) {
  const MotionLibrary& library = inputs.library();
  const auto frames =
      static_cast<std::size_t>(std::lround(kBlendSeconds * library.frames.framesPerSecond)) + 1;
  Pair pair;
  pair.blend.frames = frames;
  if (!findTurn(library, pair) || !findSource(library, pair)) return {};
  pair.blend.source.clip = &pair.straight;
  pair.blend.target.clip = &pair.turning;
  std::vector<Figure> figures;
  figures.push_back(rootPathFigure(library, pair));
  return figures;
}

}  // namespace stridegraph::figures
