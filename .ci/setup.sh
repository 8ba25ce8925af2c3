# Shared by demos/run, conformance/run and .ci/run (bash; sourced, never run): Debian packages, steps and their logs.
# The script that sources this sets `me`, its name in messages.
# shellcheck shell=bash

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
logs=$root/build/log

# The one list of Debian packages: what building takes, and what the tests take beside it.
build_packages=(g++ cmake ninja-build python3 khronos-api libhwy-dev libglm-dev libglfw3-dev libx11-dev libxrandr-dev
                libpng-dev)
test_packages=(libgtest-dev libosmesa6 xvfb xdotool imagemagick gnuplot-nox valgrind)
# What the preset arm64 takes beside them.
arm64_packages=(g++-aarch64-linux-gnu qemu-user libhwy-dev:arm64 libpng-dev:arm64 libgtest-dev:arm64)

# fail MESSAGE: the one clear line that a failure ends with.
fail() {
  echo "$me: $1" >&2
  exit "${2:-1}"
}

# step NAME COMMAND...: runs a command with its output in build/log/NAME.log; on failure shows the log's end and stops.
step() {
  local name=$1 log=$logs/$1.log
  shift
  mkdir -p "$logs"
  if ! "$@" >"$log" 2>&1 </dev/null; then
    tail -n 30 "$log" >&2
    fail "step $name failed; its whole output is in $log"
  fi
}

# missing_packages PACKAGES...: the ones that are not installed.
missing_packages() {
  local package
  for package in "$@"; do
    [[ $(dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null) == installed ]] || echo "$package"
  done
}

# as_root COMMAND...: runs a command as root.
as_root() {
  if ((EUID == 0)); then
    "$@"
  else
    sudo "$@"
  fi
}

# add_architecture NAME: lets packages for another CPU be installed.
add_architecture() {
  command -v dpkg >/dev/null || return 0
  if [[ $(dpkg --print-architecture; dpkg --print-foreign-architectures) != *$1* ]]; then
    echo "$me: adding the Debian architecture $1"
    step architecture as_root dpkg --add-architecture "$1"
  fi
}

# install_packages PACKAGES...: names the missing ones and installs them.
install_packages() {
  command -v dpkg-query >/dev/null || { echo "$me: no dpkg-query here; taking for granted: $*"; return; }
  local missing
  mapfile -t missing < <(missing_packages "$@")
  ((${#missing[@]})) || return 0
  echo "$me: installing the Debian packages ${missing[*]}"
  if ((EUID != 0)); then
    command -v sudo >/dev/null || fail "these packages are missing and there is no sudo: ${missing[*]}"
    sudo -v || fail "these packages are missing and sudo refuses: ${missing[*]}"
  fi
  step package-lists as_root apt-get update
  step packages as_root env DEBIAN_FRONTEND=noninteractive apt-get install --yes --no-install-recommends \
    "${missing[@]}"
}

# configure PRESET ARGUMENTS...: into build/PRESET.
configure() {
  echo "$me: configuring build/$1"
  (cd "$root" && step "configure-$1" cmake --preset "$@") || exit
}

# build PRESET TARGETS...: everything where no target is named.
build() {
  local preset=$1 targets=()
  shift
  (($# == 0)) || targets=(--target "$@")
  echo "$me: building ${*:-everything} in build/$preset"
  (cd "$root" && step "build-$preset" cmake --build --preset "$preset" "${targets[@]}") || exit
}
