#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
# Usage: fetch-liggghts.sh FOLDER
# Downloads the distribution's source package of LIGGGHTS 3.8.0 into FOLDER, through a deb-src copy
# of the machine's own apt sources that lives in FOLDER: needs no root, changes nothing in /etc.
set -eu
folder=$(cd "$1" && pwd)
apt=$folder/apt

command -v apt-get > /dev/null || { echo "this machine has no apt-get" >&2; exit 1; }
rm -rf "$apt"
mkdir -p "$apt/parts" "$apt/lists/partial" "$apt/cache/archives/partial"
for file in /etc/apt/sources.list /etc/apt/sources.list.d/*.list; do
  if [ -f "$file" ]; then
    sed -n 's/^[[:space:]]*deb[[:space:]]/deb-src /p' "$file" > "$apt/parts/$(basename "$file" .list).list"
  fi
done
for file in /etc/apt/sources.list.d/*.sources; do
  if [ -f "$file" ]; then
    sed 's/^Types:.*/Types: deb-src/' "$file" > "$apt/parts/$(basename "$file")"
  fi
done

set -- -qq -o Dir::Etc::sourceparts="$apt/parts" -o Dir::Etc::sourcelist=/dev/null \
  -o Dir::State::Lists="$apt/lists" -o Dir::Cache="$apt/cache" \
  -o APT::Sandbox::User="$(id -un)" -o Acquire::Languages=none
apt-get "$@" update >&2
cd "$folder"
apt-get "$@" source --tar-only --download-only liggghts >&2
rm -rf "$apt"
