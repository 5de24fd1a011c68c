#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
# The packings from which methods are timed: deposited by run_style verlet/planar in the paper's container.
# Each is made once, in BUILD-FOLDER/benchmark/beds, in half an hour for all of them.
#
#   tests/benchmark/beds.sh BUILD-FOLDER
set -eu
here=$(cd "$(dirname "$0")" && pwd)
build=$(cd "$1" && pwd)
beds=$build/benchmark/beds
mkdir -p "$beds"
export OMPI_MCA_ess_singleton_isolated=1

# NAME, then parameters of the deposition
bed() {
  name=$1
  shift
  [ ! -e "$beds/$name/result.json" ] || return 0
  echo "making the bed $name (build/benchmark/beds/$name)"
  rm -rf "${beds:?}/$name"
  stdbuf -oL "$build/bin/liggghts" -in "$here/../../inputs/deposition/in.deposition" \
    -var output_interval 100 -var out "$beds/$name" "$@" > "$beds/$name.out" 2>&1 ||
    { tail -3 "$beds/$name.out"; exit 1; }
}

bed ar5 -var particles 3000 -var restart_interval 5.45 # the first restart file: half filled
bed ar2 -var aspect_ratio 2 -var particles 1500 -var restart_interval 100
bed spheres -var aspect_ratio 1 -var particles 1500 -var restart_interval 100
bed coarse -var surface coarse -var particles 1000 -var restart_interval 100
bed curved -var curvature 120 -var particles 1000 -var restart_interval 100
bed ar7 -var aspect_ratio 7 -var particles 1000 -var restart_interval 100
