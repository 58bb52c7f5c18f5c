# shellcheck shell=bash
# Fuzzes the targets of tests/fuzz. Sourced by ./run.

fuzzFolder=build/fuzz
fuzzSeconds=60
fuzzDocs=no
fuzzMerge=no
fuzzTargets=()
allFuzzTargets=(bvh library link plan scene sgraph)

readFuzzOptions() {
  while [ "$#" -gt 0 ]; do
    case "$1" in
      --docs) fuzzDocs=yes ;;
      --merge) fuzzMerge=yes ;;
      *[!0-9]*)
        [[ " ${allFuzzTargets[*]} " == *" $1 "* ]] ||
          fail "fuzz: found '$1', expected SECONDS, --docs, --merge or a target: ${allFuzzTargets[*]}"
        fuzzTargets+=("$1")
        ;;
      *) fuzzSeconds=$1 ;;
    esac
    shift
  done
  [ "${#fuzzTargets[@]}" -gt 0 ] || fuzzTargets=("${allFuzzTargets[@]}")
}

buildFuzzTargets() {
  note "building the fuzz targets"
  buildTree fuzz fuzz_programs
  rm -rf "$fuzzFolder/seeds"
  "$fuzzFolder/bin/fuzz_seeds" . "$fuzzFolder/seeds"
}

# The folders with inputs of a target; new ones go into the first.
fuzzInputs() {
  printf '%s\n' "$fuzzFolder/corpus/$1" "tests/fuzz/corpus/$1" "$fuzzFolder/seeds/$1"
}

# fuzzOptions TARGET: what holds for every run of it.
fuzzOptions() {
  printf '%s\n' -max_len=8192 -timeout=120 -rss_limit_mb=4096 -verbosity=1
  [ ! -f "tests/fuzz/$1.dict" ] || printf '%s\n' "-dict=tests/fuzz/$1.dict"
}

# fuzzTarget TARGET: one run, with its log and, in a line, its figures.
fuzzTarget() {
  local name=$1 log=$fuzzFolder/$1.log status=0 begun=$SECONDS inputs options
  mkdir -p "$fuzzFolder/corpus/$name" "$fuzzFolder/found/$name" "$fuzzFolder/results"
  mapfile -t inputs < <(fuzzInputs "$name")
  mapfile -t options < <(fuzzOptions "$name")
  "$fuzzFolder/bin/${name}_fuzz" "${options[@]}" "-max_total_time=$fuzzSeconds" -print_final_stats=1 \
    "-artifact_prefix=$fuzzFolder/found/$name/" "${inputs[@]}" >"$log" 2>&1 || status=$?
  local edges features
  edges=$(figure "$log" '.* cov: ([0-9]+) .*')
  features=$(figure "$log" '.* ft: ([0-9]+) .*')
  printf '%s\t%s\t%s\t%s\t%s\n' "$((SECONDS - begun))" "$(figure "$log" 'stat::number_of_executed_units: +([0-9]+)')" \
    "$(figure "$log" 'stat::average_exec_per_sec: +([0-9]+)')" "$edges" "$features" >"$fuzzFolder/results/$name.tsv"
  [ "$status" -eq 0 ] || echo "$status" >"$fuzzFolder/results/$name.failed"
}

# tellOfFuzzing TARGET: its figures in a sentence, and where its findings lie.
tellOfFuzzing() {
  local seconds executions speed edges features
  IFS=$'\t' read -r seconds executions speed edges features <"$fuzzFolder/results/$1.tsv"
  note "$1: $executions executions in $seconds s ($speed a second), $edges edges and $features features covered"
  [ -e "$fuzzFolder/results/$1.failed" ] || return 0
  printf '!! %s: found something; see %s and, to try it again, run\n' "$1" "$fuzzFolder/$1.log" >&2
  find "$fuzzFolder/found/$1" -type f -newer "$fuzzFolder/seeds" -printf "!!   $fuzzFolder/bin/$1_fuzz %p\n" >&2
  return 1
}

# mergeCorpus TARGET: keeps of all inputs a few that reach as many edges, for tests/fuzz/corpus.
mergeCorpus() {
  local name=$1 kept=$fuzzFolder/merged/$1 inputs options
  rm -rf "$kept"
  mkdir -p "$kept"
  mapfile -t inputs < <(fuzzInputs "$name")
  mapfile -t options < <(fuzzOptions "$name")
  "$fuzzFolder/bin/${name}_fuzz" "${options[@]}" -merge=1 -use_counters=0 "$kept" "${inputs[@]}" \
    >"$fuzzFolder/$name.merge.log" 2>&1 || fail "fuzz: merging failed, see $fuzzFolder/$name.merge.log"
  rm -rf "tests/fuzz/corpus/$name"
  cp -r "$kept" "tests/fuzz/corpus/$name"
  note "$name: $(find "$kept" -type f | wc -l) files, $(du -sb "$kept" | cut -f 1) bytes kept in tests/fuzz/corpus"
}

# noteCoverage TARGET: which lines its inputs reach, for the table.
noteCoverage() {
  local name=$1 tree=build/fuzz-coverage inputs
  mapfile -t inputs < <(fuzzInputs "$name")
  LLVM_PROFILE_FILE=$tree/$name.profraw "$tree/bin/${name}_fuzz" -runs=0 -timeout=120 "${inputs[@]}" >"$tree/$name.log" 2>&1 ||
    fail "fuzz: measuring coverage failed, see $tree/$name.log"
  llvm-profdata merge -sparse "$tree/$name.profraw" -o "$tree/$name.profdata"
  llvm-cov export -summary-only "-instr-profile=$tree/$name.profdata" "$tree/bin/${name}_fuzz" >"$tree/$name.json"
}

runFuzz() {
  readFuzzOptions "$@"
  installPackages "${nativePackages[@]}" "${fuzzPackages[@]}"
  buildFuzzTargets
  local name faults=0
  for name in "${fuzzTargets[@]}"; do rm -f "$fuzzFolder/results/$name.failed"; done
  note "fuzzing ${fuzzTargets[*]}: $fuzzSeconds s each"
  for name in "${fuzzTargets[@]}"; do
    while [ "$(jobs -rp | wc -l)" -ge "$(nproc)" ]; do wait -n || true; done
    fuzzTarget "$name" &
  done
  wait
  for name in "${fuzzTargets[@]}"; do tellOfFuzzing "$name" || faults=$((faults + 1)); done
  if [ "$fuzzMerge" = yes ]; then
    for name in "${fuzzTargets[@]}"; do mergeCorpus "$name"; done
  fi
  if [ "$fuzzDocs" = yes ]; then
    installNode
    buildTree fuzz-coverage fuzz_programs
    for name in "${allFuzzTargets[@]}"; do noteCoverage "$name"; done
    node tools/fuzz_table.mjs "$fuzzFolder" build/fuzz-coverage docs/fuzzing.md
  fi
  [ "$faults" -eq 0 ]
}
