#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
# Relative links of all Markdown pages lead to files and headings that exist.
#
#   tests/checks/links.sh [ROOT]     root of the repository, default: here
#
# Prints file:line and the link for each that does not, and fails. Links to the web are not followed.
set -eu
cd "${1:-.}"

# Build trees and results are nobody's pages.
pages() {
  find . -type d \( -path './build*' -o -path ./results -o -path './.*' \) -prune -o -name '*.md' -print |
    sed 's|^\./||' | sort
}

# Lines of a page outside of fenced blocks, without code in backticks; each with its number.
prose() {
  awk '/^ *```/ { fenced = !fenced; next }
       !fenced { gsub(/`[^`]*`/, "`"); print NR ":" $0 }' "$1"
}

# "line target" of each link and picture of a page.
links() {
  prose "$1" | awk '{
    line = $0; sub(/:.*/, "", line)
    while (match($0, /\]\([^) ]+\)/)) {
      print line, substr($0, RSTART + 2, RLENGTH - 3)
      $0 = substr($0, RSTART + RLENGTH)
    }
  }'
}

# The headings of a page as the hosts make anchors of them.
# shellcheck disable=SC1112  # the quotes that headings hold
anchors() {
  awk '/^ *```/ { fenced = !fenced } !fenced && /^#+ /' "$1" |
    sed 's/^#* //; s/\[\([^]]*\)\]([^)]*)/\1/g' | tr '[:upper:]' '[:lower:]' |
    sed 's/–//g; s/—//g; s/’//g; s/°//g; s/…//g; s/→//g; s/[][!"#$%&'"'"'()*+,./:;<=>?@\\^`{|}~]//g; s/ /-/g'
}

if [ -z "$(pages)" ]; then
  echo "links.sh: no pages in $(pwd), expected the root of the repository" >&2
  exit 1
fi
dead=$(
  pages | while read -r page; do
    links "$page" | while read -r line target; do
      case $target in *:*) continue ;; esac
      file=${target%%#*}
      if [ -n "$file" ]; then file=$(dirname "$page")/$file; else file=$page; fi
      if [ ! -e "$file" ]; then
        echo "$page:$line: $target: no such file"
      elif [ "$target" != "${target#*#}" ] && ! anchors "$file" | grep -Fqx -e "${target#*#}"; then
        echo "$page:$line: $target: no such heading"
      fi
    done
  done
)
if [ -n "$dead" ]; then
  printf '%s\n' "$dead" >&2
  exit 1
fi
