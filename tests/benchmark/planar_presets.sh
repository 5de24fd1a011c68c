#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
# Whole depositions of 3000 rods of AR = 5, from the first line to rest, insertion and output included, by the
# presets `paper` and `economy` of the deposition's deck, in turn on one core; beside them, in the first round, the
# built-in multisphere with the longest step at which its beds have the same means (inputs/accuracy/README.md) and the
# skin at which it is fastest, and in each a program of one's own that deposits the same, as a yardstick.
#
#   tests/benchmark/planar_presets.sh BUILD-FOLDER [ROUNDS [PROGRAM ARGUMENT ...]]
#
# Prints the core time of each and writes ratios to BUILD-FOLDER/benchmark/planar_presets.json. Ten minutes a round,
# and half an hour for the built-in.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
build=$(cd "$1" && pwd)
rounds=${2:-1}
shift
[ $# -eq 0 ] || shift
work=$build/benchmark/planar_presets
export OMPI_MCA_ess_singleton_isolated=1
mkdir -p "$work"
: > "$work/times"

# Runs a program; appends NAME and its core time, s.
timed() {
  name=$1
  shift
  seconds=$("$here/core_time.sh" "$@" 2> "$work/$name.out") || { tail -3 "$work/$name.out"; exit 1; }
  echo "$name $seconds" | tee -a "$work/times"
}

# Deposits by some settings of the deck, which go by a name.
deposit() {
  method=$1
  shift
  rm -rf "${work:?}/$method"
  timed "$method" "$build/bin/liggghts" -in "$here/../../inputs/deposition/in.deposition" "$@" \
    -var particles 3000 -var output_interval 100 -var restart_interval 100 -var out "$work/$method"
  [ -e "$work/$method/result.json" ] || { tail -3 "$work/$method.out"; exit 1; }
}

round=0
while [ $round -lt "$rounds" ]; do
  for preset in paper economy; do deposit $preset -var preset $preset; done
  [ $round -gt 0 ] || deposit built-in -var integrator builtin -var timestep 2.75e-5 -var falling_skin 2.5e-3
  [ $# -eq 0 ] || timed yardstick "$@"
  round=$((round + 1))
done
sort -k1,1 -k2,2g "$work/times" | awk -v file="$build/benchmark/planar_presets.json" "$(cat "$here/medians.awk")"'
  END {
    printf "deposition of 3000 rods, core time: paper %.1f s, economy %.1f s, %.3f of it\n", median("paper"), median("economy"), median("economy") / median("paper")
    printf "built-in %.0f s, %.1f times economy\n", median("built-in"), median("built-in") / median("economy")
    if (count["yardstick"]) printf "yardstick %.1f s: paper takes %.2f times that\n", median("yardstick"), median("paper") / median("yardstick")
    printf "[\n%s", pair("deposition of 3000 rods, economy over paper", "economy", "paper", "s") > file
    printf ",\n%s", pair("deposition of 3000 rods, built-in over economy", "built-in", "economy", "s") > file
    if (count["yardstick"]) printf ",\n%s", pair("deposition of 3000 rods, paper over yardstick", "paper", "yardstick", "s") > file
    print "\n]" > file
  }'
