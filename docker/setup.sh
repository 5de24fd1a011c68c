#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
# Installs what packages.txt lists and this machine lacks, with the argument "study" what packages-study.txt
# lists as well, with "tests" that and what packages-tests.txt lists; does nothing when all is there.
# RODPACK_SKIP_SETUP=1 skips it: for machines where the same software comes in another way.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
case "${1:-}" in
  '') wanted=$(sed 's/#.*//' "$here/packages.txt") ;;
  study) wanted=$(sed 's/#.*//' "$here/packages.txt" "$here/packages-study.txt") ;;
  tests) wanted=$(sed 's/#.*//' "$here/packages.txt" "$here/packages-study.txt" "$here/packages-tests.txt") ;;
  *)
    echo "docker/setup.sh: no argument, study or tests; not '$1'" >&2
    exit 2
    ;;
esac

if [ "${RODPACK_SKIP_SETUP:-0}" = 1 ]; then exit 0; fi
if ! command -v apt-get > /dev/null || ! command -v dpkg-query > /dev/null; then
  echo "docker/setup.sh: no apt on this machine: install the counterparts of docker/packages*.txt" \
    "and set RODPACK_SKIP_SETUP=1, or use docker/Dockerfile" >&2
  exit 1
fi

missing=
for package in $wanted; do
  if [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2> /dev/null)" != installed ]; then
    missing="$missing $package"
  fi
done
if [ -z "$missing" ]; then exit 0; fi

as_root=
if [ "$(id -u)" != 0 ]; then
  if ! command -v sudo > /dev/null; then
    echo "docker/setup.sh: neither root nor sudo; ask for these packages:$missing" >&2
    exit 1
  fi
  as_root=sudo
fi
echo "Installing:$missing"
$as_root apt-get -qq update
# shellcheck disable=SC2086  # a list of words
$as_root env DEBIAN_FRONTEND=noninteractive apt-get -qq install -y --no-install-recommends $missing
