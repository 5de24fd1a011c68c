#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
# Usage: sanitized_decks.sh [BUILD]
# Builds liggghts in a folder of its own, BUILD (default build-sanitized/), with AddressSanitizer and
# UndefinedBehaviorSanitizer in the core and the styles, not in stock LIGGGHTS, runs every deck of
# inputs/verification/, and small runs of the other decks, on one rank and on two: deposition with either
# engine, discharge, an inclined plane and a tilted box with either engine, deposition and discharge in space.
# Each goes on from a restart file as well. The first finding ends the script with exit status 1; its run stays.
# Takes as long as a build of liggghts, and some minutes more: no part of tests/run.sh.
set -eu
if [ $# -gt 1 ]; then
  sed -n 's/^# \(Usage: .*\)/\1/p' "$0" >&2
  exit 2
fi
repository=$(cd "$(dirname "$0")/../.." && pwd)
build=${1:-$repository/build-sanitized}

if [ ! -f "$build/build.ninja" ]; then
  cmake -G Ninja -S "$repository" -B "$build" -DRODPACK_TESTS=OFF -DRODPACK_SANITIZE=address,undefined
fi
cmake --build "$build" --parallel "$(nproc)" --target liggghts

LIGGGHTS=$(cd "$build" && pwd)/bin/liggghts
# Open MPI and VTK keep to the end what they have allocated once.
export LIGGGHTS ASAN_OPTIONS=detect_leaks=0 UBSAN_OPTIONS=print_stacktrace=1
# Two ranks may have one core.
export OMPI_MCA_mpi_yield_when_idle=1
runs=$(mktemp -d)
echo "runs: $runs"

for deck in "$repository"/inputs/verification/*/in.*; do
  run=$runs/$(basename "$deck")
  echo "== $deck"
  mkdir "$run"
  (cd "$run" && OMPI_MCA_ess_singleton_isolated=1 "$LIGGGHTS" -in "$deck")
done

# scene NAME DECK -var NAME VALUE ...: a run, which then goes on from its last restart file once more
scene() {
  echo "== $1, ranks: $RANKS"
  run=$runs/$1$RANKS
  export DECK=$repository/inputs/$2
  shift 2
  "$repository/inputs/deposition/run_one.sh" "$run" "$@"
  rm "$run/result.json"
  "$repository/inputs/deposition/run_one.sh" "$run" "$@"
}
for RANKS in 1 2; do
  export RANKS
  for engine in planar spheres; do
    scene $engine deposition/in.deposition -var particles 24 -var width_in_lengths 5 -var particles_per_line 4 \
      -var container_height 0.12 -var relaxation_ratio 1e-4 -var restart_interval 0.1 -var engine $engine
  done
  scene discharge discharge/in.discharge -var particles 40 -var container_width 0.036 -var orifice_width 0.015 \
    -var particles_per_line 5 -var settle_time 0.1 -var flow_limit 0.2 -var shutter_speed 0.5 -var restart_interval 0.1
  scene space deposition3d/in.deposition3d -var particles 30 -var aspect_ratio 3 -var surface coarse \
    -var container_width 0.018 -var relaxation_ratio 1e-4 -var restart_interval 0.1
  scene discharge3d discharge3d/in.discharge3d -var particles 40 -var container_width 0.024 -var orifice_width 0.015 \
    -var settle_time 0.02 -var column_fraction 0.05 -var lid_speed 4 -var flow_limit 0.05 -var restart_interval 0.03
  scene chute incline/in.incline -var particles 30 -var container_width 0.03 -var inclination 20 -var flow_time 0.2 \
    -var restart_interval 0.05
  for engine in planar spheres; do
    scene box_$engine incline/in.incline -var particles 30 -var container_width 0.03 -var inclination 12 \
      -var sides walls -var flow_time 0.2 -var restart_interval 0.05 -var engine $engine
  done
done
rm -r "$runs"
echo "sanitized_decks.sh: no finding"
