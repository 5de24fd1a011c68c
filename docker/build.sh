#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
# Builds build/bin/liggghts and build/bin/rodpack, and with the argument "tests" all that the tests
# need as well. What stands is skipped.
# The environment's LIGGGHTS_SOURCE (folder or tarball) replaces the distribution's source package.
set -eu
cd "$(dirname "$0")/.."

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
      werror=OFF
      if g++ -dumpversion | grep -qx 12; then werror=ON; fi
      cmake -G Ninja -S . -B build -DRODPACK_TESTS=ON -DRODPACK_WERROR=$werror
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
