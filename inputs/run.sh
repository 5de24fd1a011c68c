#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
# From a fresh clone to a packing: sets the machine up, builds, runs a scene, analyses it.
#
#   inputs/run.sh SCENE [-var NAME VALUE ...]
#
# SCENE     quick (400 particles, ten seconds), paper (9000 particles, half an hour to one) or economy
#           (the same bed by a cheaper method: inputs/accuracy/README.md), three presets of the
#           deposition; quick is narrower and lower, and orders otherwise: its numbers are not the
#           paper's. Or a scene of its own folder: deposition3d, discharge, discharge3d, incline (minutes)
# -var …    handed to the deck, see inputs/README.md and the scene's own page
# OUT=…     run folder, default results/SCENE; a relative one starts at the root of the repository
# RANKS=n   MPI ranks, default 1
# A run that is complete is not run again; one that was interrupted goes on from its last restart file.
set -eu
cd "$(dirname "$0")/.."

refuse() {
  echo "inputs/run.sh: $1" >&2
  exit 2
}

scene=${1:-}
case $scene in
  quick | paper | economy) deck=deposition ;;
  deposition3d | discharge | discharge3d | incline) deck=$scene ;;
  *)
    echo "inputs/run.sh: scene '$scene', expected quick, paper, economy, deposition3d, discharge, discharge3d or incline" >&2
    sed -n '3,/^set/{/^set/!s/^# \{0,1\}//p}' inputs/run.sh >&2
    exit 2
    ;;
esac
shift
arguments="$scene $*"
out=${OUT:-results/$scene}
ranks=${RANKS:-1}
case $ranks in
  *[!0-9]* | 0*) refuse "RANKS is '$ranks', expected a number of MPI ranks, 1 or more" ;;
esac

# check_variables WORD ...: all of them are -var NAME VALUE, and no NAME is given in another way.
check_variables() {
  given=' '
  while [ $# -gt 0 ]; do
    if [ $# -lt 3 ] || [ "$1" != -var ]; then refuse "'$*', expected -var NAME VALUE"; fi
    case $2 in
      out) refuse "-var out $3: give the run folder as OUT=$3" ;;
      *[!a-zA-Z0-9_]*) refuse "-var $2: expected the name of a parameter of the deck" ;;
      preset) refuse "-var preset $3: give the preset as the first argument" ;;
    esac
    case $given in
      *" $2 "*) refuse "-var $2 is given twice" ;;
    esac
    given="$given$2 "
    shift 3
  done
}
check_variables "$@"

if [ -e "$out/result.json" ] && [ -e "$out/arguments" ] && [ "$(cat "$out/arguments")" != "$arguments" ]; then
  echo "inputs/run.sh: $out holds the run '$(cat "$out/arguments")', not '$arguments':" \
    "choose another folder with OUT=…" >&2
  exit 1
fi

echo "1/4 packages (a minute or two the first time)"
docker/setup.sh
echo "2/4 build of liggghts and rodpack (three to six minutes on two cores the first time)"
docker/build.sh

case $scene in
  quick) takes="ten seconds" ;;
  paper) takes="half an hour to one" ;;
  economy) takes="ten minutes or so" ;;
  *) takes="some minutes" ;;
esac
echo "3/4 run: $out ($takes; every line below is a report of its own)"
if [ -e "$out/result.json" ]; then
  echo "$out is complete: not run again (delete it, or choose another with OUT=…)"
else
  case $scene in
    quick | paper | economy) set -- -var preset "$scene" "$@" ;;
  esac
  DECK=inputs/$deck/in.$deck RANKS=$ranks inputs/deposition/run_one.sh "$out" "$@"
  printf '%s\n' "$arguments" > "$out/arguments"
fi

echo "4/4 analysis and figures"
mkdir -p "$out/analysis"
case $scene in
  quick | paper | economy | deposition3d) build/bin/rodpack analyse "$out" ;;
  discharge)
    build/bin/rodpack discharge "$out" -o "$out/analysis/outflow"
    build/bin/rodpack render "$out/dumps/spheres.*.dump" --colour fsum -o "$out/analysis/packing"
    ;;
  discharge3d) build/bin/rodpack discharge "$out" -o "$out/analysis/outflow" ;;
  incline)
    build/bin/rodpack incline "$out" -o "$out/analysis/chute"
    build/bin/rodpack render "$out/dumps/spheres.*.dump" --colour fsum -o "$out/analysis/packing"
    ;;
esac
echo "Figures:"
find "$out/analysis" \( -name '*.png' -o -name '*.svg' \) | sort
if [ "$scene" = quick ]; then
  echo "quick is a first look, not the paper's scene: in so narrow and low a container particles order otherwise"
  echo "(report.html and the lines above say how). The paper's bed: inputs/run.sh paper"
fi
