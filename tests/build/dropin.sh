#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
# Usage: dropin.sh REPOSITORY SOURCE WORK MPI_COMPILER
# What liggghts-src-ext/README.md tells the user of an own LIGGGHTS tree to do, as far as it takes to
# prove that the styles are registered and compile there. SOURCE: the tarball or folder to start from.
set -eu
if [ $# != 4 ]; then
  sed -n 's/^# \(Usage: .*\)/\1/p' "$0" >&2
  exit 2
fi
ext=$1/liggghts-src-ext
tree=$3/src
compiler=$4

fail() {
  echo "FAILED: $1" >&2
  exit 1
}

rm -rf "$3"
mkdir -p "$tree"
if [ -d "$2" ]; then
  if [ -d "$2/src" ]; then cp -r "$2/src/." "$tree"; else cp -r "$2/." "$tree"; fi
else
  tar -xf "$2" -C "$tree" --strip-components=2 --wildcards '*/src/*'
fi

# The build's own way with such a tree: it takes it, and leaves it as it was.
before=$(cat "$tree"/*.* | cksum)
cmake -DLIGGGHTS_SOURCE="$3" -DLIGGGHTS_WORK="$3/staged" -P "$ext/StageLiggghts.cmake"
[ "$before" = "$(cat "$tree"/*.* | cksum)" ] || fail "staging wrote into the user's tree"

"$ext/install-into.sh" "$tree"
"$ext/install-into.sh" "$tree"  # again: nothing differs, nothing to refuse
(cd "$tree" && sh -eu -c "$(sed -n 's/^ *\(sed -i .*\)/\1/p' "$ext/README.md")")

# As `make auto` does. The stock list of combinations is taken over: making it takes Make.sh a minute.
cp "$3/staged/src/style_contact_model.whitelist" "$tree"
(cd "$tree" && sh Make.sh style && sh Make.sh models > /dev/null)
grep -l '^#ifdef [A-Z]*_\(CLASS\|MODEL\)' "$ext"/styles/*/*.h | sed 's|.*/\(.*\)|"\1"|' > "$3/registered"
[ "$(wc -l < "$3/registered")" -gt 10 ] || fail "the headers that register styles were not found"
cat "$tree"/style_*.h > "$3/lists"
while read -r name; do
  grep -qF "$name" "$3/lists" || fail "$name is in no style list"
done < "$3/registered"
while read -r combination; do
  grep -qF "$combination" "$tree/style_contact_model.h" || fail "not whitelisted: $combination"
done < "$ext/styles/contact/style_contact_model_user.whitelist"
cmp "$tree/style_contact_model.h" "$3/staged/src/style_contact_model.h" ||
  fail "the two ways compile different contact-model combinations"

# Each source of ours finds what it includes, in whichever room that lies here.
cd "$tree"
for source in "$ext"/styles/*/*.cpp; do
  "$compiler" -std=c++14 -M "$(basename "$source")" > deps || fail "$source does not find its headers"
done

# modify.cpp sees every fix and compute, ours with what they include from the core.
# dump_stress_goldhirsch.cpp is one that finds its way without VTK, too. Of the core, a room at a time, but
# for the loops of one kind of processor.
for room in "$ext"/core/src/*/; do
  room=$(basename "$room")
  if [ "$room" != planar_simd ]; then
    for source in "$ext/core/src/$room"/*.cpp; do
      echo "#include \"rodpack_${room}_$(basename "$source")\""
    done > "room_$room.cpp"
  fi
done
for source in modify.cpp dump_stress_goldhirsch.cpp room_*.cpp rodpack_planar_simd_*.cpp rodpack_version.cpp; do
  "$compiler" -std=c++14 -w -fsyntax-only "$source" || fail "$source does not compile in the tree"
done
rm room_*.cpp

# A file of the user's that has our name stays, and is named.
echo "// mine" > rodpack/geometry/chain_geometry.h
if "$ext/install-into.sh" . 2> refusal; then fail "overwrote a file that differs"; fi
grep -q 'rodpack/geometry/chain_geometry.h exists and differs' refusal || fail "refusal: $(cat refusal)"
grep -qx '// mine' rodpack/geometry/chain_geometry.h || fail "overwrote a file that differs"
"$ext/install-into.sh" --update . | grep -q '^replaced' || fail "--update did not replace"

# The commit of an earlier install is no difference to refuse.
sed -i 's/commit() { return ".*"/commit() { return "earlier"/' rodpack_version.cpp
"$ext/install-into.sh" . | grep -qx 'replaced ./rodpack_version.cpp' || fail "kept an earlier commit"

# What another version has left would be compiled beside what took its place.
touch rodpack_line_rule.cpp
if "$ext/install-into.sh" . 2> refusal; then fail "left a source of another version"; fi
grep -q 'rodpack_line_rule.cpp is of another version' refusal || fail "refusal: $(cat refusal)"
"$ext/install-into.sh" --update . | grep -qx 'removed ./rodpack_line_rule.cpp' ||
  fail "--update did not remove a source of another version"

echo 3.7.0 > version_liggghts.txt
if "$ext/install-into.sh" . 2> refusal; then fail "took version 3.7.0"; fi
grep -q 'is version 3.7.0, expected 3.8.0' refusal || fail "refusal: $(cat refusal)"
