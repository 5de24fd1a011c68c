#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
# Sets the machine up, builds, and measures; results in build/benchmark, ratios in benchmark.json there.
# Leave the machine alone meanwhile: two hours or so, most of it for packings and depositions that are made once.
#
#   tests/benchmark/run.sh     coarse graining: accuracy against time, 9000 rods (the packing four times
#                              side by side), one core; planar engine: steps (planar_engine.sh), whole
#                              depositions (planar_deposition.sh, planar_presets.sh), size and ranks
#                              (planar_size.sh), other programs (planar_peers.sh); what the study says
#                              that a run costs (study_estimate.py)
set -eu
cd "$(dirname "$0")/../.."

docker/setup.sh tests
docker/build.sh tests
cmake --build build --target coarse_graining_benchmark
bed=build/benchmark/bed
if [ ! -e "$bed/result.json" ]; then
  rm -rf "$bed"
  mkdir -p build/benchmark
  OMPI_MCA_ess_singleton_isolated=1 stdbuf -oL build/bin/liggghts -in inputs/deposition/in.deposition \
    -var particles 2250 -var particles_per_line 27 -var width_in_lengths 30 -var line_fall 0.0165 \
    -var container_height 0.5 -var timestep 2.2e-5 -var relaxation_ratio 1e-8 -var out "$bed"
fi
step=$(sed 's/.*"step": \([0-9]*\).*/\1/' "$bed/result.json")
taskset -c 1 build/bin/coarse_graining_benchmark "$bed/dumps/bodies.$step.dump" \
  "$bed/dumps/contacts.$step.dump" build/benchmark/coarse_graining --tiles 4
for benchmark in planar_engine planar_peers planar_deposition planar_presets planar_size; do
  tests/benchmark/$benchmark.sh build
done
tests/benchmark/study_estimate.py build
(
  cd build/benchmark
  sed '/^[][]$/d; s/}$/},/' planar_*.json | sed '$s/,$//; 1i[
$a]' > benchmark.json
)
