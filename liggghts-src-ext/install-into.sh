#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
# Usage: install-into.sh [--update] LIGGGHTS/src
# Copies our styles and the core they need, flat, into a LIGGGHTS-PUBLIC 3.8.0 source folder.
# A file there that differs from ours is left alone and stops the script; --update replaces it.
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
[ -f "$src/Make.sh" ] && [ -f "$src/fix_multisphere.h" ] || fail "$src is not a LIGGGHTS src folder"
version=$(cat "$src/version_liggghts.txt" 2> /dev/null || echo unknown)
[ "$version" = 3.8.0 ] || fail "$src is version $version, expected 3.8.0"

# Calls "$1 OURS THEIRS" for each file.
for_each_file() {
  for file in "$ext"/styles/*.h "$ext"/styles/*.cpp; do
    "$1" "$file" "$src/$(basename "$file")"
  done
  for file in "$ext"/core/include/rodpack/*.h "$ext"/vtk/rodpack/*.h; do
    "$1" "$file" "$src/rodpack/$(basename "$file")"
  done
  # The prefix keeps our sources apart from LIGGGHTS's own: all share one folder there.
  for file in "$ext"/core/src/*.cpp; do
    "$1" "$file" "$src/rodpack_$(basename "$file")"
  done
}

refuse_different() {
  if [ -e "$2" ] && ! cmp -s "$1" "$2"; then
    fail "$2 exists and differs from ours; --update replaces it"
  fi
}

copy() {
  if [ ! -e "$2" ]; then
    cp "$1" "$2"
  elif ! cmp -s "$1" "$2"; then
    cp "$1" "$2"
    echo "replaced $2"
  fi
}

[ "$update" = yes ] || for_each_file refuse_different
mkdir -p "$src/rodpack"
for_each_file copy

# Model combinations to be compiled for the fast path: the user's own lines stay.
list=style_contact_model_user.whitelist
while read -r line; do
  grep -qsxF "$line" "$src/$list" || echo "$line" >> "$src/$list"
done < "$ext/styles/$list"
echo "rodpack's styles are in $src; build it with: make auto"
