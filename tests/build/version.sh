#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
# Usage: version.sh REPOSITORY RODPACK
# The version is the project's and the commit the repository's own; a source that says so already is
# left alone, so that an unchanged tree compiles nothing again.
set -eu
if [ $# != 2 ]; then
  sed -n 's/^# \(Usage: .*\)/\1/p' "$0" >&2
  exit 2
fi
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

# git as it is without this user's settings, in the folder $where
git() {
  GIT_CONFIG_GLOBAL=/dev/null GIT_CONFIG_NOSYSTEM=1 command git -C "$where" \
    -c user.name=test -c user.email=test -c safe.directory='*' "$@"
}

# A tree without git in the repository of someone else, as an unpacked archive may lie.
tree=$work/rodpack
mkdir -p "$tree/liggghts-src-ext" "$tree/postproc"
cp "$repository/liggghts-src-ext/write-version.sh" "$repository/liggghts-src-ext/COMMIT" "$tree/liggghts-src-ext"
cp "$repository/.gitattributes" "$tree"
echo 'project(rodpack VERSION 4.5 DESCRIPTION "")' > "$tree/CMakeLists.txt"
where=$work
git init -q
git commit -q --allow-empty -m other
expect 'const char* version() { return "4.5"; }'
expect 'const char* commit() { return "unknown"; }'

# A repository of its own: clean; with another page, which is in no program; with a new source; changed.
where=$tree
git init -q
git add .
git commit -q -m first
commit=$(git rev-parse --short HEAD)
expect "const char* commit() { return \"$commit\"; }"
touch -d 2000-01-01 "$work/version.cpp"
touch "$tree/README.md" "$tree/postproc/README.md"
expect "const char* commit() { return \"$commit\"; }"
[ "$(date -r "$work/version.cpp" +%Y)" = 2000 ] || fail "the source was written again"
touch "$tree/postproc/new.cpp"
expect "const char* commit() { return \"$commit-dirty\"; }"
rm "$tree/postproc/new.cpp"
expect "const char* commit() { return \"$commit\"; }"
echo '# changed' >> "$tree/CMakeLists.txt"
expect "const char* commit() { return \"$commit-dirty\"; }"

# What git archive makes of it.
archived=$work/archived
mkdir "$archived"
git archive HEAD | tar -x -C "$archived"
tree=$archived
expect "const char* commit() { return \"$commit\"; }"

# A version that would be cut, or none, is an error.
for line in 'project(rodpack VERSION 0.2-rc1 DESCRIPTION "")' 'project(rodpack'; do
  echo "$line" > "$tree/CMakeLists.txt"
  if "$tree/liggghts-src-ext/write-version.sh" "$work/none.cpp" 2> "$work/log"; then fail "took: $line"; fi
  grep -q "CMakeLists.txt: expected a line 'project(rodpack VERSION" "$work/log" || fail "$(cat "$work/log")"
done

# The programs say what is written for them now.
"$repository/liggghts-src-ext/write-version.sh" "$work/version.cpp"
says() { sed -n "s/.*$1() { return \"\(.*\)\"; }/\1/p" "$work/version.cpp"; }
grep -q "^project(rodpack VERSION $(says version) " "$repository/CMakeLists.txt" || fail "version $(says version)"
expected="rodpack $(says version) ($(says commit))"
[ "$("$2" --version)" = "$expected" ] ||
  fail "rodpack --version says '$("$2" --version)', expected '$expected': changed since the last build?"
