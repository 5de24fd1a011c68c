#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
# Files that comments and pages name exist: words that end in .h, .md or .cpp and hold a slash, and pages
# (.md) without one too. A path may leave out the folders before it: "planar/scene.h" is
# that file in any folder.
#
#   tests/checks/paths.sh [ROOT]     root of the repository, default: here
#
# Prints file:line and the word for each that does not, and fails. Names with wildcards or placeholders
# (NAME, <room>, a brace or a dollar), whole addresses and what the programs write are not paths.
set -eu
cd "${1:-.}"

# Build trees and results are nobody's sources.
files() {
  find . -type d \( -path './build*' -o -path ./results -o -path './.*' \) -prune -o -type f -print |
    sed 's|^\./||' | sort
}

# Pages that the programs write into run folders.
written=" accuracy.md "

known=$(mktemp)
trap 'rm -f "$known"' EXIT
files > "$known"
if ! grep -q '\.md$' "$known"; then
  echo "paths.sh: no pages in $(pwd), expected the root of the repository" >&2
  exit 1
fi

# "file:line word" of each path in the comments of sources, decks and scripts and in all of a page.
# Ends of sentences, "./" and "../" are no part of a path.
named() {
  grep -E '(\.(h|cpp|sh|txt|md)|/in\.[a-z_0-9]+)$' "$known" | while read -r file; do
    awk -v file="$file" '
      { text = "" }
      file ~ /\.(h|cpp)$/ { if (match($0, /\/\//)) text = substr($0, RSTART + 2) }
      file ~ /\.(sh|txt)$|\/in\.[^\/]*$/ { if (match($0, /(^|[ \t])#/)) text = substr($0, RSTART + RLENGTH) }
      file ~ /\.md$/ { text = $0 }
      {
        gsub(/[a-z]+:\/\/[^ )>]*/, " ", text)
        count = split(text, words, /[^A-Za-z0-9_.\/<>{}$*+…-]+/)
        for (i = 1; i <= count; ++i) {
          word = words[i]
          sub(/\.+$/, "", word)
          while (sub(/^\.\.?\//, "", word)) {}
          if (word !~ /\.(h|cpp|md)$/ || word ~ /[<>{}$*+…]|NAME/ || word ~ /^\//) continue
          if (word ~ /\// || word ~ /.\.md$/) print file ":" FNR, word
        }
      }' "$file"
  done
}

missing=$(
  named | awk -v known="$known" -v written="$written" '
    BEGIN {
      while ((getline path < known) > 0) {
        do exists[path] = 1
        while (sub(/^[^\/]*\//, "", path))
      }
    }
    !($2 in exists) && !index(written, " " $2 " ") { print $1 ": " $2 ": no such file" }'
)
if [ -n "$missing" ]; then
  printf '%s\n' "$missing" >&2
  exit 1
fi
