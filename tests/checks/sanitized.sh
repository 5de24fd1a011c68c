#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
# Usage: sanitized.sh REPOSITORY BUILD SANITIZERS TARGETS [CTEST ARGUMENTS ...]
# Builds TARGETS, a list of words, with SANITIZERS (address,undefined or thread) in a folder of its
# own, BUILD, and runs the tests there that the arguments choose. The first finding ends its program.
set -eu
if [ $# -lt 4 ]; then
  sed -n 's/^# \(Usage: .*\)/\1/p' "$0" >&2
  exit 2
fi
repository=$1 build=$2 sanitizers=$3 targets=$4
shift 4

if [ ! -f "$build/build.ninja" ]; then
  cmake -G Ninja -S "$repository" -B "$build" -DRODPACK_POSTPROC_ONLY=ON -DRODPACK_NATIVE=OFF \
    -DRODPACK_TESTS=ON -DRODPACK_SANITIZE="$sanitizers"
fi
# shellcheck disable=SC2086  # a list of words
cmake --build "$build" --parallel "$(nproc)" --target $targets
ctest --test-dir "$build" --output-on-failure --no-tests=error -j "$(nproc)" "$@"
