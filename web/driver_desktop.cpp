/// The desktop's driver: a GLFW window with an OpenGL ES 3 context, for work on the app without a browser.
/// Usage: stridegraph_desktop LIBRARY.sgraph [SCENE.json]
#include <GLES3/gl3.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "app.h"
#include "scene/scene_json.h"

namespace stridegraph {

namespace {

struct KeyPair {
  int glfw;
  Key key;
};
constexpr std::array<KeyPair, 25> kKeys = {{
    {GLFW_KEY_TAB, Key::kTab},       {GLFW_KEY_LEFT, Key::kLeft},
    {GLFW_KEY_RIGHT, Key::kRight},   {GLFW_KEY_UP, Key::kUp},
    {GLFW_KEY_DOWN, Key::kDown},     {GLFW_KEY_HOME, Key::kHome},
    {GLFW_KEY_END, Key::kEnd},       {GLFW_KEY_INSERT, Key::kInsert},
    {GLFW_KEY_DELETE, Key::kDelete}, {GLFW_KEY_BACKSPACE, Key::kBackspace},
    {GLFW_KEY_SPACE, Key::kSpace},   {GLFW_KEY_ENTER, Key::kEnter},
    {GLFW_KEY_ESCAPE, Key::kEscape}, {GLFW_KEY_A, Key::kA},
    {GLFW_KEY_B, Key::kB},           {GLFW_KEY_C, Key::kC},
    {GLFW_KEY_G, Key::kG},           {GLFW_KEY_S, Key::kS},
    {GLFW_KEY_V, Key::kV},           {GLFW_KEY_X, Key::kX},
    {GLFW_KEY_Y, Key::kY},           {GLFW_KEY_Z, Key::kZ},
    {GLFW_KEY_F, Key::kF},           {GLFW_KEY_M, Key::kM},
    {GLFW_KEY_W, Key::kW},
}};

App& appOf(GLFWwindow* window) {
  return *static_cast<App*>(glfwGetWindowUserPointer(window));
}

Modifiers modifiersOf(int bits) {
  return {(bits & (GLFW_MOD_CONTROL | GLFW_MOD_SUPER)) != 0, (bits & GLFW_MOD_SHIFT) != 0,
          (bits & GLFW_MOD_ALT) != 0};
}

Modifiers heldModifiers(GLFWwindow* window) {
  const auto held = [window](int key) { return glfwGetKey(window, key) == GLFW_PRESS; };
  return {held(GLFW_KEY_LEFT_CONTROL) || held(GLFW_KEY_RIGHT_CONTROL),
          held(GLFW_KEY_LEFT_SHIFT) || held(GLFW_KEY_RIGHT_SHIFT), held(GLFW_KEY_LEFT_ALT)};
}

InputEvent eventAt(GLFWwindow* window, InputKind kind) {
  InputEvent event;
  event.kind = kind;
  glfwGetCursorPos(window, &event.position.x(), &event.position.y());
  event.modifiers = heldModifiers(window);
  return event;
}

void listen(GLFWwindow* window) {
  glfwSetCursorPosCallback(
      window, [](GLFWwindow* from, double, double) { appOf(from).add(eventAt(from, InputKind::kMove)); });
  glfwSetMouseButtonCallback(window, [](GLFWwindow* from, int button, int action, int modifiers) {
    if (button > GLFW_MOUSE_BUTTON_MIDDLE) return;
    InputEvent event = eventAt(from, action == GLFW_PRESS ? InputKind::kPress : InputKind::kRelease);
    event.button = button;
    event.modifiers = modifiersOf(modifiers);
    appOf(from).add(event);
  });
  glfwSetScrollCallback(window, [](GLFWwindow* from, double, double notches) {
    InputEvent event = eventAt(from, InputKind::kWheel);
    event.wheel = -notches;
    appOf(from).add(event);
  });
  glfwSetKeyCallback(window, [](GLFWwindow* from, int key, int, int action, int modifiers) {
    for (const KeyPair& pair : kKeys) {
      if (pair.glfw != key) continue;
      InputEvent event = eventAt(from, action == GLFW_RELEASE ? InputKind::kKeyUp : InputKind::kKeyDown);
      event.key = pair.key;
      event.modifiers = modifiersOf(modifiers);
      appOf(from).add(event);
    }
  });
  glfwSetCharCallback(window, [](GLFWwindow* from, unsigned character) {
    InputEvent event = eventAt(from, InputKind::kText);
    event.character = character;
    appOf(from).add(event);
  });
}

AppHost desktopHost(GLFWwindow* window) {
  AppHost host;
  host.clock = [] { return glfwGetTime() * 1000.0; };
  host.showStatus = [window](const std::string& text) {
    glfwSetWindowTitle(window, ("Stridegraph: " + text).c_str());
  };
  host.copyText = [window](const std::string& text) { glfwSetClipboardString(window, text.c_str()); };
  host.pasteText = [window] {
    const char* text = glfwGetClipboardString(window);
    return std::string(text ? text : "");
  };
  host.setCursor = [](Cursor) {};
  return host;
}

std::vector<unsigned char> bytesOf(const char* path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

int complain(const std::string& sentence) {
  std::fprintf(stderr, "%s\n", sentence.c_str());
  return 2;
}

GLFWwindow* openWindow() {
  glfwWindowHint(GLFW_CLIENT_API, GLFW_OPENGL_ES_API);
  glfwWindowHint(GLFW_CONTEXT_CREATION_API, GLFW_EGL_CONTEXT_API);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 0);
  glfwWindowHint(GLFW_SAMPLES, 4);
  GLFWwindow* window = glfwCreateWindow(1280, 800, "Stridegraph", nullptr, nullptr);
  if (window) glfwMakeContextCurrent(window);
  return window;
}

int runWindow(GLFWwindow* window, int argc, char** argv) {
  Result<std::unique_ptr<App>> made = App::create(desktopHost(window));
  if (!made) return complain(describe(made.error()));
  App& app = **made;
  const std::vector<unsigned char> library = bytesOf(argv[1]);
  if (const Result<void> opened = app.openLibrary(library); !opened)
    return complain(describe(opened.error()));
  if (argc > 2) {
    const std::vector<unsigned char> text = bytesOf(argv[2]);
    const Result<Scene> scene = readSceneJson(std::string(text.begin(), text.end()), argv[2]);
    if (!scene) return complain(describe(scene.error()));
    app.openScene(*scene, "Open scene");
  }
  glfwSetWindowUserPointer(window, &app);
  listen(window);
  double last = glfwGetTime();
  while (!glfwWindowShouldClose(window)) {
    glfwPollEvents();
    int width = 0, height = 0, pixels = 0;
    glfwGetWindowSize(window, &width, &height);
    glfwGetFramebufferSize(window, &pixels, nullptr);
    const double now = glfwGetTime();
    FrameRequest request;
    request.viewport.width = std::max(width, 1);
    request.viewport.height = std::max(height, 1);
    request.pixelRatio = static_cast<double>(std::max(pixels, 1)) / std::max(width, 1);
    request.deltaSeconds = now - last;
    last = now;
    if (app.frame(request)) {
      glfwSwapBuffers(window);
    } else {
      glfwWaitEventsTimeout(0.05);
    }
  }
  return 0;
}

}  // namespace

}  // namespace stridegraph

int main(int argc, char** argv) {
  if (argc < 2 || argc > 3)
    return stridegraph::complain("usage: stridegraph_desktop LIBRARY.sgraph [SCENE.json]");
  if (!glfwInit()) return stridegraph::complain("There is no display to open a window on.");
  GLFWwindow* window = stridegraph::openWindow();
  const int code = window ? stridegraph::runWindow(window, argc, argv)
                          : stridegraph::complain("There is no OpenGL ES 3 here.");
  glfwTerminate();
  return code;
}
