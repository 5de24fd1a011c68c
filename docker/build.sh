#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
# Builds build/bin/liggghts and build/bin/rodpack, and with the argument "tests" all that the tests
# need as well. What stands is skipped.
# The environment's LIGGGHTS_SOURCE (folder or tarball) replaces the distribution's source package.
set -eu
cd "$(dirname "$0")/.."

if [ -f build/CMakeCache.txt ] && ! grep -qx 'CMAKE_GENERATOR:INTERNAL=Ninja' build/CMakeCache.txt; then
  echo "docker/build.sh: build/ was not made for Ninja: remove it (rm -r build) and start again" >&2
  exit 1
fi

case "${1:-}" in
  '')
    targets="liggghts rodpack"
    if [ ! -f build/build.ninja ]; then
      cmake -G Ninja -S . -B build -DRODPACK_TESTS=OFF
    fi
    ;;
  tests)
    targets=all
    # Anew where the folder was made for the programs alone.
    if ! grep -qsx 'RODPACK_TESTS:BOOL=ON' build/CMakeCache.txt || [ ! -f build/build.ninja ]; then
      cmake -G Ninja -S . -B build -DRODPACK_TESTS=ON
    fi
    ;;
  *)
    echo "docker/build.sh: no argument, or tests; not '$1'" >&2
    exit 2
    ;;
esac
# How far it is: files compiled of those to compile, and the time so far.
export NINJA_STATUS="[%f/%t, %es] "
# shellcheck disable=SC2086  # a list of words
cmake --build build --parallel "$(nproc)" --target $targets
