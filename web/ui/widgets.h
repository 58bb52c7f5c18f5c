#pragma once

#include <imgui.h>

#include <span>
#include <string>

#include "render/palette.h"

namespace stridegraph {

enum class Icon {
  kSelect,
  kBlock,
  kMoving,
  kArea,
  kStart,
  kGoal,
  kWalker,
  kUndo,
  kRedo,
  kDelete,
  kPlay,
  kPause,
  kToStart,
  kStepBack,
  kStepOn,
  kLoop,
  kOrbit,
  kFollow,
  kTop,
  kWhole
};

/// Draws an icon of lines into a square.
void drawIcon(ImDrawList& list, Icon icon, ImVec2 middle, float size, ImU32 colour);

struct IconButton {
  Icon icon;
  const char* id;       ///< Unique within the window.
  const char* tooltip;  ///< What it does, and its key.
  bool chosen = false;
  bool enabled = true;
  const char* label = nullptr;  ///< Beside the icon.
};
/// Returns whether it was pressed.
bool iconButton(const IconButton& button, const Palette& palette);

/// A quiet heading within a panel.
void heading(const char* text, const Palette& palette);

/// A heading that opens and closes what is below it; returns whether it is open.
bool section(const char* text, bool openAtFirst, const Palette& palette);

/// A name on the left, its value on the right.
void figure(const char* name, const std::string& value, const Palette& palette);

/// The same, to be clicked on. Returns whether it was.
bool figureLink(const char* name, const std::string& value, const char* tooltip, const Palette& palette);

struct NumberField {
  const char* label;
  double step;
  double low, high;
  const char* format = "%.2f";
};
/// A choice of few names, the label on the left; returns the chosen one's index.
int choiceOf(const char* label, int current, std::span<const char* const> names);

/// The same for an enumeration whose values are named in order. True when another is chosen.
template <typename Choice>
bool choiceField(const char* label, Choice& chosen, std::span<const char* const> names) {
  const Choice before = chosen;
  chosen = static_cast<Choice>(choiceOf(label, static_cast<int>(before), names));
  return chosen != before;
}

/// A number to drag, or to type after a double click; the label stands on the left. True while it changes.
bool numberField(const NumberField& field, double& value);

}  // namespace stridegraph
