# shellcheck shell=bash
# Builds programs, the default library, the module and the page. Sourced by ./run.

# configure PRESET: only where the build tree is not there yet; afterwards ninja sees to it.
configure() {
  local tree=build/$1
  [ "$1" != wasm ] || tree=build/wasm-release
  [ -f "$tree/build.ninja" ] || cmake --preset "$1" --log-level=WARNING >/dev/null
}

# buildTree PRESET TARGET...: quiet when nothing is to be done.
buildTree() {
  local preset=$1
  shift
  configure "$preset"
  cmake --build --preset "$preset" --target "$@" -- --quiet
}

buildPrograms() {
  note "building the programs"
  buildTree release stridegraph gait_fit
}

# The library that the page opens with: synthesised clips, no captured ones. Made again when the program is newer.
buildDefaultLibrary() {
  local library=build/library/default.sgraph
  if [ ! "$library" -nt build/bin/stridegraph ]; then
    note "building the default library"
    rm -rf build/gait build/library
    mkdir -p build/gait build/library
    build/bin/stridegraph gait -o build/gait
    build/bin/stridegraph build build/gait/*.bvh -o "$library" --threshold 0.03 --neighbours 18 \
      --license "$(cat build/gait/ORIGIN.txt)" \
      --report build/library/default.json
  fi
}

buildModule() {
  note "building the module"
  buildTree wasm stridegraph_javascript
}

# buildCapturedLibrary NAME FILE [OPTION...]: from the clips in a folder of the captures.
buildCapturedLibrary() {
  note "building $(basename "$2" .sgraph) from captured clips"
  mkdir -p "$(dirname "$2")"
  build/bin/stridegraph build "$STRIDEGRAPH_MOCAP/$1"/*.bvh -o "$2" "${@:3}"
}

# The page takes in the module and the default library, so it comes last.
buildAll() {
  buildPrograms
  buildDefaultLibrary
  buildModule
  note "building the page"
  buildTree wasm site
}

runDemo() {
  local port=8080
  while [ "$#" -gt 0 ]; do
    case "$1" in
      --port)
        [[ "${2:-}" =~ ^[0-9]+$ ]] || fail "--port needs a number"
        port=$2
        shift 2
        ;;
      *) fail "demo: found '$1', expected --port N" ;;
    esac
  done
  setupBuild
  buildAll
  exec node tools/serve.mjs build/site --port "$port"
}
