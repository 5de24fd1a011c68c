#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
# Usage: dropin.sh REPOSITORY STAGED_SRC WORK MPI_COMPILER
# What liggghts-src-ext/README.md tells the user of an own LIGGGHTS tree to do, as far as it takes to
# prove that the styles are registered and compile there.
set -eu
ext=$1/liggghts-src-ext
tree=$3/src
compiler=$4

fail() {
  echo "FAILED: $1" >&2
  exit 1
}

rm -rf "$3"
mkdir -p "$tree"
# The stock files: all but our links and the lists derived with them.
find "$2" -maxdepth 1 -type f ! -name 'style_*.h' -exec cp -p {} "$tree" \;

# The build's own way with such a tree: it takes it, and leaves it as it was.
before=$(cat "$tree"/* | cksum)
cmake -DLIGGGHTS_SOURCE="$3" -DLIGGGHTS_WORK="$3/staged" -P "$ext/StageLiggghts.cmake"
[ "$before" = "$(cat "$tree"/* | cksum)" ] || fail "staging wrote into the user's tree"

"$ext/install-into.sh" "$tree"
"$ext/install-into.sh" "$tree"  # again: nothing differs, nothing to refuse

# As `make auto` does.
(cd "$tree" && sh Make.sh style && sh Make.sh models > /dev/null)
for header in "$ext"/styles/*.h; do
  name=$(basename "$header")
  if grep -q '^#ifdef [A-Z]*_\(CLASS\|MODEL\)' "$header"; then
    cat "$tree"/style_*.h | grep -qF "\"$name\"" || fail "$name is in no style list"
  fi
done
while read -r combination; do
  grep -qF "$combination" "$tree/style_contact_model.h" || fail "not whitelisted: $combination"
done < "$ext/styles/style_contact_model_user.whitelist"

# modify.cpp sees every fix and compute, ours with what they include from the core.
cd "$tree"
for source in modify.cpp rodpack_*.cpp; do
  "$compiler" -std=c++14 -w -fsyntax-only "$source" || fail "$source does not compile in the tree"
done

# A file of the user's that has our name stays, and is named.
echo "// mine" > rodpack/chain_geometry.h
if "$ext/install-into.sh" . 2> refusal; then fail "overwrote a file that differs"; fi
grep -q 'rodpack/chain_geometry.h exists and differs' refusal || fail "refusal: $(cat refusal)"
grep -qx '// mine' rodpack/chain_geometry.h || fail "overwrote a file that differs"
"$ext/install-into.sh" --update . | grep -q '^replaced' || fail "--update did not replace"

echo 3.7.0 > version_liggghts.txt
if "$ext/install-into.sh" . 2> refusal; then fail "took version 3.7.0"; fi
grep -q 'is version 3.7.0, expected 3.8.0' refusal || fail "refusal: $(cat refusal)"
