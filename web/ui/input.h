#pragma once

#include <array>
#include <deque>
#include <string>

#include "math/types.h"

namespace stridegraph {

/// Keys that the app knows beside text. The order is the index into ImGui's table of keys.
enum class Key {
  kTab,
  kLeft,
  kRight,
  kUp,
  kDown,
  kHome,
  kEnd,
  kInsert,
  kDelete,
  kBackspace,
  kSpace,
  kEnter,
  kEscape,
  kA,
  kB,
  kC,
  kG,
  kS,
  kV,
  kX,
  kY,
  kZ,
  kF,
  kM,
  kW,
  kCount
};

struct Modifiers {
  bool control = false;  ///< Also Command on a Mac.
  bool shift = false;
  bool alt = false;
};

enum class InputKind { kMove, kPress, kRelease, kWheel, kKeyDown, kKeyUp, kText, kPinch, kLeave };

/// One thing that happened to the view, in points from its upper left.
struct InputEvent {
  InputKind kind = InputKind::kMove;
  Vec2 position = Vec2::Zero();
  int button = 0;            ///< 0 left, 1 right, 2 middle.
  bool touch = false;        ///< By finger rather than mouse or pen.
  double wheel = 0.0;        ///< Notches towards the user.
  Vec2 drag = Vec2::Zero();  ///< Of two fingers.
  double scale = 1.0;        ///< Of two fingers: more than 1 spreads.
  double twistRadians = 0.0;
  Key key = Key::kCount;
  unsigned character = 0;
  Modifiers modifiers = {};
};

/// What a frame sees of the input.
struct InputState {
  Vec2 pointer = Vec2::Constant(-1e6);
  std::array<bool, 3> down = {};
  bool touch = false;
  Modifiers modifiers;
};

/// Hands events to frames so that none is lost: a press and a release that arrive together are seen by two
/// frames.
class InputQueue {
 public:
  void add(const InputEvent& event) { events_.push_back(event); }
  bool empty() const { return events_.empty(); }
  /// Moves what one frame may see into ImGui and `state`; returns those events in order.
  std::deque<InputEvent> take(InputState& state);

 private:
  std::deque<InputEvent> events_;
};

/// Tells ImGui which index of its key table means what. Once, after the context exists.
void mapKeysForImGui();

}  // namespace stridegraph
