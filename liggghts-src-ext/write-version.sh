#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
# Usage: write-version.sh FILE
# Writes the source FILE that defines what core/include/rodpack/version.h declares: the version of
# the repository's CMakeLists.txt and the commit, which git knows, or COMMIT, where `git archive` wrote
# it. Leaves a FILE alone that says the same.
set -eu
if [ $# != 1 ]; then
  sed -n 's/^# \(Usage: .*\)/\1/p' "$0" >&2
  exit 2
fi
root=$(cd "$(dirname "$0")/.." && pwd)
version=$(sed -n 's/^project(rodpack VERSION \([0-9][0-9.]*\)\([ )].*\)\{0,1\}$/\1/p' "$root/CMakeLists.txt")
if [ -z "$version" ]; then
  echo "write-version.sh: $root/CMakeLists.txt: expected a line 'project(rodpack VERSION 1.2 …'" >&2
  exit 1
fi
# The ceiling: a tree without git that lies in someone else's repository has no commit of its own.
git() {
  GIT_CEILING_DIRECTORIES=$(dirname "$root") \
    command git --no-optional-locks -c safe.directory='*' -C "$root" "$@"
}
if commit=$(git describe --always 2> /dev/null); then
  # What the programs are made of, new files too; another page or deck makes no other program.
  changed=$(git status --porcelain --untracked-files=normal -- \
    CMakeLists.txt liggghts-src-ext postproc ':(exclude)*.md')
  if [ -n "$changed" ]; then commit=$commit-dirty; fi
else
  commit=$(cat "$root/liggghts-src-ext/COMMIT" 2> /dev/null) || commit=unknown
  case $commit in '' | *[!0-9a-f]*) commit=unknown ;; esac
fi

text="// SPDX-License-Identifier: GPL-2.0-or-later
#include \"rodpack/version.h\"

namespace rodpack {

const char* version() { return \"$version\"; }

const char* commit() { return \"$commit\"; }

}  // namespace rodpack"
if [ "$(cat "$1" 2> /dev/null)" != "$text" ]; then
  printf '%s\n' "$text" > "$1"
fi
