#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
# Usage: format.sh REPOSITORY
# Every C++ file is as clang-format 14 (Debian 12) leaves it; another version decides otherwise, and
# the check is skipped with it. To mend a file:  clang-format -i FILE
set -eu
cd "$1"

version=$(clang-format --version 2> /dev/null) || version=none
case $version in
  *"version 14."*) ;;
  *)
    echo "skipped: expected clang-format 14, found: $version"
    exit 77
    ;;
esac
off=$(find liggghts-src-ext postproc tests \( -name '*.h' -o -name '*.cpp' \) -print0 |
  xargs -0 -n 1 sh -c 'clang-format "$0" | cmp -s - "$0" || echo "$0"')
if [ -n "$off" ]; then
  echo "FAILED: not formatted (clang-format -i FILE mends it):"
  echo "$off"
  exit 1
fi
