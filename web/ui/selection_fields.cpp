#include "ui/selection_fields.h"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <string>

#include "state/editor.h"
#include "state/items.h"
#include "state/track_edit.h"
#include "ui/style.h"
#include "ui/widgets.h"

namespace stridegraph {

namespace {

/// Fields for up to two numbers along x and z.
struct PairFields {
  std::array<const char*, 2> labels;
  double low;
  Vec2 high;
};

bool pairFields(const PairFields& fields, Vec2& pair) {
  bool changed = false;
  for (int axis = 0; axis < 2; ++axis) {
    const NumberField field{fields.labels[static_cast<std::size_t>(axis)], 0.1, fields.low, fields.high[axis],
                            "%.2f m"};
    changed = numberField(field, pair[axis]) || changed;
  }
  return changed;
}

bool placeFields(const Scene& scene, Vec2& place) {
  return pairFields({{"x", "z"}, 0.0, {scene.widthMetres, scene.depthMetres}}, place);
}

bool sizeFields(Vec2& size) {
  return pairFields({{"Width", "Depth"}, kSmallestBlockMetres, Vec2::Constant(kLargestRoomMetres)}, size);
}

bool wideButton(const std::string& label) {
  return ImGui::Button(label.c_str(), ImVec2(-1.0F, 0.0F));
}

/// Puts another item in the place of the chosen one, in a scene made anew, and chooses it.
void replaceBy(const Item& item, const char* label, const Scene& scene, Commands& commands) {
  commands.push_back(EditScene{label, scene});
  commands.push_back(Select{item});
}

void deleteButton(const Item& item, Commands& commands) {
  if (wideButton("Delete " + kindName(item))) commands.push_back(DeleteSelection{});
}

void rectangleFields(const AppState& state, Commands& commands) {
  Scene scene = state.scene;
  Rectangle& rectangle = *rectangleOf(scene, state.selection);
  const std::string label = "Change " + kindName(state.selection);
  const bool moved = placeFields(state.scene, rectangle.centre);
  if (sizeFields(rectangle.size) || moved) edit(scene, label.c_str(), commands);
}

void blockFields(const AppState& state, Commands& commands) {
  rectangleFields(state, commands);
  if (wideButton("Make it move")) {
    const Scene scene = withBlockMoving(state.scene, state.selection.index);
    replaceBy({ItemKind::kMoving, scene.moving.size() - 1}, "Make block move", scene, commands);
  }
  deleteButton(state.selection, commands);
}

void movingFields(const AppState& state, Commands& commands) {
  Scene scene = state.scene;
  MovingObstacle& moving = scene.moving[state.selection.index];
  double speed = trackSpeed(moving);
  if (speed > 0.0 &&
      numberField({"Speed", 0.02, kSlowestTrackSpeed, kFastestTrackSpeed, "%.2f m/s"}, speed)) {
    moving = withTrackSpeed(moving, speed);
    edit(scene, "Change speed", commands);
  }
  static constexpr std::array<const char*, 3> kRepeats = {"Begin again", "Back and forth", "Once"};
  if (choiceField("Way", moving.repeat, kRepeats)) commands.push_back(EditScene{"Change way", scene});
  if (sizeFields(moving.size)) edit(scene, "Change moving block", commands);
  if (wideButton("Make it stand")) {
    const Scene still = withBlockStanding(state.scene, state.selection.index);
    replaceBy({ItemKind::kObstacle, still.obstacles.size() - 1}, "Make block stand", still, commands);
  }
  deleteButton(state.selection, commands);
}

void areaFields(const AppState& state, Commands& commands) {
  Scene scene = state.scene;
  AreaKind& kind = scene.constraints.areas[state.selection.index].kind;
  static constexpr std::array<const char*, 2> kKinds = {"Avoid", "Prefer"};
  if (choiceField("Walks", kind, kKinds)) commands.push_back(EditScene{"Change area", scene});
  rectangleFields(state, commands);
  deleteButton(state.selection, commands);
}

void placementFields(const AppState& state, Commands& commands) {
  const Item& item = state.selection;
  const std::string label = "Change " + kindName(item);
  Scene scene = state.scene;
  if (placeFields(state.scene, placementOf(scene, item)->position)) edit(scene, label.c_str(), commands);
  scene = state.scene;
  Placement& placement = *placementOf(scene, item);
  bool faces = placement.heading.has_value();
  if (ImGui::Checkbox("Face a direction", &faces)) {
    placement.heading = faces ? std::optional(Angle()) : std::nullopt;
    commands.push_back(EditScene{label, scene});
  }
  double degrees = headingDegrees(placement);
  if (placement.heading && numberField({"Heading", 1.0, -180.0, 180.0, "%.0f\xc2\xb0"}, degrees)) {
    placement.heading = Angle::degrees(degrees);
    edit(scene, "Turn heading", commands);
  }
  if (isRemovable(state.scene, item)) deleteButton(item, commands);
}

std::string titleOf(const AppState& state) {
  const Scene& scene = state.scene;
  const Item& item = state.selection;
  const auto counted = [&](std::string_view name, std::size_t count) {
    return fmt::format("{} {} of {}", name, item.index + 1, count);
  };
  switch (item.kind) {
    case ItemKind::kObstacle:
      return counted("Block", scene.obstacles.size());
    case ItemKind::kMoving:
      return counted("Moving block", scene.moving.size());
    case ItemKind::kArea:
      return counted("Area", scene.constraints.areas.size());
    case ItemKind::kStart:
    case ItemKind::kGoal: {
      const std::string end = item.kind == ItemKind::kStart ? "Start" : "Goal";
      return scene.walkers.empty() ? end : fmt::format("{} of walker {}", end, item.index + 1);
    }
    case ItemKind::kNothing:
      break;
  }
  return "Nothing is chosen";
}

/// What to do with a drawing tool; empty for selecting.
const char* hintFor(Tool tool) {
  switch (tool) {
    case Tool::kBlock:
      return "Drag over the floor to draw a block.";
    case Tool::kMoving:
      return "Drag from where the block is to where it goes; it moves back and forth.";
    case Tool::kArea:
      return "Drag over the floor to draw an area that walks avoid.";
    case Tool::kStart:
    case Tool::kGoal:
      return "Click on the floor; drag to choose the direction.";
    case Tool::kWalker:
      return "Drag from where the walker starts to where it goes.";
    case Tool::kSelect:
      break;
  }
  return "";
}

void quietText(const char* text, const Palette& palette) {
  ImGui::PushTextWrapPos(0.0F);
  ImGui::TextColored(asImVec4(palette.quietText), "%s", text);
  ImGui::PopTextWrapPos();
}

}  // namespace

void edit(const Scene& scene, const char* label, Commands& commands) {
  const std::string key = fmt::format("{} {}", label, ImGui::GetIO().MouseClickedTime[0]);
  commands.push_back(EditScene{label, scene, key});
}

void showSelectionFields(const AppState& state, Commands& commands) {
  const Palette& palette = paletteFor(state.view.dark);
  const bool chosen = isThere(state.scene, state.selection);
  if (chosen || state.tool == Tool::kSelect) heading(titleOf(state).c_str(), palette);
  if (state.tool != Tool::kSelect) {
    if (!chosen) heading("Draw", palette);
    quietText(hintFor(state.tool), palette);
  } else if (!chosen) {
    quietText(
        "Draw blocks with B, drag start and goal where you like. M draws a block that moves, W adds a "
        "walker.",
        palette);
  }
  if (!chosen) return;
  switch (state.selection.kind) {
    case ItemKind::kObstacle:
      return blockFields(state, commands);
    case ItemKind::kMoving:
      return movingFields(state, commands);
    case ItemKind::kArea:
      return areaFields(state, commands);
    case ItemKind::kStart:
    case ItemKind::kGoal:
      return placementFields(state, commands);
    case ItemKind::kNothing:
      break;
  }
}

}  // namespace stridegraph
