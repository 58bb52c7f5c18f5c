# Third-party code. Everything that core needs is header-only, so that one rule serves native programs and
# WebAssembly: the installed package if there is one, else a release archive pinned by its hash, else an error
# that says what to install. THIRD_PARTY.md says what each is for.
include(FetchContent)
set(FETCHCONTENT_QUIET ON)

# Emscripten must never see the machine's include folder as a whole: a folder of links holds what it may see.
set(STRIDEGRAPH_LINKED_HEADERS ${CMAKE_BINARY_DIR}/linked_headers)

# stridegraph_headers(TARGET HEADER <file> PACKAGE <of Debian> HOME <address> [SUFFIX <folder under include>]
#                     [URL <archive> SHA256 <hash> [SUBFOLDER <of the archive that holds the headers>]])
# makes TARGET, an interface with the folder in which `#include <HEADER>` is found.
function(stridegraph_headers target)
  cmake_parse_arguments(DEP "" "HEADER;PACKAGE;HOME;SUFFIX;URL;SHA256;SUBFOLDER" "" ${ARGN})
  string(MAKE_C_IDENTIFIER ${target} id)
  find_path(${id}_INCLUDE ${DEP_HEADER} PATH_SUFFIXES ${DEP_SUFFIX}
            PATHS /usr/local/include /usr/include /opt/homebrew/include NO_CMAKE_FIND_ROOT_PATH)
  mark_as_advanced(${id}_INCLUDE)
  if(${id}_INCLUDE AND (DEP_SUFFIX OR NOT EMSCRIPTEN))
    set(folder ${${id}_INCLUDE})
  elseif(${id}_INCLUDE)
    string(REGEX REPLACE "/.*" "" entry ${DEP_HEADER})
    file(MAKE_DIRECTORY ${STRIDEGRAPH_LINKED_HEADERS})
    file(CREATE_LINK ${${id}_INCLUDE}/${entry} ${STRIDEGRAPH_LINKED_HEADERS}/${entry} SYMBOLIC)
    set(folder ${STRIDEGRAPH_LINKED_HEADERS})
  elseif(DEP_URL)
    # No SOURCE_SUBDIR of that name exists: the archive is unpacked, its own build is left alone.
    FetchContent_Declare(${id} URL ${DEP_URL} URL_HASH SHA256=${DEP_SHA256} SOURCE_SUBDIR headers-only
                         DOWNLOAD_EXTRACT_TIMESTAMP ON)
    FetchContent_MakeAvailable(${id})
    string(TOLOWER ${id} lower)
    set(folder ${${lower}_SOURCE_DIR}/${DEP_SUBFOLDER})
  else()
    message(FATAL_ERROR "${DEP_HEADER} is not installed. On Debian: apt-get install ${DEP_PACKAGE}; "
                        "elsewhere from ${DEP_HOME}, with its folder in CMAKE_PREFIX_PATH.")
  endif()
  add_library(${id} INTERFACE)
  target_include_directories(${id} SYSTEM INTERFACE ${folder})
  if(NOT TARGET ${target})
    add_library(${target} ALIAS ${id})
  endif()
endfunction()

stridegraph_headers(Eigen3::Eigen HEADER Eigen/Core SUFFIX eigen3 PACKAGE libeigen3-dev
  HOME https://eigen.tuxfamily.org
  URL https://gitlab.com/libeigen/eigen/-/archive/3.4.0/eigen-3.4.0.tar.bz2
  SHA256 b4c198460eba6f28d34894e3a5710998818515104d6e74e5cc331ce31e46e626)
stridegraph_headers(tl::expected HEADER tl/expected.hpp PACKAGE libexpected-dev
  HOME https://github.com/TartanLlama/expected
  URL https://github.com/TartanLlama/expected/archive/refs/tags/v1.0.0.tar.gz
  SHA256 8f5124085a124113e75e3890b4e923e3a4de5b26a973b891b3deb40e19c03cee SUBFOLDER include)
stridegraph_headers(fmt::fmt-header-only HEADER fmt/core.h PACKAGE libfmt-dev
  HOME https://github.com/fmtlib/fmt
  URL https://github.com/fmtlib/fmt/archive/9.1.0.tar.gz
  SHA256 5dea48d1fcddc3ec571ce2058e13910a0d4a6bab4cc09a809d8b1dd1c88ae6f2 SUBFOLDER include)
target_compile_definitions(fmt__fmt_header_only INTERFACE FMT_HEADER_ONLY=1)
stridegraph_headers(nlohmann_json::nlohmann_json HEADER nlohmann/json.hpp PACKAGE nlohmann-json3-dev
  HOME https://github.com/nlohmann/json
  URL https://github.com/nlohmann/json/archive/v3.11.2.tar.gz
  SHA256 d69f9deb6a75e2580465c6c4c5111b89c4dc2fa94e3a85fcd2ffcd9a143d9273 SUBFOLDER include)
stridegraph_headers(FastFloat::fast_float HEADER fast_float/fast_float.h PACKAGE libfast-float-dev
  HOME https://github.com/fastfloat/fast_float
  URL https://github.com/fastfloat/fast_float/archive/v3.9.0.tar.gz
  SHA256 a10443e13748291709b422b2da49fc6753a1a43bf24205d4600595dfe3d811bb SUBFOLDER include)
stridegraph_headers(flatbuffers::flatbuffers HEADER flatbuffers/flatbuffers.h PACKAGE libflatbuffers-dev
  HOME https://github.com/google/flatbuffers
  URL https://github.com/google/flatbuffers/archive/v2.0.8.tar.gz
  SHA256 f97965a727d26386afaefff950badef2db3ab6af9afe23ed6d94bfb65f95f37e SUBFOLDER include)
stridegraph_headers(tinygltf::tinygltf HEADER tiny_gltf.h PACKAGE libtinygltf-dev
  HOME https://github.com/syoyo/tinygltf
  URL https://github.com/syoyo/tinygltf/archive/v2.8.23.tar.gz
  SHA256 e6dbbb0952cdefa1d9c87a99b686d1e67755fd9b0a5872b4008d042159e77de5)
if(NOT EMSCRIPTEN)
  # The archive of tinygltf brings its own copy.
  stridegraph_headers(stb::image_write HEADER stb_image_write.h SUFFIX stb PACKAGE libstb-dev
    HOME https://github.com/nothings/stb
    URL https://github.com/syoyo/tinygltf/archive/v2.8.23.tar.gz
    SHA256 e6dbbb0952cdefa1d9c87a99b686d1e67755fd9b0a5872b4008d042159e77de5)
  stridegraph_headers(CLI11::CLI11 HEADER CLI/CLI.hpp PACKAGE libcli11-dev
    HOME https://github.com/CLIUtils/CLI11
    URL https://github.com/CLIUtils/CLI11/archive/v2.1.2.tar.gz
    SHA256 26291377e892ba0e5b4972cdfd4a2ab3bf53af8dac1f4ea8fe0d1376b625c8cb SUBFOLDER include)
endif()

# The compiler of FlatBuffers' schemas has to run on the building machine, of the same version as the headers.
find_program(STRIDEGRAPH_FLATC flatc)
if(NOT STRIDEGRAPH_FLATC)
  message(FATAL_ERROR "flatc is not installed. On Debian: apt-get install flatbuffers-compiler; "
                      "elsewhere from https://github.com/google/flatbuffers, of the headers' version.")
endif()

# GoogleTest is the one dependency with code of its own to build.
if(STRIDEGRAPH_TESTS AND NOT EMSCRIPTEN)
  find_package(GTest QUIET)
  if(NOT GTest_FOUND)
    FetchContent_Declare(googletest URL https://github.com/google/googletest/archive/release-1.12.1.tar.gz
      URL_HASH SHA256=81964fe578e9bd7c94dfdb09c8e4d6e6759e19967e397dbea48d1c10e45d0df2
      DOWNLOAD_EXTRACT_TIMESTAMP ON)
    FetchContent_MakeAvailable(googletest)
  endif()
endif()
