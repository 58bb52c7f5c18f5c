#pragma once

#include "state/app_state.h"
#include "state/commands.h"

namespace stridegraph {

/// How tall obstacles are drawn. Nobody steps over them, whatever they look like.
inline constexpr double kBlockHeightMetres = 1.0;
/// Distance of a heading's handle from the middle of start or goal.
inline constexpr double kHeadingHandleMetres = 0.95;
/// Positions and sizes are rounded to this unless Alt is held.
inline constexpr double kSnapMetres = 0.1;
inline constexpr double kSmallestBlockMetres = 0.1;
inline constexpr double kSmallestRoomMetres = 2.0;
inline constexpr double kLargestRoomMetres = 500.0;

/// A pointer over the view.
struct PointerAt {
  Vec2 position = Vec2::Zero();  ///< Points from the upper left.
  bool free = false;             ///< Alt is held: no snapping.
  double reachPoints = 9.0;      ///< How near to a handle is on it; more for fingers.
};

/// What the pointer would take hold of: handles of the selection first, then starts and goals, then blocks,
/// those that move where they are now, then the chosen area. Other areas are chosen by a click, so that the
/// floor on them still turns the view.
Handle handleUnder(const AppState& state, const CameraView& view, const PointerAt& pointer);

/// The area on the floor under the pointer, the latest drawn first; nothing where there is none.
Item areaUnder(const AppState& state, const CameraView& view, const PointerAt& pointer);

/// Where the selection's handles are in the world.
struct PlacedHandle {
  Handle handle;
  Vec3 position = Vec3::Zero();
};
std::vector<PlacedHandle> handlesOf(const Scene& scene, const Item& item);

/// Begins what a press at the pointer means for the tool in hand. Without a drag the press was on empty floor
/// and belongs to the camera.
std::optional<Drag> beginDrag(const AppState& state, const CameraView& view, const PointerAt& pointer);

/// The drag's scene once the pointer has moved there.
void moveDrag(Drag& drag, const CameraView& view, const PointerAt& pointer);

/// What letting go means.
Commands finishDrag(const Drag& drag);

/// The scene with the selection moved by an amount that keeps it inside of the room.
Scene nudged(const Scene& scene, const Item& item, const Vec2& by);

/// A heading in degrees, -180..180, as fields show it.
double headingDegrees(const Placement& placement);

}  // namespace stridegraph
