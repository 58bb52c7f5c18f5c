# Toolchain for WebAssembly: finds the installed Emscripten and hands over to its own toolchain file.
find_program(STRIDEGRAPH_EM_CONFIG em-config)
if(NOT STRIDEGRAPH_EM_CONFIG)
  message(FATAL_ERROR "Emscripten is not installed: em-config is not on the PATH. On Debian: apt-get install emscripten")
endif()
execute_process(
  COMMAND ${STRIDEGRAPH_EM_CONFIG} EMSCRIPTEN_ROOT
  OUTPUT_VARIABLE EMSCRIPTEN_ROOT_PATH OUTPUT_STRIP_TRAILING_WHITESPACE
  COMMAND_ERROR_IS_FATAL ANY)
include(${EMSCRIPTEN_ROOT_PATH}/cmake/Modules/Platform/Emscripten.cmake)
