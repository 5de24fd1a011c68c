#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
# Usage: format.sh REPOSITORY
# Every source, script and deck names its licence in its first lines, and every C++ file is as
# clang-format 14 (Debian 12) leaves it; another version decides otherwise, and with it that half is
# skipped. To mend a file:  clang-format -i FILE
set -eu
if [ $# != 1 ]; then
  sed -n 's/^# \(Usage: .*\)/\1/p' "$0" >&2
  exit 2
fi
cd "$1"

bare=$(find CMakeLists.txt docker inputs liggghts-src-ext postproc tests -type f \( -name '*.h' \
  -o -name '*.cpp' -o -name '*.sh' -o -name '*.cmake' -o -name '*.awk' -o -name 'in.*' \
  -o -name CMakeLists.txt -o -name Dockerfile \) -print0 |
  xargs -0 awk 'FNR <= 3 && /SPDX-License-Identifier: GPL-2.0-or-later$/ { named[FILENAME] }
    END { for (k = 1; k < ARGC; ++k) if (!(ARGV[k] in named)) print ARGV[k] }')
if [ -n "$bare" ]; then
  echo "FAILED: no line 'SPDX-License-Identifier: GPL-2.0-or-later' among the first three:"
  echo "$bare"
  exit 1
fi

version=$(clang-format --version 2> /dev/null) || version=none
case $version in
  *"version 14."*) ;;
  *)
    echo "skipped: expected clang-format 14, found: $version"
    # The machine that decides about a change has all tools.
    if [ "${CI:-}" = true ]; then exit 1; fi
    exit 77
    ;;
esac
# Many files to a program, whose start takes longer than most files. It shows the first place of each file
# that is otherwise.
if ! off=$(find liggghts-src-ext postproc tests \( -name '*.h' -o -name '*.cpp' \) -print0 |
  xargs -0 -n 40 -P "$(nproc)" clang-format --dry-run --Werror --ferror-limit=1 2>&1); then
  echo "FAILED: not formatted (clang-format -i FILE mends it):"
  echo "$off"
  exit 1
fi
