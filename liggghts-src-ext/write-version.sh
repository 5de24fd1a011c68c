#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
# Usage: write-version.sh FILE
# Writes the source FILE that defines what core/include/rodpack/version.h declares: the version of
# the repository's CMakeLists.txt and the commit. Leaves a FILE alone that says the same.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
version=$(sed -n 's/^project(rodpack VERSION \([0-9.]*\).*/\1/p' "$root/CMakeLists.txt")
# The ceiling: a tree without git that lies in someone else's repository has no commit.
commit=$(GIT_CEILING_DIRECTORIES=$(dirname "$root") \
  git -c safe.directory='*' -C "$root" describe --always --dirty 2> /dev/null) || commit=unknown

text="// SPDX-License-Identifier: GPL-2.0-or-later
#include \"rodpack/version.h\"

namespace rodpack {

const char* version() { return \"$version\"; }

const char* commit() { return \"$commit\"; }

}  // namespace rodpack"
if [ "$(cat "$1" 2> /dev/null)" != "$text" ]; then
  printf '%s\n' "$text" > "$1"
fi
