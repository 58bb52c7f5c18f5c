#include <fmt/format.h>

#include <algorithm>

#include "figures/axes.h"
#include "figures/figure.h"
#include "figures/palette.h"
#include "figures/room_view.h"
#include "path/path_planner.h"
#include "path/polyline.h"
#include "path/shortest_path.h"

namespace stridegraph::figures {
namespace {

constexpr double kRoomWidth = 560.0;
constexpr double kMargin = 22.0;
constexpr double kTop = 92.0;
constexpr double kPanelGap = 14.0;
constexpr std::size_t kPictures = 2;

struct Panel {
  std::string title;
  std::string subtitle;
  PathResult result;
};

/// The rooms with the longest detours: those where planners differ.
std::vector<const Scene*> roomsToShow(const std::vector<Scene>& scenes) {
  std::vector<std::pair<double, const Scene*>> rated;
  for (const Scene& scene : scenes) {
    const auto path =
        shortestPath(FloorPlan(scene, scene.radiusMetres), scene.start.position, scene.goal.position);
    const double straight = (scene.goal.position - scene.start.position).norm();
    if (path && straight > 0.0) rated.emplace_back(path->lengthMetres / straight, &scene);
  }
  std::stable_sort(rated.begin(), rated.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<const Scene*> rooms;
  for (const auto& [detour, scene] : rated) {
    if (rooms.size() < kPictures) rooms.push_back(scene);
  }
  return rooms;
}

std::vector<Panel> panelsOf(const Scene& scene) {
  const FloorPlan floor(scene, scene.radiusMetres);
  const Vec2& start = scene.start.position;
  const Vec2& goal = scene.goal.position;
  std::vector<Panel> panels;
  for (const PlannerKind kind : {PlannerKind::kPrm, PlannerKind::kRrtConnect}) {
    PathResult raw = planPath(floor, start, goal, kind, scene.seed, {.shortcutRounds = 0});
    const PathResult cut = planPath(floor, start, goal, kind, scene.seed);
    const char* grown = kind == PlannerKind::kPrm ? "edges" : "branches";
    std::string subtitle = fmt::format("{} {}; path {:.2f} m, {:.2f} m with corners cut",
                                       raw.roadmapEdges.size(), grown, raw.lengthMetres, cut.lengthMetres);
    raw.path = cut.path;
    panels.push_back({kind == PlannerKind::kPrm ? "Roadmap (PRM)" : "Two trees (RRT-Connect)",
                      std::move(subtitle), std::move(raw)});
  }
  if (const auto shortest = shortestPath(floor, start, goal)) {
    Panel exact{"Exact shortest path", fmt::format("{:.2f} m, the yardstick", shortest->lengthMetres), {}};
    exact.result.path = shortest->points;
    panels.push_back(std::move(exact));
  }
  return panels;
}

void drawPanel(Svg& svg, const RoomView& view, const Panel& panel, bool withSubgoals) {
  view.drawRoom(svg);
  for (const auto& [from, to] : panel.result.roadmapEdges)
    svg.line(view.at(from), view.at(to), {.stroke = palette::kRoadmap, .strokePixels = 0.6});
  view.drawEnds(svg);
  svg.polyline(view.at(panel.result.path), {.stroke = palette::kPath, .strokePixels = 2.4});
  if (!withSubgoals) return;
  for (const Vec2& subgoal : subgoals(panel.result.path, PlanOptions{}.subgoalSpacingMetres))
    svg.circle(view.at(subgoal), 3.4,
               {.fill = palette::kPaper, .stroke = palette::kPath, .strokePixels = 1.6});
}

Figure pathFigure(const Scene& scene) {
  const std::vector<Panel> panels = panelsOf(scene);
  const double height = roomHeight(scene, kRoomWidth);
  Svg svg(2.0 * kMargin + static_cast<double>(panels.size()) * (kRoomWidth + kPanelGap), kTop + height + 12.0,
          "Paths through " + scene.name);
  drawHeading(svg, {kMargin, 30.0}, fmt::format("Paths through {}", scene.name));
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const double left = kMargin + static_cast<double>(i) * (kRoomWidth + kPanelGap);
    const RoomView view(scene, {left, kTop, left + kRoomWidth, kTop + height});
    svg.text({view.frame().left, kTop - 28.0}, panels[i].title, {13.0, Anchor::kStart, palette::kInk, true});
    svg.text({view.frame().left, kTop - 11.0}, panels[i].subtitle, {12.0, Anchor::kStart, palette::kQuiet});
    drawPanel(svg, view, panels[i], i == 0);
  }
  return {
      "paths_" + fileNameFrom(scene.name),
      "The disc's way from start (green) to goal (red) by three planners (thesis, figs. 4.1, 4.2, 5.8 to "
      "5.11): a roadmap of seeded places with the path and its subgoals, two trees that grow towards each "
      "other, and the exact shortest path along tangents of the grown obstacles.",
      std::move(svg)};
}

}  // namespace

std::vector<Figure> pathFigures(const FigureInputs& inputs) {
  std::vector<Figure> figures;
  for (const Scene* scene : roomsToShow(inputs.scenes)) figures.push_back(pathFigure(*scene));
  return figures;
}

}  // namespace stridegraph::figures
