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

# One file of ours at a time, as it reads there; gone when the script ends, however it does.
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
trap 'exit 1' HUP INT TERM

# Calls "$1 OURS THEIRS" for each file, OURS as it reads there: LIGGGHTS compiles one flat folder and
# names no other to the compiler. So styles lie flat, headers of the core in rodpack/<room>/, and
# includes name the way from the one to the other.
for_each_file() {
  for file in "$ext"/styles/*/*.h "$ext"/styles/*/*.cpp; do
    "$1" "$file" "$src/$(basename "$file")"
  done
  for file in "$ext"/core/include/rodpack/*.h "$ext"/core/include/rodpack/*/*.h "$ext"/core/src/*.h "$ext"/core/src/*/*.h \
    "$ext"/vtk/rodpack/*/*.h; do
    place=${file#"$ext"/core/include/rodpack/}
    place=${place#"$ext"/core/src/}
    place=${place#"$ext"/vtk/rodpack/}
    sed 's|#include "rodpack/|#include "../|' "$file" > "$scratch/ours"
    "$1" "$scratch/ours" "$src/rodpack/$place"
  done
  # The prefix keeps our sources apart from LIGGGHTS's own. What they include is public (named from
  # rodpack/ on already), private and one folder up, or private and beside them.
  for file in "$ext"/core/src/*/*.cpp; do
    room=$(basename "$(dirname "$file")")
    sed -e '/#include "rodpack\//b' -e 's|#include "\.\./|#include "rodpack/|' \
      -e '/#include "rodpack\//b' -e "s|#include \"|#include \"rodpack/$room/|" "$file" > "$scratch/ours"
    "$1" "$scratch/ours" "$src/rodpack_${room}_$(basename "$file")"
  done
  "$ext/write-version.sh" "$scratch/version.cpp"
  "$1" "$scratch/version.cpp" "$src/rodpack_version.cpp"
}

print_place() {
  echo "$2"
}

refuse_different() {
  # Ours alone, and another one after each commit.
  if [ "$2" = "$src/rodpack_version.cpp" ]; then return 0; fi
  if [ -e "$2" ] && ! cmp -s "$1" "$2"; then
    fail "$2 exists and differs from ours; --update replaces it"
  fi
}

copy() {
  if [ ! -e "$2" ]; then
    mkdir -p "$(dirname "$2")"
    cp "$1" "$2"
  elif ! cmp -s "$1" "$2"; then
    cp "$1" "$2"
    echo "replaced $2"
  fi
}

places=$(for_each_file print_place | sort)
twice=$(echo "$places" | uniq -d)
[ -z "$twice" ] || fail "two of our files have one place there: $twice"
for file in "$src"/rodpack_*.cpp "$src"/rodpack/*.h "$src"/rodpack/*/*.h; do
  if [ ! -e "$file" ] || echo "$places" | grep -qxF "$file"; then continue; fi
  [ "$update" = yes ] || fail "$file is of another version of ours; --update removes it"
  rm "$file"
  echo "removed $file"
done
[ "$update" = yes ] || for_each_file refuse_different
for_each_file copy

# Model combinations to be compiled for the fast path: the user's own lines stay.
list=style_contact_model_user.whitelist
while read -r line; do
  grep -qsxF "$line" "$src/$list" || echo "$line" >> "$src/$list"
done < "$ext/styles/contact/$list"
echo "rodpack's styles are in $src; build it with: make auto"
