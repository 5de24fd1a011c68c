#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
# run_style verlet/planar against the size of the scene: cost per rod and step of 1000, 10 000 and 100 000
# rods (beds of four lines, equally high, ever wider), observed every 1000 and every 10 000 steps, memory
# beyond that of the sphere-level styles, and one rank against two with 9000 rods (the bed of
# planar_deposition.sh).
#
#   tests/benchmark/planar_size.sh BUILD-FOLDER [ROUNDS]
#
# The beds are made once (ten minutes). Writes BUILD-FOLDER/benchmark/planar_size.json.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
build=$(cd "$1" && pwd)
rounds=${2:-5}
beds=$build/benchmark/wide_beds
work=$build/benchmark/planar_size
sizes="1000 10000 100000"
export OMPI_MCA_ess_singleton_isolated=1 OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
mkdir -p "$beds" "$work"
cd "$work"

for rods in $sizes; do
  [ ! -e "$beds/$rods/result.json" ] || continue
  echo "making the bed of $rods rods"
  rm -rf "${beds:?}/$rods"
  stdbuf -oL "$build/bin/liggghts" -in "$here/../../inputs/deposition/in.deposition" -var engine planar \
    -var particles "$rods" -var particles_per_line $((rods / 4)) -var width_in_lengths $((rods * 10 / 36)) \
    -var container_height 0.1 -var timestep 2.2e-5 -var relaxation_ratio 1e-3 -var output_interval 100 \
    -var restart_interval 100 -var out "$beds/$rods" > "$rods.out" 2>&1 || { tail -3 "$rods.out"; exit 1; }
done

# width of a bed of so many rods, m
width() { awk -v rods="$1" 'BEGIN { print int(rods * 10 / 36) * 0.015 }'; }

# RANKS RESTART WIDTH METHOD STEPS [OBSERVE]: prints ns per sphere and step, the largest memory of a single rank
# (kB; several leave no core for somebody who watches), the number of spheres, and ghosts and bytes that a
# rank sends in a step
steps() {
  launcher="taskset -c 1"
  [ "$1" = 1 ] || launcher="mpiexec --bind-to core -np $1"
  $launcher "$build/bin/liggghts" -in "$here/in.steps" -var start "$2" -var width "$3" -var method "$4" \
    -var warm_up 20 -var steps "$5" -var observe "${6:-1000}" > run.out 2>&1 &
  run=$!
  memory=0
  while [ "$1" = 1 ] && kill -0 $run 2> /dev/null; do
    now=$(awk '/^VmHWM/ { print $2 }' /proc/$run/status 2> /dev/null || true)
    memory=${now:-$memory}
    sleep 0.2
  done
  wait $run || { tail -3 run.out; exit 1; }
  # shellcheck disable=SC2016  # awk's
  awk -v memory="$memory" '/^Loop time/ { time = $4; steps = $9; spheres = $12 }
    /^Planar engine:.*ghosts/ { ghosts = $(NF - 7); bytes = $(NF - 4) }
    END { print time / steps / spheres * 1e9, memory, spheres, ghosts + 0, bytes + 0 }' run.out
}

rm -f times.txt
round=0
while [ $round -lt "$rounds" ]; do
  for rods in $sizes; do
    bed=$beds/$rods/restart/deposition.end.restart
    echo "size_$rods $(steps 1 "$bed" "$(width "$rods")" planar $((rods < 10000 ? 20000 : 2000)))" >> times.txt
    echo "alone_$rods $(steps 1 "$bed" "$(width "$rods")" planar $((rods < 10000 ? 40000 : 10000)) 10000)" >> times.txt
  done
  for ranks in 1 2; do
    echo "ranks_$ranks $(steps $ranks "$build/benchmark/planar_deposition/restart/deposition.end.restart" 0.3 \
      planar 10000)" >> times.txt
  done
  round=$((round + 1))
done
echo "spheres_100000 $(steps 1 "$beds/100000/restart/deposition.end.restart" "$(width 100000)" spheres 20)" >> times.txt

sort -k1,1 -k2,2g times.txt | awk -v file="$build/benchmark/planar_size.json" "$(cat "$here/medians.awk")"'
  { if ($3 > memory[$1]) memory[$1] = $3; spheres[$1] = $4; ghosts[$1] = $5; bytes[$1] = $6 }
  END {
    for (m in count) printf "%-14s %8.2f ns per sphere and step, spread %3.0f %%, %7.0f kB\n", m, median(m), 100 * spread(m), memory[m]
    beyond = (memory["size_100000"] - memory["spheres_100000"]) * 1024 / spheres["size_100000"]
    printf "memory beyond that of the sphere-level styles, 100000 rods: %.0f bytes per sphere\n", beyond
    print "[\n" pair("9000 rods, one rank over two", "ranks_1", "ranks_2") ",\n" \
          pair("rods 10000 over 1000", "size_10000", "size_1000") ",\n" \
          pair("rods 100000 over 1000", "size_100000", "size_1000") ",\n" \
          pair("rods 10000 over 1000, every 10000th step observed", "alone_10000", "alone_1000") ",\n" \
          pair("rods 100000 over 1000, every 10000th step observed", "alone_100000", "alone_1000") ",\n" \
          sprintf("  {\"name\": \"9000 rods, two ranks\", \"ghosts_per_rank\": %.4g, \"bytes_sent_per_rank_and_step\": %.4g},\n", ghosts["ranks_2"], bytes["ranks_2"]) \
          sprintf("  {\"name\": \"memory beyond the sphere level, 100000 rods\", \"bytes_per_sphere\": %.0f}", beyond) "\n]" > file
  }'
