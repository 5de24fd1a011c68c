#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
# Usage: sanitized_decks.sh [BUILD]
# Builds liggghts in a folder of its own, BUILD (default build-sanitized/), with AddressSanitizer and
# UndefinedBehaviorSanitizer in the core and the styles, not in stock LIGGGHTS, runs every deck of
# inputs/verification/, and deposits 24 particles with either engine on one rank and on two; each
# deposition goes on from a restart file as well. The first finding ends the script with exit status 1;
# its run stays. Takes as long as a build of liggghts, and two minutes more: no part of tests/run.sh.
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

# deposit FOLDER ENGINE
deposit() {
  "$repository/inputs/deposition/run_one.sh" "$1" -var particles 24 -var width_in_lengths 5 \
    -var particles_per_line 4 -var container_height 0.12 -var relaxation_ratio 1e-4 \
    -var restart_interval 0.1 -var engine "$2"
}
for RANKS in 1 2; do
  export RANKS
  for engine in planar spheres; do
    echo "== engine $engine, ranks: $RANKS"
    run=$runs/$engine$RANKS
    deposit "$run" "$engine"
    rm "$run/result.json"
    deposit "$run" "$engine"
  done
done
rm -r "$runs"
echo "sanitized_decks.sh: no finding"
