#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
# Sets the machine up, then builds build/bin/liggghts and build/bin/rodpack. What stands is skipped.
# The environment's LIGGGHTS_SOURCE (folder or tarball) replaces the distribution's source package.
set -eu
cd "$(dirname "$0")/.."

docker/setup.sh
if [ ! -f build/build.ninja ]; then
  cmake -G Ninja -S . -B build
fi
cmake --build build --parallel "$(nproc)"
