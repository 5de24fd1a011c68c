#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
# Runs a program on one core, its output to standard error, and prints its core time, user and system, s.
#
#   tests/benchmark/core_time.sh PROGRAM [ARGUMENT ...]
set -eu
# A shell of its own, for the processor time of its children.
# shellcheck disable=SC2016
spent=$(sh -c 'taskset -c 1 "$0" "$@" >&2 || exit; times' "$@")
echo "$spent" | awk 'NR == 2 { gsub(/s/, ""); split($1, u, "m"); split($2, s, "m")
  print 60 * (u[1] + s[1]) + u[2] + s[2] }'
