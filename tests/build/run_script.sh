#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
# Usage: run_script.sh REPOSITORY
# inputs/run.sh refuses to pass a complete run off as one with other parameters.
set -eu
repository=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cat > "$work/parameters.json" << 'END'
{
  "format": "rodpack-run 1",
  "preset": "quick",
  "surface": "smooth",
  "particles": 250,
  "particles_per_line": 9,
  "timestep_s": 1.1e-05
}
END
echo '{"step": 1}' > "$work/result.json"

refused() {
  expected=$1
  shift
  if OUT=$work sh "$repository/inputs/run.sh" "$@" > "$work/log" 2>&1; then
    echo "FAILED: accepted $*" >&2
    exit 1
  fi
  grep -qF "$expected" "$work/log" || { cat "$work/log" >&2; exit 1; }
}
refused "particles 250, not 9:" quick -var particles 9
refused "surface smooth, not coarse:" quick -var timestep 11e-6 -var surface coarse
refused "timestep 1.1e-05, not 2e-5:" quick -var timestep 2e-5
refused "preset quick, not paper:" paper
