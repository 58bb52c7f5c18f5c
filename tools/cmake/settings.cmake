# Settings of every target of this project: warnings as errors, and the same floating point everywhere.
add_library(stridegraph_settings INTERFACE)
target_compile_options(stridegraph_settings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror -ffp-contract=off)

if(STRIDEGRAPH_SANITIZE)
  # Also numbers too large for the integer that they become: WebAssembly stops there. Without vptr: core has no
  # RTTI, so that check takes every object made there for one of no type.
  target_compile_options(stridegraph_settings INTERFACE
    -fsanitize=address,undefined,float-cast-overflow -fno-sanitize=vptr
    -fno-sanitize-recover=undefined,float-cast-overflow -fno-omit-frame-pointer)
  target_link_options(stridegraph_settings INTERFACE -fsanitize=address,undefined)
  # Indices of standard containers are looked at, too.
  target_compile_definitions(stridegraph_settings INTERFACE _GLIBCXX_ASSERTIONS)
  # GCC takes checked code for code that reads what is not set, in its own <regex> for one.
  target_compile_options(stridegraph_settings INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
endif()
if(STRIDEGRAPH_FUZZ)
  target_compile_options(stridegraph_settings INTERFACE -fsanitize=fuzzer-no-link)
endif()

if(EMSCRIPTEN)
  target_compile_options(stridegraph_settings INTERFACE -msimd128)
  # Debian's Emscripten takes acorn from Debian's Node.js modules, which a newer Node.js does not search.
  if(EXISTS /usr/share/nodejs/acorn)
    set_property(GLOBAL PROPERTY RULE_LAUNCH_LINK "${CMAKE_COMMAND} -E env NODE_PATH=/usr/share/nodejs")
  endif()
endif()
