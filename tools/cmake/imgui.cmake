# Dear ImGui with its GLFW and OpenGL 3 backends, from source: WebAssembly needs its own build. ./run setup
# unpacks Debian's source package into STRIDEGRAPH_IMGUI_DIR; elsewhere release 1.86 is fetched.
set(STRIDEGRAPH_IMGUI_DIR ${PROJECT_SOURCE_DIR}/.cache/imgui CACHE PATH "Sources of Dear ImGui")
if(NOT EMSCRIPTEN AND NOT STRIDEGRAPH_DESKTOP)
  return() # The app alone needs it.
endif()
if(NOT EXISTS ${STRIDEGRAPH_IMGUI_DIR}/imgui.cpp)
  FetchContent_Declare(imgui GIT_REPOSITORY https://github.com/ocornut/imgui.git
    GIT_TAG 55d35d8387c15bf0cfd71861df67af8cfbda7456) # v1.86
  FetchContent_MakeAvailable(imgui)
  set(STRIDEGRAPH_IMGUI_DIR ${imgui_SOURCE_DIR})
endif()
file(STRINGS ${STRIDEGRAPH_IMGUI_DIR}/imgui.h version REGEX "define IMGUI_VERSION ")
if(NOT version MATCHES "\"1\\.86\"")
  message(FATAL_ERROR "${STRIDEGRAPH_IMGUI_DIR} holds ${version}, expected release 1.86 of Dear ImGui.")
endif()

add_library(imgui STATIC EXCLUDE_FROM_ALL
  ${STRIDEGRAPH_IMGUI_DIR}/imgui.cpp
  ${STRIDEGRAPH_IMGUI_DIR}/imgui_demo.cpp
  ${STRIDEGRAPH_IMGUI_DIR}/imgui_draw.cpp
  ${STRIDEGRAPH_IMGUI_DIR}/imgui_tables.cpp
  ${STRIDEGRAPH_IMGUI_DIR}/imgui_widgets.cpp
  ${STRIDEGRAPH_IMGUI_DIR}/backends/imgui_impl_glfw.cpp
  ${STRIDEGRAPH_IMGUI_DIR}/backends/imgui_impl_opengl3.cpp)
target_include_directories(imgui SYSTEM PUBLIC ${STRIDEGRAPH_IMGUI_DIR} ${STRIDEGRAPH_IMGUI_DIR}/backends)
target_compile_definitions(imgui PUBLIC IMGUI_DISABLE_DEMO_WINDOWS IMGUI_DISABLE_METRICS_WINDOW
                                        IMGUI_DISABLE_OBSOLETE_FUNCTIONS IMGUI_DISABLE_FILE_FUNCTIONS)
if(EMSCRIPTEN)
  target_compile_definitions(imgui PUBLIC IMGUI_IMPL_OPENGL_ES3)
  target_compile_options(imgui PRIVATE -fno-exceptions -fno-rtti)
  target_link_options(imgui PUBLIC -sUSE_GLFW=3 -sMIN_WEBGL_VERSION=2 -sMAX_WEBGL_VERSION=2)
else()
  find_package(glfw3 REQUIRED)
  target_link_libraries(imgui PUBLIC glfw)
endif()
