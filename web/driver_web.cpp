/// The browser's driver: a WebGL 2 context, animation frames, and the functions that the page's scripts call.
/// Emscripten's GLFW port is not used here: it listens for keys on the whole window and swallows them from
/// the page, and knows neither touch nor device pixels. The scripts pass pointer and key events in instead.
#include <emscripten.h>
#include <emscripten/html5.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>

#include "app.h"
#include "graph/sgraph_file.h"
#include "motion/bvh_writer.h"
#include "motion/glb_writer.h"
#include "scene/scene_json.h"
#include "scene/scene_link.h"
#include "state/library_json.h"
#include "state/planning.h"
#include "state/state_json.h"

// clang-format off
EM_JS(void, pageShowStatus, (const char* text), { Module["page"]["showStatus"](UTF8ToString(text)); });
EM_JS(void, pageCopyText, (const char* text), { Module["page"]["copyText"](UTF8ToString(text)); });
EM_JS(void, pageSetCursor, (int cursor), { Module["page"]["setCursor"](cursor); });
EM_JS(char*, pagePasteText, (), { return allocateUTF8(Module["page"]["pasteText"]()); });
/// The pixels of a text (RGBA, to be freed), with width, height, left, ascent, advance and colouredness in `figures`;
/// null where it cannot be drawn.
EM_JS(std::uint8_t*, pageDrawText, (const char* text, double pixels, double* figures), {
  const picture = Module["page"]["drawText"](UTF8ToString(text), pixels);
  if (!picture) return 0;
  const address = _malloc(picture["pixels"].length);
  if (!address) return 0;
  HEAPU8.set(picture["pixels"], address);
  HEAPF64.set(picture["figures"], figures >> 3);
  return address;
});
// clang-format on

namespace stridegraph {

namespace {

/// What lives as long as the page does: the app, the view's size, and the latest answer to the page.
struct Page {
  std::unique_ptr<App> app;
  FrameRequest request;
  double lastMilliseconds = 0.0;
  std::string text;
  std::vector<std::uint8_t> bytes;
  Warnings sceneNotes;  ///< On the scene file that was opened last.
};

Page& page() {
  static Page instance;
  return instance;
}

const char* answer(std::string text) {
  page().text = std::move(text);
  return page().text.c_str();
}

const char* answerError(const Error& error) {
  return answer(describe(error));
}

std::optional<TextPicture> drawByPage(const std::string& text, float pixels) {
  std::array<double, 6> figures = {};
  std::uint8_t* const bytes = pageDrawText(text.c_str(), static_cast<double>(pixels), figures.data());
  if (bytes == nullptr) return {};
  TextPicture picture;
  picture.width = static_cast<int>(figures[0]);
  picture.height = static_cast<int>(figures[1]);
  picture.left = static_cast<float>(figures[2]);
  picture.ascent = static_cast<float>(figures[3]);
  picture.advance = static_cast<float>(figures[4]);
  picture.coloured = figures[5] != 0.0;
  picture.rgba.assign(bytes, bytes + static_cast<std::ptrdiff_t>(figures[0] * figures[1]) * 4);
  std::free(bytes);
  return picture;
}

AppHost browserHost() {
  AppHost host;
  host.clock = [] { return emscripten_get_now(); };
  host.showStatus = [](const std::string& text) { pageShowStatus(text.c_str()); };
  host.copyText = [](const std::string& text) { pageCopyText(text.c_str()); };
  host.pasteText = [] {
    char* text = pagePasteText();
    std::string copy(text);
    std::free(text);
    return copy;
  };
  host.drawText = drawByPage;
  host.setCursor = [last = Cursor::kArrow](Cursor cursor) mutable {
    if (cursor != last) pageSetCursor(static_cast<int>(cursor));
    last = cursor;
  };
  return host;
}

EM_BOOL onAnimationFrame(double milliseconds, void*) {
  Page& at = page();
  at.request.deltaSeconds = std::clamp((milliseconds - at.lastMilliseconds) / 1000.0, 0.0, 0.25);
  at.lastMilliseconds = milliseconds;
  at.app->frame(at.request);
  return EM_TRUE;
}

bool makeContext() {
  EmscriptenWebGLContextAttributes wanted;
  emscripten_webgl_init_context_attributes(&wanted);
  wanted.majorVersion = 2;
  wanted.alpha = EM_FALSE;
  wanted.antialias = EM_TRUE;
  wanted.powerPreference = EM_WEBGL_POWER_PREFERENCE_HIGH_PERFORMANCE;
  const EMSCRIPTEN_WEBGL_CONTEXT_HANDLE context = emscripten_webgl_create_context("#view", &wanted);
  return context > 0 && emscripten_webgl_make_context_current(context) == EMSCRIPTEN_RESULT_SUCCESS;
}

Modifiers modifiersOf(int bits) {
  return {(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0};
}

SharedScene sharedScene(const AppState& state) {
  SharedScene shared;
  shared.scene = state.scene;
  shared.search = std::string(searchName(state.settings.search));
  shared.libraryHash = state.library ? state.library->hash : 0;
  return shared;
}

}  // namespace

extern "C" {

/// Makes the app on the canvas #view. Answers an empty text, or the reason why it cannot.
EMSCRIPTEN_KEEPALIVE const char* sgStart(bool playsAtOnce, bool dark) {
  if (!makeContext()) return answer("WebGL 2 is not available.");
  Result<std::unique_ptr<App>> app = App::create(browserHost());
  if (!app) return answerError(app.error());
  page().app = std::move(*app);
  ViewOptions view = page().app->state().view;
  view.startsPlaying = playsAtOnce;
  view.dark = dark;
  page().app->run({ChangeView{view}});
  return answer("");
}

EMSCRIPTEN_KEEPALIVE void sgRun() {
  emscripten_request_animation_frame_loop(onAnimationFrame, nullptr);
}

EMSCRIPTEN_KEEPALIVE void sgSetFont(const std::uint8_t* bytes, std::size_t size) {
  page().app->setFont({bytes, bytes + size});
}

EMSCRIPTEN_KEEPALIVE const char* sgOpenLibrary(const std::uint8_t* bytes, std::size_t size) {
  const Result<void> opened = page().app->openLibrary({bytes, size});
  return opened ? answer("") : answerError(opened.error());
}

/// What the open library is made of, as JSON (state/library_json.h).
EMSCRIPTEN_KEEPALIVE const char* sgLibrary() {
  const std::shared_ptr<const MotionLibrary>& library = page().app->state().library;
  return answer(library ? toJson(*library) : "null");
}
/// The open library as an .sgraph file; an empty file without one.
EMSCRIPTEN_KEEPALIVE const std::uint8_t* sgLibraryFile() {
  const std::shared_ptr<const MotionLibrary>& library = page().app->state().library;
  page().bytes = library ? writeSgraph(*library) : std::vector<std::uint8_t>();
  return page().bytes.data();
}

/// Opens a scene from the bytes of its file.
EMSCRIPTEN_KEEPALIVE const char* sgOpenScene(const char* bytes, std::size_t size, const char* name) {
  Warnings notes;
  const Result<Scene> scene = readSceneJson({bytes, size}, name, &notes);
  if (!scene) return answerError(scene.error());
  page().sceneNotes = std::move(notes);
  page().app->openScene(*scene, std::string("Open ") + name);
  return answer("");
}
/// What was odd about the scene file that was opened last, as JSON (state/library_json.h).
EMSCRIPTEN_KEEPALIVE const char* sgSceneNotes() {
  return answer(toJson(page().sceneNotes));
}

EMSCRIPTEN_KEEPALIVE const char* sgOpenLink(const char* fragment) {
  const Result<SharedScene> shared = decodeLink(fragment);
  if (!shared) return answer(shared.error().message);
  App& app = *page().app;
  PlanSettings settings = app.state().settings;
  settings.search = searchFromName(shared->search).value_or(settings.search);
  app.run({ChangeSettings{settings}});
  app.openScene(shared->scene, "Open link");
  const bool otherLibrary =
      shared->libraryHash != 0 && app.state().library && app.state().library->hash != shared->libraryHash;
  if (otherLibrary) {
    app.run(
        {Say{"This link was made with another motion library: the room is the same, the walk may differ."}});
  }
  return answer("");
}

EMSCRIPTEN_KEEPALIVE const char* sgLink() {
  return answer(encodeLink(sharedScene(page().app->state())));
}
EMSCRIPTEN_KEEPALIVE const char* sgSceneJson() {
  return answer(writeSceneJson(page().app->state().scene));
}
/// Where a floor point appears, as JSON {x, y} in points of the canvas; null behind the eye.
EMSCRIPTEN_KEEPALIVE const char* sgPointOf(double x, double z) {
  const std::optional<Vec2> at = page().app->shownAt(Vec3(x, 0.0, z));
  return answer(at ? fmt::format("{{\"x\":{},\"y\":{}}}", at->x(), at->y()) : "null");
}

EMSCRIPTEN_KEEPALIVE const char* sgLettering() {
  const Lettering& lettering = page().app->lettering();
  return answer(letteringJson(lettering.isWaiting(), lettering.missing()));
}

EMSCRIPTEN_KEEPALIVE const char* sgState() {
  return answer(toJson(page().app->state()));
}

/// A walker's walk as BVH; an empty file where it has none.
EMSCRIPTEN_KEEPALIVE const std::uint8_t* sgWalkBvh(std::size_t walker) {
  const AppState& state = page().app->state();
  page().bytes.clear();
  const Plan* const plan = state.planOf(walker);
  if (plan != nullptr && plan->walk.frameCount() > 0) {
    const std::string text = writeBvh(state.library->skeleton, state.library->layout, plan->walk);
    page().bytes.assign(text.begin(), text.end());
  }
  return page().bytes.data();
}
/// The walks of all who have one as GLB; an empty file where nobody has.
EMSCRIPTEN_KEEPALIVE const std::uint8_t* sgWalksGlb() {
  const AppState& state = page().app->state();
  page().bytes.clear();
  std::vector<WalkerClip> walks;
  for (std::size_t walker = 0; const Plan* const plan = state.planOf(walker); ++walker)
    if (plan->walk.frameCount() > 0) walks.push_back({&plan->walk, walker});
  if (!walks.empty()) page().bytes = writeGlb(state.library->skeleton, page().app->body(), walks);
  return page().bytes.data();
}
/// Size of the file asked for last.
EMSCRIPTEN_KEEPALIVE std::size_t sgFileSize() {
  return page().bytes.size();
}

EMSCRIPTEN_KEEPALIVE void sgSay(const char* text, bool problem) {
  page().app->run({Say{text, problem}});
}

EMSCRIPTEN_KEEPALIVE void sgSetDark(bool dark) {
  ViewOptions view = page().app->state().view;
  view.dark = dark;
  page().app->run({ChangeView{view}});
}

EMSCRIPTEN_KEEPALIVE void sgResize(double width, double height, double pixelRatio) {
  page().request.viewport = {std::max(width, 1.0), std::max(height, 1.0)};
  page().request.pixelRatio = pixelRatio;
}

/// kind: 0 move, 1 press, 2 release, 3 leave; modifiers: 1 control or command, 2 shift, 4 alt.
EMSCRIPTEN_KEEPALIVE void sgPointer(int kind, double x, double y, int button, bool touch, int modifiers) {
  static constexpr InputKind kKinds[] = {InputKind::kMove, InputKind::kPress, InputKind::kRelease,
                                         InputKind::kLeave};
  InputEvent event;
  event.kind = kKinds[kind];
  event.position = Vec2(x, y);
  event.button = std::clamp(button, 0, 2);
  event.touch = touch;
  event.modifiers = modifiersOf(modifiers);
  page().app->add(event);
}

EMSCRIPTEN_KEEPALIVE void sgWheel(double x, double y, double notches, int modifiers) {
  InputEvent event;
  event.kind = InputKind::kWheel;
  event.position = Vec2(x, y);
  event.wheel = notches;
  event.modifiers = modifiersOf(modifiers);
  page().app->add(event);
}

EMSCRIPTEN_KEEPALIVE void sgPinch(double dragX, double dragY, double scale, double twistRadians) {
  InputEvent event;
  event.kind = InputKind::kPinch;
  event.drag = Vec2(dragX, dragY);
  event.scale = scale;
  event.twistRadians = twistRadians;
  page().app->add(event);
}

/// key: the position in Key (ui/input.h).
EMSCRIPTEN_KEEPALIVE void sgKey(int key, bool down, int modifiers) {
  InputEvent event;
  event.kind = down ? InputKind::kKeyDown : InputKind::kKeyUp;
  event.key = static_cast<Key>(std::clamp(key, 0, static_cast<int>(Key::kCount) - 1));
  event.modifiers = modifiersOf(modifiers);
  page().app->add(event);
}

EMSCRIPTEN_KEEPALIVE void sgText(unsigned character, int modifiers) {
  InputEvent event;
  event.kind = InputKind::kText;
  event.character = character;
  event.modifiers = modifiersOf(modifiers);
  page().app->add(event);
}

}  // extern "C"

}  // namespace stridegraph
