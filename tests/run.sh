#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
# Sets the machine up, builds, runs all tests. Arguments go to ctest: tests/run.sh -L unit
set -eu
cd "$(dirname "$0")/.."

echo "1/3 packages (a minute or two the first time)"
docker/setup.sh tests
echo "2/3 build of the programs and the tests (some nine minutes on two cores the first time)"
docker/build.sh tests
echo "3/3 tests and checks (some twenty minutes on two cores the first time)"
report=$PWD/build/tests.xml
if ctest --test-dir build --output-on-failure --no-tests=error -j "$(nproc)" --output-junit "$report" "$@"; then
  # What a machine lacks skips a check: so it is said at the end, with the reason.
  awk -F '"' '/<testcase / { name = $2; skipped = 0 }
    /<skipped message="SKIP/ { skipped = 1 }
    skipped && sub(/^.*<system-out>(skipped: )?/, "") { print "tests/run.sh: skipped: " name ": " $0 }' "$report"
  echo "tests/run.sh: no test failed"
else
  echo "tests/run.sh: tests FAILED (listed above)" >&2
  exit 1
fi
