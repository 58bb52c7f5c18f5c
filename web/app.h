#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/clock.h"
#include "render/scene_renderer.h"
#include "state/app_state.h"
#include "state/commands.h"
#include "ui/input.h"
#include "ui/lettering.h"
#include "ui/view_input.h"

namespace stridegraph {

enum class Cursor { kArrow, kHand, kMove, kCross, kText, kHorizontal, kVertical, kDiagonalUp, kDiagonalDown };

/// What the app needs from the browser or the desktop.
struct AppHost {
  MillisecondClock clock;
  std::function<void(const std::string&)> showStatus;  ///< The plan's sentence, whenever it changes.
  std::function<void(const std::string&)> copyText;
  std::function<std::string()> pasteText;
  std::function<void(Cursor)> setCursor;
  DrawText drawText;  ///< May be empty: text beyond the font is then shown as question marks.
};

/// One frame as the driver wants it.
struct FrameRequest {
  Viewport viewport;        ///< Points.
  double pixelRatio = 1.0;  ///< Device pixels in a point.
  double deltaSeconds = 0.0;
};

/// The whole app between two drivers: events in, frames out. Needs a current OpenGL ES 3 context from
/// create() to its end.
class App {
 public:
  static Result<std::unique_ptr<App>> create(AppHost host);
  App(const App&) = delete;
  App& operator=(const App&) = delete;
  ~App();

  /// Takes a TrueType or OpenType font for all text.
  void setFont(std::vector<unsigned char> file);
  Result<void> openLibrary(std::span<const std::uint8_t> bytes);
  /// Shows another scene and looks at all of it.
  void openScene(const Scene& scene, const std::string& label);

  void add(const InputEvent& event);
  void run(const Commands& commands);
  /// Draws if anything may have changed; returns whether it drew.
  bool frame(const FrameRequest& request);

  const AppState& state() const { return state_; }
  /// What the library's skeleton wears.
  const RoundBody& body() const { return body_; }
  const Lettering& lettering() const { return lettering_; }
  /// Where a place of the room is on screen, in points; empty behind the eye.
  std::optional<Vec2> shownAt(const Vec3& place) const;

 private:
  explicit App(AppHost host);

  void beginImGui(const FrameRequest& request);
  void showPanels(const CameraView& view);
  std::vector<ShownBody> shownBodies() const;
  void drawRoom(const CameraView& view, const FrameRequest& request);
  void updateWalk(double deltaSeconds);
  void followBody(double deltaSeconds);
  void showCursor(const Handle& hovered);
  void stayAwake(double seconds);

  AppHost host_;
  AppState state_;
  std::optional<SceneRenderer> renderer_;
  InputQueue queue_;
  InputState input_;
  ViewInput viewInput_;
  std::vector<unsigned char> fontFile_;
  Lettering lettering_;
  FrameRequest shown_;
  RoundBody body_;
  std::vector<Footprint> footprints_;
  unsigned footprintsOfPlan_ = 0;
  std::string shownStatus_;
  std::optional<bool> styledDark_;
  bool wantsWholeRoom_ = true;
  double awakeUntil_ = 1.0;
};

}  // namespace stridegraph
