#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
# Whole depositions of 3000 rods of AR = 5, from the first line to rest, insertion and output included, by the
# presets `paper` and `economy` of the deposition's deck, in turn on one core; beside them a program of one's own
# that deposits the same, as a yardstick.
#
#   tests/benchmark/planar_presets.sh BUILD-FOLDER [ROUNDS [PROGRAM ARGUMENT ...]]
#
# Prints the core time of each and writes ratios to BUILD-FOLDER/benchmark/planar_presets.json. Ten minutes a round.
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

round=0
while [ $round -lt "$rounds" ]; do
  for preset in paper economy; do
    rm -rf "${work:?}/$preset"
    timed "$preset" "$build/bin/liggghts" -in "$here/../../inputs/deposition/in.deposition" -var preset "$preset" \
      -var particles 3000 -var output_interval 100 -var restart_interval 100 -var out "$work/$preset"
    [ -e "$work/$preset/result.json" ] || { tail -3 "$work/$preset.out"; exit 1; }
  done
  [ $# -eq 0 ] || timed yardstick "$@"
  round=$((round + 1))
done
sort -k1,1 -k2,2g "$work/times" | awk -v file="$build/benchmark/planar_presets.json" "$(cat "$here/medians.awk")"'
  END {
    printf "deposition of 3000 rods, core time: paper %.1f s, economy %.1f s, %.3f of it\n", median("paper"), median("economy"), median("economy") / median("paper")
    if (count["yardstick"]) printf "yardstick %.1f s: paper takes %.2f times that\n", median("yardstick"), median("paper") / median("yardstick")
    printf "[\n%s", pair("deposition of 3000 rods, economy over paper", "economy", "paper", "s") > file
    if (count["yardstick"]) printf ",\n%s", pair("deposition of 3000 rods, paper over yardstick", "paper", "yardstick", "s") > file
    print "\n]" > file
  }'
