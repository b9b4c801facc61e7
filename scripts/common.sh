# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
# What the scripts of this folder share; they source it.

build_packages=(cmake ninja-build g++ libeigen3-dev libtbb-dev libcli11-dev libfmt-dev
  nlohmann-json3-dev libpng-dev)
python_packages=(python3 python3-dev python3-venv)
# For the page of `view` and `--report`; a build without them says what is missing.
viewer_packages=(nodejs npm)

fail() {
  echo "$(basename "$0"): $1" >&2
  exit "${2:-1}"
}

is_installed() {
  [ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

# Installs those of the given packages that are missing. $log takes the noise.
install_missing() {
  local package missing=() as_root=()
  command -v apt-get >/dev/null ||
    fail "no apt-get here, so install these by other means and build as CONTRIBUTING.md says: $*"
  for package in "$@"; do
    is_installed "$package" || missing+=("$package")
  done
  [ ${#missing[@]} -gt 0 ] || return 0
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null ||
      fail "neither root nor sudo, so have these installed first: apt-get install ${missing[*]}"
    as_root=(sudo)
  fi
  as_root+=(env DEBIAN_FRONTEND=noninteractive apt-get -q -o Acquire::Retries=3)
  echo "installing ${missing[*]}"
  # The lists of a fresh container are empty, and others may be too old.
  logged "${as_root[@]}" install -y --no-install-recommends "${missing[@]}" || {
    logged "${as_root[@]}" update || echo "apt-get update failed, trying with the lists as they are"
    logged "${as_root[@]}" install -y --no-install-recommends "${missing[@]}" ||
      fail_with_log "the installation failed"
  }
}

# Installs Node.js where there is none of 18 or newer; another source than Debian may have brought it.
install_node() {
  local version
  if version=$(node --version 2>/dev/null) && command -v npm >/dev/null; then
    version=${version#v}
    [ "${version%%.*}" -lt 18 ] || return 0
  fi
  install_missing "${viewer_packages[@]}"
}

# Runs a command with its output in $log.
logged() {
  echo "+ $*" >>"$log"
  "$@" >>"$log" 2>&1
}

fail_with_log() {
  echo "--- the end of $log" >&2
  tail -n 40 "$log" >&2
  fail "$1; all of it is in $log"
}

# Prints what a run of tests came to, from its JUnit file, as "N passed, N failed, N skipped".
count_tests() {
  [ -f "$1" ] || fail "the tests ended without results"
  awk '
    function value(name) {
      return match($0, name "=\"[0-9]+\"") ? substr($0, RSTART + length(name) + 2) + 0 : 0
    }
    /<testsuite /, />/ {
      tests += value("tests"); failed += value("failures") + value("errors")
      skipped += value("skipped") + value("disabled")
    }
    END { printf "%d passed, %d failed, %d skipped\n", tests - failed - skipped, failed, skipped }
  ' "$1"
}

# Starts $log anew.
start_log() {
  log=build/$1.log
  mkdir -p build
  : >"$log"
}

# Configures and builds a preset, or some targets of it. $configure_options are for CMake.
build_preset() {
  local started=$SECONDS preset=$1
  shift
  printf 'building (%s; takes minutes the first time) ... ' "$log"
  if ! { logged cmake --preset "$preset" ${configure_options[@]+"${configure_options[@]}"} &&
    logged cmake --build --preset "$preset" -j "$(nproc)" ${1:+--target "$@"}; }; then
    echo failed
    fail_with_log "the build failed"
  fi
  echo "done in $((SECONDS - started)) s"
}
