#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
# Usage: run.sh [SECONDS [TARGET ...]], with RUNS=N in the environment of at most N inputs per target
# Builds the fuzz targets with clang, libFuzzer and sanitizers in build-fuzz/ (or $FUZZ_BUILD) and
# lets each search for SECONDS (default 300) on one core, from corpus/TARGET on. What ends one, or
# takes 10 s or 1 GB, is left in build-fuzz/found/ and makes the exit status 1; a test then shows the
# fault, and a small copy goes into corpus/.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
build=${FUZZ_BUILD:-$here/../../build-fuzz}
seconds=${1:-300}
[ $# -gt 0 ] && shift
[ $# -gt 0 ] || set -- chain dump gz json options table
case $seconds in *[!0-9]* | '') sed -n 's/^# \(Usage: .*\)/\1/p' "$0" >&2 && exit 2 ;; esac

if [ ! -f "$build/build.ninja" ]; then
  CC=clang CXX=clang++ cmake -G Ninja -S "$here/../.." -B "$build" -DRODPACK_POSTPROC_ONLY=ON \
    -DRODPACK_NATIVE=OFF -DRODPACK_TESTS=ON -DRODPACK_FUZZ=ON \
    -DRODPACK_SANITIZE=address,undefined
fi
status=0
for target in "$@"; do
  cmake --build "$build" --parallel 1 --target "fuzz_$target"
  mkdir -p "$build/corpus/$target" "$build/found"
  "$build/bin/fuzz_$target" -max_total_time="$seconds" -runs="${RUNS:--1}" -timeout=10 -rss_limit_mb=1024 \
    -max_len=65536 -print_final_stats=1 -artifact_prefix="$build/found/$target-" \
    "$build/corpus/$target" "$here/corpus/$target" || status=1
done
exit $status
