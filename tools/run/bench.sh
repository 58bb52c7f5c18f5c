# shellcheck shell=bash
# Measures speed and quality into build/bench. Sourced by ./run.

benchFolder=build/bench
benchSeeds=20
benchRooms=1000
benchDocs=no
benchFrames=1000,3000,10000,30000,100000
benchWalkers=1,2,5,10,20,50,100
benchTiming=()
benchLibraries=()

readBenchOptions() {
  while [ "$#" -gt 0 ]; do
    case "$1" in
      --seeds | --rooms)
        [[ "${2:-}" =~ ^[0-9]+$ ]] || fail "bench: $1 needs a number"
        if [ "$1" = --seeds ]; then benchSeeds=$2; else benchRooms=$2; fi
        shift 2
        ;;
      --quick)
        benchSeeds=3
        benchRooms=50
        benchFrames=1000,3000,10000
        benchWalkers=1,2,5,10,20
        shift
        ;;
      --processor-time)
        benchTiming=(--processor-time)
        shift
        ;;
      --docs)
        benchDocs=yes
        shift
        ;;
      *) fail "bench: found '$1', expected --quick, --seeds N, --rooms N, --processor-time or --docs" ;;
    esac
  done
}

# The default library, and those from captures as they are and mirrored.
buildBenchLibraries() {
  benchLibraries=(build/library/default.sgraph)
  if [ -z "${STRIDEGRAPH_MOCAP:-}" ]; then
    note "skipped: libraries from captured clips, since STRIDEGRAPH_MOCAP is not set"
    return
  fi
  local name
  for name in cmu16_walk accad_male1_walk; do
    buildCapturedLibrary "$name" "build/captures/$name.sgraph"
    buildCapturedLibrary "$name" "build/captures/${name}_mirrored.sgraph" --mirror
    benchLibraries+=("build/captures/$name.sgraph" "build/captures/${name}_mirrored.sgraph")
  done
}

# --graph for each library.
graphOptions() {
  local library
  for library in "${benchLibraries[@]}"; do printf '%s\n' --graph "$library"; done
}

measureNatively() {
  note "measuring natively"
  build/bin/stridegraph bench --maps "$1" --seeds "$benchSeeds" --random 1 --rooms "$benchRooms" \
    --write-scenes "$benchFolder/rooms" --json "$benchFolder/native.json" "${benchTiming[@]}" "${@:2}" >"$benchFolder/native.md"
}

# Frames compared in a second, beside a matrix product in the same run: as text, since its figures are its own.
measureSimilarity() {
  local program=build/release/bench/similarity_bench
  note "measuring the comparison of frames"
  {
    printf '## Similarity\n\nPairs of frames compared in a second on one core.\n\n~~~text\n'
    "$program"
    printf '~~~\n\nIn Node.js:\n\n~~~json\n'
    node tests/bench/similarity_node.mjs "$program"
    printf '~~~\n\n'
  } >"$benchFolder/similarity.md"
}

# Where OMPL is installed; CMake finds it when it configures.
measureOmpl() {
  if [ ! -x build/bin/ompl_bench ]; then
    note "skipped: OMPL's planners, since it was not installed when build/release was configured (Debian: libompl-dev)"
    return
  fi
  note "measuring OMPL's planners"
  build/bin/ompl_bench --maps "$1" --seeds "$benchSeeds" -o "$benchFolder/ompl.json"
}

measureGrowth() {
  note "measuring how building and planning grow"
  build/bin/stridegraph bench --graph build/library/default.sgraph --growth-frames "$benchFrames" \
    --growth-rectangles 0,100,300,1000,2000 --growth-walkers "$benchWalkers" --json "$benchFolder/growth.json" "${benchTiming[@]}" >"$benchFolder/growth.md"
}

measureInNode() {
  note "measuring in Node.js"
  node tools/bench/node_bench.mjs --maps "$1" --seeds "$benchSeeds" --random "$benchFolder/rooms" \
    -o "$benchFolder/node.json" "${@:2}"
}

# What the figures were measured on, in a sentence.
benchMachine() {
  local model
  model=$(sed -n 's/^model name[[:space:]]*: //p' /proc/cpuinfo 2>/dev/null | head -n 1)
  local timing=
  [ "${#benchTiming[@]}" -eq 0 ] || timing=" Native times are what the processor spent."
  echo "Measured by \`./run bench\` on ${model:-an unknown processor}, one thread, Node.js $(node -p process.versions.node).$timing"
}

# All records in one table and one picture.
tabulateBench() {
  local file joins=()
  for file in native ompl node growth; do
    [ ! -f "$benchFolder/$file.json" ] || joins+=(--join "$benchFolder/$file.json")
  done
  build/bin/stridegraph bench "${joins[@]}" --json "$benchFolder/bench.json" --svg "$benchFolder/bench.svg" \
    >"$benchFolder/tables.md"
  {
    printf '# What was measured\n\n%s\n\n![Speed and quality](bench.svg)\n\n' "$(benchMachine)"
    cat "$benchFolder/tables.md" "$benchFolder/similarity.md"
  } >"$benchFolder/bench.md"
}

runBench() {
  readBenchOptions "$@"
  setupBuild
  installPackages "${benchPackages[@]}"
  findMaps
  buildPrograms
  cmake --preset release -DSTRIDEGRAPH_BENCH=ON --log-level=WARNING >/dev/null
  buildTree release bench_programs
  buildDefaultLibrary
  buildModule
  buildBenchLibraries
  local maps=${STRIDEGRAPH_MAPS:-public/scenes} graphs
  rm -rf "$benchFolder"
  mkdir -p "$benchFolder"
  mapfile -t graphs < <(graphOptions)
  measureNatively "$maps" "${graphs[@]}"
  measureOmpl "$maps"
  measureInNode "$maps" "${graphs[@]}"
  measureSimilarity
  measureGrowth
  tabulateBench
  if [ "$benchDocs" = yes ]; then
    sed 's#(bench.svg)#(images/bench.svg)#' "$benchFolder/bench.md" >docs/bench.md
    cp "$benchFolder/bench.svg" docs/images/bench.svg
    note "wrote docs/bench.md and docs/images/bench.svg"
  fi
  note "read $benchFolder/bench.md; every run is in $benchFolder/bench.json"
}
