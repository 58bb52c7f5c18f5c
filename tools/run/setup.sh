# shellcheck shell=bash
# Installs what the project needs on Debian 12: apt packages that are missing, the sources of Dear ImGui,
# and the npm packages of the lock file. Sourced by ./run.

# What is built with, what the page is built with, and what tests, clang-tidy, fuzzing and
# measuring use.
nativePackages=(
  g++ cmake ninja-build ccache libeigen3-dev libfmt-dev libexpected-dev nlohmann-json3-dev libfast-float-dev
  libflatbuffers-dev flatbuffers-compiler libtinygltf-dev libstb-dev libcli11-dev libgtest-dev)
webPackages=(emscripten fonts-inter xz-utils)
testPackages=(chromium fonts-droid-fallback clang-format shellcheck python3-numpy)
tidyPackages=(clang-tidy clang-tools)
fuzzPackages=(clang llvm libclang-rt-14-dev)
benchPackages=(libbenchmark-dev)

# asRoot COMMAND...: as root, through sudo where needed.
asRoot() {
  if [ "$(id -u)" -eq 0 ]; then
    "$@"
  elif command -v sudo >/dev/null; then
    sudo "$@"
  else
    fail "installing needs root, and there is no sudo: run as root: $*"
  fi
}

missingPackages() {
  local package
  for package in "$@"; do
    [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || echo "$package"
  done
}

# installPackages PACKAGE...: those that are missing, and says which. Elsewhere than on Debian it only says
# what is needed: CMake names whatever it then cannot find.
installPackages() {
  if ! command -v apt-get >/dev/null; then
    note "no apt-get here; what Debian calls ${*} has to be there already"
    return
  fi
  local missing
  mapfile -t missing < <(missingPackages "$@")
  [ "${#missing[@]}" -gt 0 ] || return 0
  note "installing with apt-get: ${missing[*]}"
  asRoot apt-get -qq update
  asRoot env DEBIAN_FRONTEND=noninteractive apt-get -qq install -y --no-install-recommends "${missing[@]}"
}

# Emscripten and the tests share one Node.js: the first on the PATH, or Debian's.
installNode() {
  local packages=()
  command -v node >/dev/null || packages+=(nodejs)
  command -v npm >/dev/null || packages+=(npm)
  [ "${#packages[@]}" -eq 0 ] || installPackages "${packages[@]}"
  local major
  major=$(node -p 'process.versions.node.split(".")[0]')
  [ "$major" -ge 18 ] || fail "Node.js $major is too old: 18 or newer is needed"
}

# Debian's libimgui-dev holds no sources; its source package does. The machine's own lists stay as they are.
fetchImgui() {
  [ ! -f .cache/imgui/imgui.cpp ] || return 0
  command -v apt-get >/dev/null || fail "unpack release 1.86 of Dear ImGui into .cache/imgui"
  note "fetching the sources of Dear ImGui from Debian's source package"
  local work file
  work=$(mktemp -d)
  mkdir -p "$work/parts" "$work/lists/partial" "$work/imgui"
  for file in /etc/apt/sources.list.d/*.sources; do
    [ -e "$file" ] && sed 's/^Types:.*/Types: deb-src/' "$file" >"$work/parts/$(basename "$file")"
  done
  for file in /etc/apt/sources.list /etc/apt/sources.list.d/*.list; do
    [ -e "$file" ] && sed -n 's/^deb\([[:space:]]\)/deb-src\1/p' "$file" >"$work/parts/$(basename "$file" .list).list"
  done
  local options=(-qq -o "Dir::Etc::sourcelist=/dev/null" -o "Dir::Etc::sourceparts=$work/parts"
    -o "Dir::State::Lists=$work/lists" -o "APT::Sandbox::User=root")
  apt-get "${options[@]}" update || note "not every source list answered; going on"
  (cd "$work" && apt-get "${options[@]}" source --download-only imgui)
  tar -xf "$work"/imgui_*.orig.tar.* -C "$work/imgui" --strip-components=1
  [ -f "$work/imgui/imgui.cpp" ] || fail "Debian's source package of imgui holds no imgui.cpp"
  mkdir -p .cache
  rm -rf .cache/imgui
  mv "$work/imgui" .cache/imgui
  rm -rf "$work"
}

# npm ci when the lock file is newer than what is installed.
installNodeModules() {
  [ package-lock.json -nt node_modules/.package-lock.json ] || return 0
  note "installing with npm ci: what package-lock.json lists"
  npm ci --no-audit --no-fund --loglevel=error
  touch node_modules/.package-lock.json
}

# What the programs need, without the page.
setupPrograms() {
  installPackages "${nativePackages[@]}"
}

setupBuild() {
  installPackages "${nativePackages[@]}" "${webPackages[@]}"
  installNode
  fetchImgui
}

setupTests() {
  setupBuild
  installPackages "${testPackages[@]}"
  installNodeModules
}
