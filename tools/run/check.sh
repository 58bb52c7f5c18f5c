# shellcheck shell=bash
# Formatting and linting. Sourced by ./run.

# The files of this project that git knows or would take, as a NUL-separated list: sourceFiles PATTERN...
sourceFiles() {
  git ls-files -z --cached --others --exclude-standard -- "$@" | while IFS= read -r -d '' file; do
    [ ! -f "$file" ] || printf '%s\0' "$file"
  done
}

formatSources() {
  sourceFiles '*.h' '*.cpp' | xargs -0 -r clang-format -i
  npx prettier --log-level warn --write .
}

# lintSources [--quick]: every check runs, so that one run tells everything; clang-tidy only without --quick.
lintSources() {
  local faults=0
  sourceFiles '*.h' '*.cpp' | xargs -0 -r clang-format --dry-run -Werror || faults=$((faults + 1))
  npx prettier --log-level warn --check . || faults=$((faults + 1))
  npx eslint --max-warnings 0 . || faults=$((faults + 1))
  shellcheck --external-sources --check-sourced run .ci/run || faults=$((faults + 1))
  if [ "${1:-}" != --quick ]; then
    tidySources || faults=$((faults + 1))
  fi
  [ "$faults" -eq 0 ] || return 1
  note "formatting and linting: nothing found"
}

# Whatever is built natively. The app's drawing and the bindings need Emscripten's headers and are left out.
tidySources() {
  installPackages "${tidyPackages[@]}"
  configure release
  buildTree release core/graph/generated/sgraph_generated.h
  sourceFiles 'core/*.cpp' 'tools/*.cpp' 'web/*.cpp' | xargs -0 -r node tools/lint/tidy.mjs build/release build/tidy
}
