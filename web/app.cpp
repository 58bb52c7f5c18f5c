#include "app.h"

#include <imgui.h>
#include <imgui_impl_opengl3.h>

#include <algorithm>

#include "graph/sgraph_file.h"
#include "state/planning.h"
#include "state/playback.h"
#include "ui/panels.h"
#include "ui/style.h"

namespace stridegraph {

namespace {

// Longer than the slowest frame, so that what has begun to move always comes to rest.
constexpr double kAwakeSeconds = 0.7;
constexpr double kLongestStepSeconds = 0.1;

/// What the panels cover (see their layouts).
Viewport withPanels(Viewport viewport) {
  const bool narrow = Layout{viewport}.narrow();
  viewport.left = narrow ? 0.0 : 252.0;
  viewport.right = narrow ? 0.0 : 256.0;
  viewport.top = 56.0;
  viewport.bottom = narrow ? 150.0 : 76.0;
  return viewport;
}

Cursor cursorOver(const Handle& handle, Tool tool) {
  if (tool != Tool::kSelect) return Cursor::kCross;
  switch (handle.kind) {
    case HandleKind::kBody:
      return Cursor::kMove;
    case HandleKind::kCorner:
    case HandleKind::kEdge:
    case HandleKind::kHeading:
    case HandleKind::kTrackPoint:
      return Cursor::kHand;
    case HandleKind::kNone:
      return Cursor::kArrow;
  }
  return Cursor::kArrow;
}

const char* pasteForImGui(void* host) {
  // ImGui keeps the pointer only until its next call.
  static std::string text;
  text = static_cast<AppHost*>(host)->pasteText();
  return text.c_str();
}

void copyForImGui(void* host, const char* text) {
  static_cast<AppHost*>(host)->copyText(text);
}

}  // namespace

Result<std::unique_ptr<App>> App::create(AppHost host) {
  Result<SceneRenderer> renderer = SceneRenderer::create();
  if (!renderer) return fail(std::move(renderer));
  std::unique_ptr<App> app(new App(std::move(host)));
  app->renderer_ = std::move(*renderer);
  return app;
}

App::App(AppHost host) : host_(std::move(host)) {
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.LogFilename = nullptr;
  io.ConfigWindowsMoveFromTitleBarOnly = true;
  io.ClipboardUserData = &host_;
  io.SetClipboardTextFn = copyForImGui;
  io.GetClipboardTextFn = pasteForImGui;
  mapKeysForImGui();
  ImGui_ImplOpenGL3_Init("#version 300 es");
  state_.scene.start.position = Vec2(2.0, 6.0);
  state_.scene.goal.position = Vec2(10.0, 6.0);
}

App::~App() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui::DestroyContext();
}

void App::setFont(std::vector<unsigned char> file) {
  fontFile_ = std::move(file);
  shown_.pixelRatio = 0.0;  // Bakes again with the next frame.
}

Result<void> App::openLibrary(std::span<const std::uint8_t> bytes) {
  Result<MotionLibrary> library = readSgraph(bytes);
  if (!library) return fail(std::move(library));
  state_.replanning.improving.reset();  // It plans with the library that goes.
  state_.replanning.better.reset();
  state_.library = std::make_shared<const MotionLibrary>(std::move(*library));
  state_.planner = std::make_unique<const WalkPlanner>(state_.library);
  body_ = roundBody(state_.library->skeleton, state_.library->frames);
  state_.plan.reset();
  wantPlan(state_);
  stayAwake(kAwakeSeconds);
  return {};
}

void App::openScene(const Scene& scene, const std::string& label) {
  run({OpenScene{label, scene}});
  wantsWholeRoom_ = true;
}

void App::add(const InputEvent& event) {
  queue_.add(event);
  stayAwake(kAwakeSeconds);
}

void App::run(const Commands& commands) {
  if (commands.empty()) return;
  applyAll(state_, commands);
  stayAwake(kAwakeSeconds);
}

std::optional<Vec2> App::shownAt(const Vec3& place) const {
  return viewOf(state_.camera.current, shown_.viewport).project(place);
}

void App::stayAwake(double seconds) {
  awakeUntil_ = std::max(awakeUntil_, state_.nowSeconds + seconds);
}

void App::beginImGui(const FrameRequest& request) {
  ImGuiIO& io = ImGui::GetIO();
  const bool otherRatio = request.pixelRatio != shown_.pixelRatio;
  if (otherRatio) lettering_.bake(fontFile_, static_cast<float>(request.pixelRatio));
  if (lettering_.drawWanted(host_.drawText) || otherRatio) {
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
  }
  if (styledDark_ != state_.view.dark) {
    applyStyle(paletteFor(state_.view.dark));
    styledDark_ = state_.view.dark;
  }
  shown_ = request;
  io.DisplaySize =
      ImVec2(static_cast<float>(request.viewport.width), static_cast<float>(request.viewport.height));
  const auto ratio = static_cast<float>(request.pixelRatio);
  io.DisplayFramebufferScale = ImVec2(ratio, ratio);
  io.DeltaTime = static_cast<float>(std::max(request.deltaSeconds, 1e-4));
  ImGui_ImplOpenGL3_NewFrame();
  ImGui::NewFrame();
}

bool App::frame(const FrameRequest& wanted) {
  FrameRequest request = wanted;
  request.viewport = withPanels(wanted.viewport);
  state_.nowSeconds += request.deltaSeconds;
  const bool resized = request.viewport != shown_.viewport || request.pixelRatio != shown_.pixelRatio;
  if (resized || !queue_.empty() || state_.playback.playing || state_.replanning.wanted ||
      state_.replanning.improving)
    stayAwake(kAwakeSeconds);
  if (state_.nowSeconds < state_.notice.untilSeconds) stayAwake(kAwakeSeconds);
  if (state_.nowSeconds > awakeUntil_) return false;
  if (wantsWholeRoom_) {
    apply(state_, ShowWholeRoom{request.viewport});
    wantsWholeRoom_ = false;
  }
  const double step = std::min(request.deltaSeconds, kLongestStepSeconds);
  const std::deque<InputEvent> events = queue_.take(input_);
  beginImGui(request);
  const CameraView before = viewOf(state_.camera.current, request.viewport);
  const InputClaims claims{ImGui::GetIO().WantCaptureMouse, ImGui::GetIO().WantTextInput};
  applyAll(state_, handleEvents(state_, viewInput_, before, events, claims));
  const Handle hovered = hoverAt(state_, viewInput_, before, input_, claims);
  advance(state_, step);
  updateWalk(step);
  followBody(step);
  if (glide(state_.camera, step)) stayAwake(kAwakeSeconds);
  const CameraView view = viewOf(state_.camera.current, request.viewport);
  showPanels(view);
  showCursor(hovered);
  drawRoom(view, request);
  ImGui::Render();
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  return true;
}

void App::showPanels(const CameraView& view) {
  const Layout layout{view.viewport};
  Commands commands;
  showOverlay(state_, view, layout, lettering_);
  showToolbar(state_, layout, lettering_, commands);
  showCameraBar(state_, layout, commands);
  showScenePanel(state_, layout, lettering_, commands);
  showReportPanel(state_, layout, lettering_, commands);
  showTimeline(state_, layout, commands);
  run(commands);
  if (lettering_.isWaiting()) stayAwake(kAwakeSeconds);
}

void App::updateWalk(double deltaSeconds) {
  if (!planWhenDue(state_, host_.clock)) improveWalk(state_, host_.clock, deltaSeconds);
  if (footprintsOfPlan_ != state_.replanning.generation) {
    footprintsOfPlan_ = state_.replanning.generation;
    footprints_.clear();
    if (state_.hasWalk()) footprints_ = footprintsOf(*state_.library, *state_.plan);
  }
  const std::string status = statusSentence(state_);
  if (status == shownStatus_) return;
  shownStatus_ = status;
  host_.showStatus(status);
}

void App::followBody(double deltaSeconds) {
  if (state_.camera.mode != CameraMode::kFollow) return;
  const std::optional<Pose> pose = shownPose(state_);
  if (!pose) return;
  // The view moves with the body; only turning and zooming glide.
  const Vec2 root = onFloor(pose->rootPosition);
  const Vec2 moved = root - state_.camera.wanted.target;
  state_.camera.wanted.target = root;
  if (moved.norm() < 4.0 * deltaSeconds + 0.2) state_.camera.current.target += moved;
}

void App::showCursor(const Handle& hovered) {
  const ImGuiIO& io = ImGui::GetIO();
  if (!io.WantCaptureMouse) {
    host_.setCursor(cursorOver(hovered, state_.tool));
    return;
  }
  switch (ImGui::GetMouseCursor()) {
    case ImGuiMouseCursor_TextInput:
      host_.setCursor(Cursor::kText);
      break;
    case ImGuiMouseCursor_ResizeEW:
      host_.setCursor(Cursor::kHorizontal);
      break;
    default:
      host_.setCursor(ImGui::IsAnyItemHovered() ? Cursor::kHand : Cursor::kArrow);
      break;
  }
}

std::vector<ShownBody> App::shownBodies() const {
  const Palette& palette = paletteFor(state_.view.dark);
  std::vector<ShownBody> bodies;
  for (std::size_t walker = 0; walker < state_.walkerCount(); ++walker) {
    const std::optional<Pose> pose = shownPose(state_, walker);
    if (!pose) break;
    const std::size_t frame = state_.shownFrame();
    const bool blended = walker == 0 && state_.view.tintBlends && state_.hasWalk() &&
                         frame < state_.plan->frameKinds.size() &&
                         state_.plan->frameKinds[frame] == EdgeKind::kTransition;
    const Colour& own = walker == 0 ? palette.body : walkerColour(palette, walker);
    bodies.push_back(
        {placeParts(body_, state_.library->skeleton, pose->view()), blended ? palette.blendedBody : own});
  }
  return bodies;
}

void App::drawRoom(const CameraView& view, const FrameRequest& request) {
  const FloorMarks marks = marksOf(state_, footprints_);
  const std::vector<ShownBody> bodies = shownBodies();
  PixelSize size;
  size.width = static_cast<int>(std::lround(request.viewport.width * request.pixelRatio));
  size.height = static_cast<int>(std::lround(request.viewport.height * request.pixelRatio));
  size.perPoint = request.pixelRatio;
  renderer_->draw({state_, view, marks, bodies, size});
}

}  // namespace stridegraph
