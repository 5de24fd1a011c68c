#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
# Usage: run_script.sh REPOSITORY
# inputs/run.sh refuses what it cannot mean, before it touches the machine, and to pass a complete run
# off as one with other parameters.
set -eu
if [ $# != 1 ]; then
  sed -n 's/^# \(Usage: .*\)/\1/p' "$0" >&2
  exit 2
fi
repository=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
echo '{}' > "$work/parameters.json"
echo '{"step": 1}' > "$work/result.json"
echo 'quick -var particles 30' > "$work/arguments"

# refuses MESSAGE WORD ...: these words are refused with a line that begins with MESSAGE
refuses() {
  message=$1
  shift
  if OUT=$work sh "$repository/inputs/run.sh" "$@" > "$work/log" 2>&1; then
    echo "FAILED: accepted $*" >&2
    exit 1
  fi
  # The first word on progress: packages.
  if grep -q '^1/4' "$work/log" || ! grep -qF "inputs/run.sh: $message" "$work/log"; then
    echo "FAILED: expected '$message' from $*:" >&2
    cat "$work/log" >&2
    exit 1
  fi
}

scenes='expected quick, paper, economy, deposition3d, discharge, discharge3d or incline'
refuses "scene '', $scenes"
refuses "scene 'foo', $scenes" foo
refuses "scene 'inputs/discharge', $scenes" inputs/discharge
refuses "'particles 30', expected -var NAME VALUE" quick particles 30
refuses "'-var particles', expected -var NAME VALUE" quick -var seed 1 -var particles
refuses "'--var particles 30', expected -var NAME VALUE" quick --var particles 30
refuses "-var out here: give the run folder as OUT=here" quick -var out here
refuses "-var seed is given twice" quick -var seed 1 -var seed 2
refuses "'6 7', expected -var NAME VALUE" quick -var seed 5 6 7
refuses "-var preset paper: give the preset as the first argument" incline -var preset paper
refuses "'particles 30', expected -var NAME VALUE" discharge3d particles 30
refuses "-var preset paper: give the preset as the first argument" quick -var preset paper
for ranks in abc 1.5 0 -1; do
  export RANKS=$ranks
  refuses "RANKS is '$ranks', expected a number of MPI ranks, 1 or more" quick
done
unset RANKS

for arguments in 'quick -var particles 9' 'quick' 'paper -var particles 30' 'incline -var particles 30'; do
  # shellcheck disable=SC2086  # several words
  refuses "$work holds the run 'quick -var particles 30', not '$arguments" $arguments
done
