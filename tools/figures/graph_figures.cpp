#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "figures/axes.h"
#include "figures/figure.h"
#include "figures/palette.h"
#include "graph/graph_building.h"
#include "graph/region_transitions.h"

namespace stridegraph::figures {
namespace {

constexpr double kNamePixels = 216.0;
constexpr double kPanel = 560.0;
constexpr double kGap = 30.0;
constexpr double kRow = 17.0;
constexpr double kTop = 96.0;
constexpr double kBarPixels = 5.0;
constexpr std::size_t kMostArcs = 320;

/// The graph as it was before pruning: a library keeps all the regions that were found. Among them are those
/// that cross a slip of a captured joint, which building leaves out.
MotionGraph unprunedGraph(const MotionLibrary& library) {
  std::vector<std::uint32_t> counts;
  for (const LibraryClip& clip : library.clips) counts.push_back(clip.frameCount);
  return buildGraph(counts, transitionsOf(library.regions));
}

/// Where frames lie in a panel: a row for each clip, time to the right.
class Rows {
 public:
  Rows(const MotionLibrary& library, double left, double secondsShown)
      : library_(&library),
        left_(left),
        pixelsPerFrame_(kPanel / (secondsShown * library.frames.framesPerSecond)) {}

  Vec2 at(FrameIndex frame) const {
    std::size_t row = 0;
    while (row + 1 < library_->clips.size() && library_->clips[row + 1].firstFrame <= frame.value) ++row;
    const double x = static_cast<double>(frame.value - library_->clips[row].firstFrame) * pixelsPerFrame_;
    return {left_ + x, middleOf(row)};
  }
  static double middleOf(std::size_t row) { return kTop + kRow * (static_cast<double>(row) + 0.5); }

 private:
  const MotionLibrary* library_;
  double left_;
  double pixelsPerFrame_;
};

void drawBars(Svg& svg, const MotionLibrary& library, const Rows& rows, const MotionGraph& graph) {
  for (const LibraryClip& clip : library.clips) {
    const Vec2 from = rows.at(FrameIndex(std::size_t{clip.firstFrame}));
    const Vec2 to = rows.at(FrameIndex(std::size_t{clip.firstFrame} + clip.frameCount - 1));
    svg.rectangle({from.x(), from.y() - 1.0, to.x(), to.y() + 1.0}, {.fill = palette::kFaint});
  }
  for (const MotionEdge& edge : graph.edges) {
    if (edge.kind != EdgeKind::kClipPiece) continue;
    const Vec2 from = rows.at(graph.nodes[edge.from.value]);
    const Vec2 to = rows.at(graph.nodes[edge.to.value]);
    svg.rectangle({from.x(), from.y() - 0.5 * kBarPixels, to.x(), to.y() + 0.5 * kBarPixels},
                  {.fill = palette::kCaptured, .opacity = 0.45});
  }
  std::string ticks;
  for (const FrameIndex node : graph.nodes) {
    const Vec2 at = rows.at(node);
    ticks += fmt::format("M{},{}v{}", pixels(at.x()), pixels(at.y() - 0.5 * kBarPixels), pixels(kBarPixels));
  }
  svg.path(ticks, {rows.at(graph.nodes.front()).x(), kTop, rows.at(graph.nodes.front()).x() + 1.0, kTop},
           {.stroke = palette::kInk, .strokePixels = 0.7});
}

/// Evenly chosen transitions, as arcs that bulge to the right of their direction.
void drawArcs(Svg& svg, const Rows& rows, const MotionGraph& graph) {
  std::vector<const MotionEdge*> transitions;
  for (const MotionEdge& edge : graph.edges) {
    if (edge.kind == EdgeKind::kTransition) transitions.push_back(&edge);
  }
  const std::size_t shown = std::min(kMostArcs, transitions.size());
  for (std::size_t i = 0; i < shown; ++i) {
    const MotionEdge& edge = *transitions[i * transitions.size() / shown];
    const Vec2 from = rows.at(graph.nodes[edge.from.value]);
    const Vec2 to = rows.at(graph.nodes[edge.to.value]);
    const Vec2 way = to - from;
    const Vec2 bend = 0.5 * (from + to) + 0.18 * Vec2(way.y(), -way.x());
    svg.path(fmt::format("M{},{}Q{},{} {},{}", pixels(from.x()), pixels(from.y()), pixels(bend.x()),
                         pixels(bend.y()), pixels(to.x()), pixels(to.y())),
             {std::min(from.x(), to.x()), std::min(from.y(), to.y()), std::max(from.x(), to.x()),
              std::max(from.y(), to.y())},
             {.stroke = palette::kBlended, .strokePixels = 0.8, .opacity = 0.32});
  }
}

std::string countsOf(const MotionGraph& graph) {
  return fmt::format("{} nodes, {} clip pieces, {} transitions", graph.nodes.size(), graph.clipPieceCount(),
                     graph.transitionCount());
}

}  // namespace

std::vector<Figure> graphFigures(const FigureInputs& inputs) {
  const MotionLibrary& library = inputs.library();
  const MotionGraph before = unprunedGraph(library);
  const MotionGraph* graphs[] = {&before, &library.graph};
  const std::string titles[] = {"Before pruning", "After pruning"};
  std::uint32_t longest = 1;
  for (const LibraryClip& clip : library.clips) longest = std::max(longest, clip.frameCount);
  const double seconds = static_cast<double>(longest) / library.frames.framesPerSecond;
  const double rowsPixels = kRow * static_cast<double>(library.clips.size());
  Svg svg(kNamePixels + 2.0 * kPanel + kGap + 24.0, kTop + rowsPixels + 84.0, "Motion graph");
  drawHeading(svg, {24.0, 30.0}, "Motion graph: nodes are frames, edges are pieces of clips and transitions");
  for (std::size_t c = 0; c < library.clips.size(); ++c)
    svg.text({kNamePixels - 10.0, Rows::middleOf(c) + 4.0}, library.clips[c].name,
             {11.0, Anchor::kEnd, palette::kInk});
  for (std::size_t panel = 0; panel < 2; ++panel) {
    const double left = kNamePixels + static_cast<double>(panel) * (kPanel + kGap);
    svg.text({left, kTop - 28.0}, titles[panel], {13.0, Anchor::kStart, palette::kInk, true});
    svg.text({left, kTop - 11.0}, countsOf(*graphs[panel]), {12.0, Anchor::kStart, palette::kQuiet});
    const PixelBox frame{left, kTop, left + kPanel, kTop + rowsPixels};
    const Rows rows(library, left, seconds);
    svg.beginClip({left - 1.0, kTop - 1.0, left + kPanel + 1.0, kTop + rowsPixels + 1.0});
    drawArcs(svg, rows, *graphs[panel]);
    drawBars(svg, library, rows, *graphs[panel]);
    svg.endClip();
    Axes(frame, {0.0, seconds, "time in the clip (s)"}, {0.0, 1.0, ""}).drawFrame(svg);
  }
  drawLegend(svg, {kNamePixels, svg.height() - 18.0},
             {{{.fill = palette::kCaptured, .opacity = 0.45}, "clip piece in the graph"},
              {{.fill = palette::kFaint}, "outside of it"},
              {{.stroke = palette::kInk, .strokePixels = 1.0}, "node"},
              {{.stroke = palette::kBlended},
               fmt::format("transition (at most {} of each graph shown)", kMostArcs)}});
  std::vector<Figure> figures;
  figures.push_back({"motion_graph",
                     fmt::format("Each row is a clip. Before pruning: {}. After it, only the largest part is "
                                 "left in which every node can be reached from every other, so that no walk "
                                 "ever dies: {}. The ends of clips fall away, since nothing leads into their "
                                 "first frames or out of their last ones.",
                                 countsOf(before), countsOf(library.graph)),
                     std::move(svg)});
  return figures;
}

}  // namespace stridegraph::figures
