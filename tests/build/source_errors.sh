#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
# Usage: source_errors.sh REPOSITORY STAGED_SRC WORK
# A wrong LIGGGHTS source is one line that says what is wrong and what to do.
set -eu
if [ $# != 3 ]; then
  sed -n 's/^# \(Usage: .*\)/\1/p' "$0" >&2
  exit 2
fi
stage=$1/liggghts-src-ext/StageLiggghts.cmake
work=$3
rm -rf "$work"
mkdir -p "$work"

fail() {
  echo "FAILED: $1" >&2
  exit 1
}

# expect_error SOURCE TEXT
expect_error() {
  if cmake -DLIGGGHTS_SOURCE="$1" -DLIGGGHTS_WORK="$work/out" -P "$stage" > "$work/log" 2>&1; then
    fail "took $1"
  fi
  [ "$(grep -c 'LIGGGHTS: ' "$work/log")" = 1 ] || fail "not one line: $(cat "$work/log")"
  line=$(grep 'LIGGGHTS: ' "$work/log")
  case $line in
    *"$1"*"$2"*"give -DLIGGGHTS_SOURCE="*) ;;
    *) fail "expected '$1', '$2' and the remedy in: $line" ;;
  esac
  if [ -e "$work/out/src" ]; then fail "staged $1"; fi
}

expect_error "$work/nowhere" 'does not exist'

echo 'not the tarball' > "$work/liggghts.tar.xz"
expect_error "$work/liggghts.tar.xz" 'has SHA-256 '

mkdir "$work/empty"
expect_error "$work/empty" 'is not a LIGGGHTS source (no version_liggghts.txt)'

mkdir -p "$work/old/src"
for file in Make.sh main.cpp fix_multisphere.h utils.h finish.cpp; do
  cp "$2/$file" "$work/old/src"
done
echo 3.7.0 > "$work/old/src/version_liggghts.txt"
expect_error "$work/old" 'is version 3.7.0, expected 3.8.0'

# A tree of the right version whose code is another.
echo 3.8.0 > "$work/old/src/version_liggghts.txt"
echo '// rewritten' > "$work/old/src/finish.cpp"
expect_error "$work/old" 'is not LIGGGHTS 3.8.0 (finish.cpp lacks'
