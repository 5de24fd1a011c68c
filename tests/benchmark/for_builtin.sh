#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
# A restart file of fix multisphere/ab for the built-in fix multisphere, which takes those that name no other
# style: the bodies in it are the built-in's, what multisphere/ab adds follows them and is passed over. Its seal
# (liggghts-src-ext/stock/restart_seal.h), which would no longer be right, is left out: `read_restart FILE unsealed`.
#
#   tests/benchmark/for_builtin.sh FILE > builtin.restart
set -eu
[ -f "$1" ] || {
  echo "for_builtin.sh: $1: no such restart file" >&2
  exit 1
}
# the length of the name, with its final zero, and the name
LC_ALL=C sed 's|\x0f\x00\x00\x00multisphere/ab\x00|\x0c\x00\x00\x00multisphere\x00|g' "$1" | head -c -61
