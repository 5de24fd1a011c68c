#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
# Past this machine: the time of a step of run_style verlet/planar on P ranks, from what planar_size.sh has
# measured, by the model of liggghts-src-ext/doc/background/planar_scaling.md. Prints its tables.
#
#   tests/benchmark/planar_scaling.sh BUILD-FOLDER [LATENCY BANDWIDTH]
#
# LATENCY of a message, s, and BANDWIDTH per rank, bytes/s: assumptions, 2e-6 and 1e9 (a fast network shared
# by the ranks of a node).
set -eu
here=$(cd "$(dirname "$0")" && pwd)
times=$(cd "$1" && pwd)/benchmark/planar_size/times.txt
sort -k1,1 -k2,2g "$times" | awk -v latency="${2:-2e-6}" -v bandwidth="${3:-1e9}" "$(cat "$here/medians.awk")"'
  { ghosts[$1] = $5; bytes[$1] = $6 }
  # of a square subdomain with n rods: those in a frame of the halo width around it
  function frame(n) { return 4 * width * sqrt(n * density) + 4 * width * width * density }
  function step_time(n, p,    g, neighbours) {
    if (p == 1) return n * rod
    g = frame(n)
    neighbours = p < 3 ? 1 : p < 5 ? 3 : 8
    return n * rod + g * (ghost + message / bandwidth) + neighbours * latency + log(p) / log(2) * latency * 2 / 32
  }
  function cell(n, p) {
    return sprintf("%.3g ms, %.0f %%", 1e3 * step_time(n / p, p), 100 * n * rod / p / step_time(n / p, p))
  }
  END {
    rod = 9e-9 * median("ranks_1")
    ghost = (9e-9 * median("ranks_2") * 9000 - 4500 * rod) / ghosts["ranks_2"]
    message = bytes["ranks_2"] / ghosts["ranks_2"]
    density = 0.86 / 42e-6         # rods per m^2 in a bed of AR = 5
    width = 2.5 * 7.5e-3 + 4 * 0.9e-3  # of the halo, m: reach of both, and twice the way
    printf "c = %.3g ns per rod, c_g = %.3g ns and b = %.3g bytes per ghost\n\n", 1e9 * rod, 1e9 * ghost, message
    print "| ranks | 1e6 rods | 1e7 rods | 1e8 rods |\n|---|---|---|---|"
    for (p = 1; p <= 65536; p *= 4)
      print "| " p " | " cell(1e6, p) " | " cell(1e7, p) " | " cell(1e8, p) " |"
    print "\n| ranks | 1000 rods each | 10 000 rods each | 100 000 rods each |\n|---|---|---|---|"
    for (p = 1; p <= 65536; p *= 16)
      print "| " p " | " cell(1e3 * p, p) " | " cell(1e4 * p, p) " | " cell(1e5 * p, p) " |"
  }'
