#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
# Usage: tidy.sh REPOSITORY BUILD
# clang-tidy with .clang-tidy on lines that changed since a base, committed or not. The base is the
# environment's RODPACK_BASE, else where HEAD left origin/main, else, on origin/main itself, HEAD's
# first parent: in a fresh clone of main the last commit alone is looked at, of a merge all that it
# brought. BUILD holds compile_commands.json. Each source takes ten to twenty seconds: the
# RODPACK_TIDY_FILES (default 8) with the most changed lines are checked, and the others named.
set -eu
if [ $# != 2 ]; then
  sed -n 's/^# \(Usage: .*\)/\1/p' "$0" >&2
  exit 2
fi
cd "$1"
build=$2

fail() {
  echo "tidy.sh: $1" >&2
  exit 2
}
skip() {
  echo "skipped: $1"
  exit 77
}
git() { command git -c safe.directory='*' "$@"; }

most=${RODPACK_TIDY_FILES:-8}
case $most in
  *[!0-9]* | 0*) fail "RODPACK_TIDY_FILES is '$most', expected a number of sources, 1 or more" ;;
esac
if ! command -v clang-tidy > /dev/null; then
  # The machine that decides about a change has all tools.
  if [ "${CI:-}" = true ]; then fail "no clang-tidy on this machine"; fi
  skip "no clang-tidy on this machine"
fi
head=$(git rev-parse -q --verify HEAD 2> /dev/null) || skip "no git repository"

base=${RODPACK_BASE:-}
if [ -n "$base" ]; then
  git rev-parse -q --verify "$base^{commit}" > /dev/null || fail "RODPACK_BASE is '$base', which is no commit here"
else
  base=$(git merge-base HEAD origin/main 2> /dev/null) || base=$head
  if [ "$base" = "$head" ]; then base=HEAD^; fi
  git rev-parse -q --verify "$base^{commit}" > /dev/null || skip "no commit $base: a shallow clone?"
fi

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# "FILE FIRST LAST" for each run of changed lines; of a file that git does not know yet, all lines.
set -- liggghts-src-ext postproc tests
git diff -U0 --no-color --no-ext-diff --dst-prefix=b/ --diff-filter=d "$base" -- "$@" | awk '
  /^\+\+\+ / { file = substr($2, 3) }
  /^@@ / && file ~ /\.(h|cpp)$/ {
    split(substr($3, 2), lines, ",")
    count = lines[2] == "" ? 1 : lines[2]
    if (count > 0) print file, lines[1], lines[1] + count - 1
  }' > "$work/changed"
git ls-files --others --exclude-standard -- "$@" | grep -E '\.(h|cpp)$' | while read -r file; do
  echo "$file 1 $(wc -l < "$file")"
done >> "$work/changed"
[ -s "$work/changed" ] || skip "no C++ changed since $base"

# Prints the source through which header $1 is checked: its own, its test, or another that includes it,
# itself or through a header; none for one that only generated code includes.
source_of() {
  header=$1
  for _ in 1 2 3; do
    name=$(basename "$header")
    includers=$(git grep --untracked -lE "^#include \"([^\"]*/)?$name\"" -- '*.h' '*.cpp') || return 0
    for choice in "/${name%.h}\.cpp" "/${name%.h}_test\.cpp" '\.cpp'; do
      if printf '%s\n' "$includers" | grep -m 1 "$choice\$"; then return 0; fi
    done
    header=$(printf '%s\n' "$includers" | head -n 1)
  done
}

# Sources, the most changed first.
: > "$work/left"
awk '{ count[$1] += $3 - $2 + 1 } END { for (file in count) print count[file], file }' "$work/changed" |
  while read -r count file; do
    source=$file
    case $file in *.h) source=$(source_of "$file") ;; esac
    if [ -n "$source" ]; then echo "$count $source"; else echo "$file" >> "$work/left"; fi
  done |
  awk '{ count[$2] += $1 } END { for (file in count) print count[file], file }' |
  sort -k 1,1rn -k 2 | cut -d ' ' -f 2 > "$work/sources"
tail -n +$((most + 1)) "$work/sources" >> "$work/left"
head -n "$most" "$work/sources" > "$work/checked"
echo "since $base ($(git log -1 --format='%h of %cs' "$base")): $(wc -l < "$work/checked") sources"
if [ -s "$work/left" ]; then echo "not checked:" && cat "$work/left"; fi
[ -s "$work/checked" ] || skip "only headers that no source includes"

# Files by folder and name: an include may lead to them through "..".
filter=$(awk '{
    parts = split($1, path, "/")
    name = path[parts - 1] "/" path[parts]
    if (!(name in ranges)) order[++files] = name
    ranges[name] = ranges[name] (ranges[name] == "" ? "" : ",") "[" $2 "," $3 "]"
  }
  END {
    printf "["
    for (k = 1; k <= files; ++k)
      printf "%s{\"name\":\"%s\",\"lines\":[%s]}", k == 1 ? "" : ",", order[k], ranges[order[k]]
    printf "]"
  }' "$work/changed")
# clang cannot read the headers that GCC has precompiled for the tests: it reads the text. Nor does it know
# this warning of GCC's.
sed -E 's/ -Winvalid-pch| -fpch-preprocess| -include [^ ]*cmake_pch\.hxx| -Wno-maybe-uninitialized//g' \
  "$build/compile_commands.json" > "$work/compile_commands.json"
xargs -r -P "$(nproc)" -n 1 clang-tidy --quiet -p "$work" --warnings-as-errors='*' \
  --line-filter="$filter" < "$work/checked"
