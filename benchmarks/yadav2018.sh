#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
# Time and peak memory of the published method on the synthetic part, for 1 and 2 threads, in place
# and simultaneous. Builds the release preset first.
set -euo pipefail

points=${1:-1000000}
rounds=${2:-50}
[[ $# -le 2 && $points =~ ^[1-9][0-9]*$ && $rounds =~ ^[0-9]+$ ]] || {
  echo "usage: benchmarks/yadav2018.sh [POINTS [ROUNDS]]   (1000000 50)" >&2
  exit 2
}
cd "$(dirname "${BASH_SOURCE[0]}")/.."
. scripts/common.sh
start_log bench
install_missing "${build_packages[@]}" time
build_preset release
deburr=build/release/deburr

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$deburr" synth part "$work/part.ply" --points "$points" --quiet

cache() { sed -n "s/^$1:[A-Z]*=//p" build/release/CMakeCache.txt; }
compiler=$(cache CMAKE_CXX_COMPILER)
cat <<TEXT

cpu       $(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1), $(nproc) cores to run on
compiler  $("$compiler" --version | head -n 1)
flags     $(cache CMAKE_CXX_FLAGS) $(cache CMAKE_CXX_FLAGS_RELEASE) -ffp-contract=off
load      $(cut -d ' ' -f 1-3 /proc/loadavg)
input     $points points of the synthetic part, $rounds rounds of --method yadav2018

threads  update          seconds  peak memory in MiB
TEXT
for threads in 1 2; do
  for update in in-place simultaneous; do
    command time -o "$work/time" -f '%e %M' "$deburr" denoise "$work/part.ply" "$work/clean.ply" \
      --method yadav2018 --rounds "$rounds" --update "$update" --threads "$threads" --quiet
    read -r seconds kib <"$work/time"
    printf '%-8s %-13s %9s  %d\n' "$threads" "$update" "$seconds" $((kib / 1024))
  done
done
