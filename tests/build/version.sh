#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
# Usage: version.sh REPOSITORY RODPACK
# The version is the project's and the commit the repository's own; a source that says so already is
# left alone, so that an unchanged tree compiles nothing again.
set -eu
repository=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

fail() {
  echo "FAILED: $1" >&2
  exit 1
}

# expect LINE: the source says that
expect() {
  "$tree/liggghts-src-ext/write-version.sh" "$work/version.cpp"
  grep -qxF "$1" "$work/version.cpp" || fail "expected '$1' in: $(cat "$work/version.cpp")"
}

# A tree without git in the repository of someone else, as an unpacked archive may lie.
git() { command git -C "$work" -c user.name=test -c user.email=test "$@"; }
tree=$work/rodpack
mkdir -p "$tree/liggghts-src-ext"
cp "$repository/liggghts-src-ext/write-version.sh" "$tree/liggghts-src-ext"
echo 'project(rodpack VERSION 4.5 DESCRIPTION "")' > "$tree/CMakeLists.txt"
git init -q
git commit -q --allow-empty -m other
expect 'const char* version() { return "4.5"; }'
expect 'const char* commit() { return "unknown"; }'

# A repository of its own, clean and changed.
git() { command git -C "$tree" -c user.name=test -c user.email=test "$@"; }
git init -q
git add .
git commit -q -m first
commit=$(git rev-parse --short HEAD)
expect "const char* commit() { return \"$commit\"; }"
touch -d 2000-01-01 "$work/version.cpp"
expect "const char* commit() { return \"$commit\"; }"
[ "$(date -r "$work/version.cpp" +%Y)" = 2000 ] || fail "the source was written again"
echo '# changed' >> "$tree/CMakeLists.txt"
expect "const char* commit() { return \"$commit-dirty\"; }"

# The programs say what was written for them.
"$repository/liggghts-src-ext/write-version.sh" "$work/version.cpp"
version=$(sed -n 's/.*version() { return "\(.*\)"; }/\1/p' "$work/version.cpp")
grep -q "^project(rodpack VERSION $version " "$repository/CMakeLists.txt" || fail "version $version"
case $("$2" --version) in
  "rodpack $version ("?*")") ;;
  *) fail "rodpack --version says: $("$2" --version)" ;;
esac
