# shellcheck shell=bash
# Draws every stage into build/figures. Sourced by ./run.

# drawFigures LIBRARY FOLDER [OPTION...]: pictures and their index.
drawFigures() {
  note "drawing every stage of $1"
  build/bin/stridegraph figures --graph "$1" -o "$2" "${@:3}"
}

# What the gait model makes of clips that it has not seen: the jogs that it was measured on, and all walks.
drawGaitFigures() {
  local folder=$STRIDEGRAPH_MOCAP number
  local jogs=()
  for number in 35 36 37 38 39 40 42 44; do
    jogs+=("$folder/cmu16_jog/16_${number}_"*.bvh)
  done
  note "measuring the gait model on captures, leaving out each clip in turn"
  build/bin/gait_fit --walk "$folder"/cmu16_walk/*.bvh --jog "${jogs[@]}" --held-out build/figures/gait_fit
}

# Pictures that need captures: libraries built from them, and the gait model against them.
drawCapturedFigures() {
  local name
  for name in cmu16_walk accad_male1_walk; do
    buildCapturedLibrary "$name" "build/captures/$name.sgraph"
    drawFigures "build/captures/$name.sgraph" "build/figures/$name"
  done
  drawGaitFigures
}

runFigures() {
  [ "$#" -eq 0 ] || fail "figures: found '$1', expected no arguments"
  setupPrograms
  buildPrograms
  buildDefaultLibrary
  local folders=()
  if [ -n "${STRIDEGRAPH_MOCAP:-}" ]; then
    drawCapturedFigures
    folders=(--folder cmu16_walk --folder accad_male1_walk --folder gait_fit)
  else
    note "skipped: pictures from captured clips, since STRIDEGRAPH_MOCAP is not set"
  fi
  drawFigures build/library/default.sgraph build/figures "${folders[@]}"
  note "open build/figures/index.html"
}
