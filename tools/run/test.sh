# shellcheck shell=bash
# Runs the tests and counts them. Sourced by ./run.

passed=0
failed=0
summary=()

# record SUITE PASSED FAILED [SKIPPED]
record() {
  passed=$((passed + $2))
  failed=$((failed + $3))
  summary+=("$(printf '%-12s %5d passed %5d failed %5d skipped' "$1" "$2" "$3" "${4:-0}")")
}

# A suite without figures of its own counts as one test.
recordOutcome() {
  if [ "$2" -eq 0 ]; then record "$1" 1 0; else record "$1" 0 1; fi
}

# The number in the last line of FILE that matches PATTERN's first group: figure FILE PATTERN
figure() {
  local number
  number=$(sed -nE "s/$2/\1/p" "$1" | tail -n 1)
  echo "${number:-0}"
}

# runCtest SUITE PRESET
runCtest() {
  local log=build/$2/ctest.log status=0
  ctest --preset "$2" --parallel "$(nproc)" --progress --output-log "$log" >/dev/null || status=$?
  local total bad skipped
  total=$(figure "$log" '.*tests failed out of ([0-9]+).*')
  bad=$(figure "$log" '.* ([0-9]+) tests failed out of.*')
  skipped=$(grep -cE '\*\*\*Skipped' "$log" || true)
  if [ "$status" -ne 0 ]; then
    grep -vE ' Passed +[0-9.]+ sec$|^ *Start ' "$log" || true
    [ "$bad" -gt 0 ] || bad=1
  fi
  record "$1" $((total > bad ? total - bad - skipped : 0)) "$bad" "$skipped"
}

# runNodeTests SUITE FOLDER
runNodeTests() {
  local log=build/$1-tests.log status=0
  local files=("$2"/*_test.mjs)
  [ -e "${files[0]}" ] || fail "$2 holds no tests"
  node --test --test-reporter=spec "${files[@]}" >"$log" 2>&1 || status=$?
  local good bad skipped
  good=$(figure "$log" '^[^a-z]*pass ([0-9]+)$')
  bad=$(figure "$log" '^[^a-z]*fail ([0-9]+)$')
  skipped=$(figure "$log" '^[^a-z]*skipped ([0-9]+)$')
  if [ "$status" -ne 0 ]; then
    cat "$log"
    [ "$bad" -gt 0 ] || bad=1
  fi
  record "$1" "$good" "$bad" "$skipped"
}

# The maps that lie beside the captures, unless others are named.
findMaps() {
  local maps=${STRIDEGRAPH_MOCAP:-}/../maps
  if [ -z "${STRIDEGRAPH_MAPS:-}" ] && [ -n "${STRIDEGRAPH_MOCAP:-}" ] && [ -d "$maps" ]; then
    export STRIDEGRAPH_MAPS=$maps
  fi
}

# Without clang-tidy, which takes over half an hour where nothing is known to be clean yet: ./run lint runs it.
testLint() {
  local status=0
  lintSources --quick || status=$?
  recordOutcome lint "$status"
}

testNative() {
  note "native tests"
  buildTree release all
  runCtest native release
}

testSanitizers() {
  note "native tests under the sanitizers"
  buildTree asan all
  runCtest sanitizers asan
}

testModule() {
  note "module tests"
  runNodeTests module tests/wasm
}

testBrowser() {
  note "browser tests"
  runNodeTests browser tests/browser
}

# judgeMaps NAME LIBRARY CLIP...: the referee beside the captures, on every map with three seeds.
judgeMaps() {
  local name=$1 library=$2 status=0
  shift 2
  note "judging the walks of $name on every map"
  # Debian's python3, which has the numpy that setup installs; another may come first on the PATH.
  # Two centimetres from the goal, and no joint driven 1.6 times as hard as the clips do at most.
  /usr/bin/python3 "$referee" --cli build/bin/stridegraph --graph "$library" --clips "$@" --units-per-metre 100 --seeds 3 \
    --goal-radius 0.02 --max-ratio 1.6 --json "build/captures/$name-maps.json" || status=$?
  recordOutcome "maps: $name" "$status"
}

# Libraries from captures, built by the program and judged from outside.
testCaptures() {
  if [ -z "${STRIDEGRAPH_MOCAP:-}" ]; then
    note "skipped: walks from captured clips, since STRIDEGRAPH_MOCAP is not set"
    return
  fi
  local referee=$STRIDEGRAPH_MOCAP/../tools/check_maps.py name
  for name in cmu16_walk accad_male1_walk; do
    buildCapturedLibrary "$name" "build/captures/$name.sgraph" --report "build/captures/$name.json" ||
      recordOutcome "build $name" 1
  done
  if [ ! -f "$referee" ]; then
    note "skipped: judging walks on maps, since there is no $referee"
    return
  fi
  for name in cmu16_walk accad_male1_walk; do
    judgeMaps "$name" "build/captures/$name.sgraph" "$STRIDEGRAPH_MOCAP/$name"/*.bvh
  done
  judgeMaps default build/library/default.sgraph build/gait/*.bvh
}

# runTests [SUITE...]: without names everything but the sanitizers. The last line is for machines.
runTests() {
  local suites=("$@") suite
  [ "${#suites[@]}" -gt 0 ] || suites=(lint native captures module browser)
  setupTests
  findMaps
  [ "${suites[*]}" = lint ] || buildAll
  for suite in "${suites[@]}"; do
    case "$suite" in
      lint | native | module | browser | captures | sanitizers) "test${suite^}" ;;
      *) fail "test: found '$suite', expected lint, native, module, browser, captures or sanitizers" ;;
    esac
  done
  [ -n "${STRIDEGRAPH_MOCAP:-}" ] || note "skipped: all tests on captured motion, since STRIDEGRAPH_MOCAP is not set"
  printf '%s\n' "" "${summary[@]}"
  echo "$passed passed, $failed failed"
  [ "$failed" -eq 0 ]
}
