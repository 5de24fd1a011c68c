#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
# Brings one run to its end: starts it, goes on with it, or leaves it alone when it is complete.
#
#   inputs/deposition/run_one.sh RUN_FOLDER -var NAME VALUE ...
#
# -var …      handed to the deck; "out" and "resume" are set here
# DECK=…      a deck with a run folder, default in.deposition beside this script
# RANKS=n     MPI ranks, default 1
# LIGGGHTS=…  program, default build/bin/liggghts
# ASIDE=…     where a run goes that was interrupted before its first restart file, default: beside it
# A run that was interrupted goes on from its last restart file that is whole (whole_restart.py). Two
# calls for one folder: the second waits until the first, and its LIGGGHTS, have ended.
# Exit status: 0 when the run is complete, that of LIGGGHTS, or 1 when a signal has stopped it.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
refuse() {
  echo "run_one.sh: $1" >&2
  exit 2
}

[ $# -gt 0 ] || refuse "expected a run folder, then -var NAME VALUE ..."
out=$1
shift
case $out in
  -*) refuse "run folder '$out' begins with -: write ./$out" ;;
esac
case ${RANKS:-1} in
  *[!0-9]* | 0*) refuse "RANKS is '$RANKS', expected a number of MPI ranks, 1 or more" ;;
esac
deck=${DECK:-$here/in.deposition}
{ [ -f "$deck" ] && [ -r "$deck" ]; } || refuse "DECK is '$deck', expected a deck that can be read"

# The run has come to its end; an empty file is one that was being written.
is_complete() {
  [ -s "$out/result.json" ] && [ "$(tail -c 2 "$out/result.json")" = '}' ]
}

parent=$(dirname "$out")
mkdir -p "$parent"
# Kept open by LIGGGHTS, too: the lock is free when the last of them is gone, however it went.
exec 9> "$parent/.lock.$(basename "$out")"
locked=0
flock -n 9 || locked=$?
case $locked in
  0) ;;
  1)
    echo "$out: another process is at it: waiting"
    flock 9
    ;;
  *) echo "$out: no locks on this file system: make sure that nobody else is at it" ;;
esac

if is_complete; then
  echo "$out is complete: not run again"
  exit 0
fi
if [ -e "$out" ] && [ ! -e "$out/parameters.json" ] && [ -n "$(find "$out" -type f ! -name .lock ! -name parameters.json.part | head -n 1)" ]; then
  echo "$out exists and is not a run folder: choose another" >&2
  exit 1
fi
last=$(python3 "$here/whole_restart.py" "$out")
if [ -n "$last" ]; then
  echo "$out was interrupted: going on from $last"
  set -- "$@" -var resume "$last"
elif [ -e "$out" ]; then
  aside=${ASIDE:-$parent}/$(basename "$out").interrupted.$(date +%Y%m%d-%H%M%S)
  echo "$out was interrupted before its first restart file: moved to $aside"
  mkdir -p "$(dirname "$aside")"
  mv "$out" "$aside"
fi

launcher=
if [ "${RANKS:-1}" -gt 1 ]; then
  export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
  # Runs side by side would bind their ranks to the same cores.
  launcher="mpiexec --oversubscribe --bind-to none -np $RANKS"
fi
# The deck opens the run's log; before that there is none, which runs side by side would share.
$launcher "${LIGGGHTS:-$here/../../build/bin/liggghts}" -log none \
  -in "$deck" -var out "$out" "$@"
# LIGGGHTS ends well, too, when the deck has said an error and quit.
if ! is_complete; then
  echo "$out is not complete: the same command goes on from its last restart file" >&2
  exit 1
fi
