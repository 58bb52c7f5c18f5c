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

# lintSources [--tidy]: every check runs, so that one run tells everything.
lintSources() {
  local faults=0
  sourceFiles '*.h' '*.cpp' | xargs -0 -r clang-format --dry-run -Werror || faults=$((faults + 1))
  npx prettier --log-level warn --check . || faults=$((faults + 1))
  npx eslint --max-warnings 0 . || faults=$((faults + 1))
  shellcheck --external-sources --check-sourced run .ci/run || faults=$((faults + 1))
  if [ "${1:-}" = --tidy ]; then
    tidySources || faults=$((faults + 1))
  fi
  [ "$faults" -eq 0 ] || return 1
  note "formatting and linting: nothing found"
}

tidySources() {
  installPackages "${tidyPackages[@]}"
  configure release
  note "running clang-tidy, which takes its time"
  sourceFiles 'core/*.cpp' 'tools/*.cpp' |
    xargs -0 -r -n 1 -P "$(nproc)" clang-tidy --quiet -p build/release --warnings-as-errors='*'
}
