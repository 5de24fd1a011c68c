#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
# Usage: install-into.sh [--update] LIGGGHTS/src
# Copies our styles and the core they need, flat, into a LIGGGHTS-PUBLIC 3.8.0 source folder.
# A file there that differs from ours is left alone and stops the script; --update replaces it, and
# takes out what an earlier version of ours has put under other names.
set -eu
ext=$(cd "$(dirname "$0")" && pwd)

fail() {
  echo "install-into.sh: $1" >&2
  exit 1
}

update=no
if [ "${1:-}" = --update ]; then
  update=yes
  shift
fi
[ $# = 1 ] || fail "give one folder: the src folder of LIGGGHTS-PUBLIC 3.8.0"
src=$1
for file in Make.sh fix_multisphere.h; do
  [ -f "$src/$file" ] || fail "$src is not a LIGGGHTS src folder: it has no $file"
done
version=$(cat "$src/version_liggghts.txt" 2> /dev/null || echo unknown)
[ "$version" = 3.8.0 ] || fail "$src is version $version, expected 3.8.0"

# All our files as they read there, in their places; gone when the script ends, however it does.
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
trap 'exit 1' HUP INT TERM
ours=$scratch/ours
export LC_ALL=C # one order for sort and comm

# LIGGGHTS compiles one flat folder and names no other to the compiler. So styles lie flat, headers of the
# core in rodpack/<room>/, and its sources flat, with a prefix that keeps them apart from LIGGGHTS's own.
(cd "$ext" && ls styles/*/*.h styles/*/*.cpp core/include/rodpack/*.h core/include/rodpack/*/*.h \
  core/src/*.h core/src/*/*.h vtk/rodpack/*/*.h core/src/*/*.cpp) > "$scratch/files"
sed -e 's|^styles/[^/]*/||' -e 's|^core/include/||' -e 's|^vtk/||' \
  -e 's|^core/src/\([^/]*\)/\(.*\.cpp\)$|rodpack_\1_\2|' -e 's|^core/src/|rodpack/|' \
  "$scratch/files" > "$scratch/to"
{ cat "$scratch/to" && echo rodpack_version.cpp; } | sort > "$scratch/places"
twice=$(uniq -d "$scratch/places")
[ -z "$twice" ] || fail "two of our files have one place there: $twice"

mkdir "$ours"
grep / "$scratch/places" | sed 's|/[^/]*$||' | uniq | (cd "$ours" && xargs mkdir -p)
cp "$ext"/styles/*/*.h "$ext"/styles/*/*.cpp "$ours"
# Includes name the way from one place to the other. What a source includes is public (named from rodpack/
# on already), private and one folder up, or private and beside it.
paste -d ' ' "$scratch/files" "$scratch/to" | while read -r file place; do
  room=${file#core/src/}
  room=${room%/*}
  case $file in
    styles/*) ;;
    *.h) sed 's|#include "rodpack/|#include "../|' "$ext/$file" > "$ours/$place" ;;
    *)
      sed -e '/#include "rodpack\//b' -e 's|#include "\.\./|#include "rodpack/|' \
        -e '/#include "rodpack\//b' -e "s|#include \"|#include \"rodpack/$room/|" "$ext/$file" > "$ours/$place"
      ;;
  esac
done
"$ext/write-version.sh" "$ours/rodpack_version.cpp"

# Checksums of what stands at our places.
sums() {
  (cd "$1" && xargs cksum < "$scratch/places" 2> /dev/null) | sort
}
names() {
  cut -d ' ' -f 3- | sort
}
sums "$ours" > "$scratch/ours.sums"
sums "$src" > "$scratch/theirs.sums"
comm -13 "$scratch/ours.sums" "$scratch/theirs.sums" | names > "$scratch/different"
names < "$scratch/theirs.sums" | comm -13 - "$scratch/places" > "$scratch/missing"
(cd "$src" && ls -d rodpack_*.cpp rodpack/*.h rodpack/*/*.h 2> /dev/null) | sort |
  comm -13 "$scratch/places" - > "$scratch/left"

# The version's source is ours alone, and another one after each commit.
differs=$(grep -vx 'rodpack_version.cpp' "$scratch/different" | head -n 1)
if [ "$update" = no ]; then
  [ ! -s "$scratch/left" ] ||
    fail "$src/$(head -n 1 "$scratch/left") is of another version of ours; --update removes it"
  [ -z "$differs" ] || fail "$src/$differs exists and differs from ours; --update replaces it"
fi
while read -r file; do
  rm "$src/$file"
  echo "removed $src/$file"
done < "$scratch/left"
while read -r file; do
  cp "$ours/$file" "$src/$file"
  echo "replaced $src/$file"
done < "$scratch/different"
(cd "$ours" && tar -cf - -T "$scratch/missing") | (cd "$src" && tar -xf -)

# Model combinations to be compiled for the fast path: the user's own lines stay.
list=style_contact_model_user.whitelist
while read -r line; do
  grep -qsxF "$line" "$src/$list" || echo "$line" >> "$src/$list"
done < "$ext/styles/contact/$list"
echo "rodpack's styles are in $src; build it with: make auto"
