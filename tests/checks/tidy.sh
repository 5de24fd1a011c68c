#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
# Usage: tidy.sh REPOSITORY BUILD
# clang-tidy with .clang-tidy on lines that changed since a base, committed or not. The base is the
# environment's RODPACK_BASE, else where HEAD left origin/main, else, on origin/main itself, HEAD's
# first parent. BUILD holds compile_commands.json. A large change takes long: the RODPACK_TIDY_FILES
# (default 12) sources with the most changed lines are checked, and the others named.
set -eu
cd "$1"
build=$2
most=${RODPACK_TIDY_FILES:-12}

skip() {
  echo "skipped: $1"
  exit 77
}
command -v clang-tidy > /dev/null || skip "no clang-tidy on this machine"
git() { command git -c safe.directory='*' "$@"; }
head=$(git rev-parse -q --verify HEAD 2> /dev/null) || skip "no git repository"

base=${RODPACK_BASE:-}
if [ -z "$base" ]; then
  base=$(git merge-base HEAD origin/main 2> /dev/null) || base=$head
  if [ "$base" = "$head" ]; then base=HEAD^; fi
fi
git rev-parse -q --verify "$base^{commit}" > /dev/null || skip "no commit $base: a shallow clone?"

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# "FILE FIRST LAST" for each run of changed lines
git diff -U0 --diff-filter=d "$base" -- liggghts-src-ext postproc tests | awk '
  /^\+\+\+ / { file = substr($2, 3) }
  /^@@ / && file ~ /\.(h|cpp)$/ {
    split(substr($3, 2), lines, ",")
    count = lines[2] == "" ? 1 : lines[2]
    if (count > 0) print file, lines[1], lines[1] + count - 1
  }' > "$work/changed"
[ -s "$work/changed" ] || skip "no C++ changed since $base"

# Sources: those that changed and those beside a header that changed, the most changed first.
awk '{ sub(/\.h$/, ".cpp", $1); count[$1] += $3 - $2 + 1 }
  END { for (file in count) print count[file], file }' "$work/changed" | sort -rn |
  while read -r _ file; do if [ -e "$file" ]; then echo "$file"; fi; done > "$work/sources"
tail -n +$((most + 1)) "$work/sources" > "$work/left"
if [ -s "$work/left" ]; then echo "not checked:" && cat "$work/left"; fi

filter=$(awk '{
    if (!($1 in ranges)) order[++files] = $1
    ranges[$1] = ranges[$1] (ranges[$1] == "" ? "" : ",") "[" $2 "," $3 "]"
  }
  END {
    printf "["
    for (k = 1; k <= files; ++k)
      printf "%s{\"name\":\"%s\",\"lines\":[%s]}", k == 1 ? "" : ",", order[k], ranges[order[k]]
    printf "]"
  }' "$work/changed")
echo "since $base: $(head -n "$most" "$work/sources" | wc -l) sources"
head -n "$most" "$work/sources" | xargs -P "$(nproc)" -n 2 \
  clang-tidy --quiet -p "$build" --warnings-as-errors='*' --line-filter="$filter"
