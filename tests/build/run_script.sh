#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
# Usage: run_script.sh REPOSITORY
# inputs/run.sh refuses to pass a complete run off as one with other parameters.
set -eu
repository=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
echo '{}' > "$work/parameters.json"
echo '{"step": 1}' > "$work/result.json"
echo 'quick -var particles 30' > "$work/arguments"

for arguments in 'quick -var particles 9' 'quick' 'paper -var particles 30'; do
  # shellcheck disable=SC2086  # several words
  if OUT=$work sh "$repository/inputs/run.sh" $arguments > "$work/log" 2>&1; then
    echo "FAILED: accepted $arguments" >&2
    exit 1
  fi
  grep -qF "holds the run 'quick -var particles 30', not '$arguments" "$work/log" || {
    cat "$work/log" >&2
    exit 1
  }
done
