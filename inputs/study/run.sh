#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
# From a table of cases to a study: sets the machine up, builds, makes every run that is missing, analyses
# them, compares them.
#
#   inputs/study/run.sh TABLE [OUT=FOLDER] [option ...]
#
# TABLE           inputs/study/reduced.yaml, paper.yaml, miniature.yaml or one of your own (README.md)
# OUT=…           folder of the study, default results/<name of the table>
# --dry-run       says what there is to do and what it costs, then ends
# --no-report     ends with the ensemble
# --runs-only     ends with the runs and their analyses
# --partial       ensemble and report of the runs that succeeded where others have failed
# --per-job N     with a profile: N repetitions of a case in one job of the cluster, default 10
# -j N            runs at a time, default: as many as cores; with a profile: jobs
# others          go to Snakemake: --profile inputs/study/slurm for a cluster
# RODPACK_BIN=…   folder of liggghts and rodpack; then nothing is installed or built
# What is complete stays; what was interrupted goes on. The same command again does what is left.
set -eu
called_from=$PWD
cd "$(dirname "$0")/../.."
here=inputs/study

refuse() {
  echo "inputs/study/run.sh: $1" >&2
  exit 2
}
# absolute PATH: relative ones start where the user is
absolute() {
  case $1 in
    /*) echo "$1" ;;
    *) echo "$called_from/$1" ;;
  esac
}

case "${1:-}" in
  '' | -* | OUT=*)
    echo "inputs/study/run.sh: '${1:-}', expected the table of a study first" >&2
    sed -n '3,/^set/{/^set/!s/^# \{0,1\}//p}' "$here/run.sh" >&2
    exit 2
    ;;
esac
table=$(absolute "$1")
shift
name=$(basename "$table")
out=${OUT:-}
dry=0
target=report
partial=0
jobs=
per_job=10
profile=
# number OPTION VALUE
number() {
  case $2 in '' | 0* | *[!0-9]*) refuse "$1 '$2', expected a number, 1 or more" ;; esac
  echo "$2"
}
# Words that are known here are taken out, the others stay for Snakemake, in their order.
left=$#
while [ "$left" -gt 0 ]; do
  word=$1
  shift
  left=$((left - 1))
  case $word in
    OUT=*) out=${word#OUT=} ;;
    --dry-run | -n) dry=1 ;;
    --no-report) target=ensemble ;;
    --runs-only) target=runs ;;
    --partial) partial=1 ;;
    -j[0-9]*) jobs=$(number -j "${word#-j}") ;;
    -j | --jobs | --cores | --per-job | --profile)
      if [ "$left" = 0 ]; then refuse "$word, expected a value after it"; fi
      case $word in
        --profile) profile=$(absolute "$1") ;;
        --per-job) per_job=$(number "$word" "$1") ;;
        *) jobs=$(number "$word" "$1") ;;
      esac
      shift
      left=$((left - 1))
      ;;
    *) set -- "$@" "$word" ;;
  esac
done
if [ -n "$profile" ] && [ ! -e "$profile/config.yaml" ]; then
  refuse "--profile $profile, expected a folder that holds config.yaml"
fi
case $out in
  '') out=$PWD/results/${name%.yaml} ;;
  *) out=$(absolute "$out") ;;
esac
case $out in
  *[[:space:]]*) refuse "OUT=$out, expected a path without blanks: LIGGGHTS would take it for several words" ;;
esac

# A table that is wrong is refused before anything starts; what that takes is there after the set-up alone.
if [ -z "${RODPACK_BIN:-}" ]; then docker/setup.sh study; fi
# They are looked for, not loaded, which takes longer than all that follows here.
has_modules='import sys; from importlib.util import find_spec; sys.exit(not (find_spec("snakemake") and find_spec("yaml")))'
for python in /usr/bin/python3 python3 ''; do
  if [ -n "$python" ] && "$python" -c "$has_modules" 2> /dev/null; then break; fi
done
if [ -z "$python" ]; then refuse "no python3 that has the modules snakemake and yaml (docker/packages-study.txt)"; fi
export PYTHONDONTWRITEBYTECODE=1
"$python" "$here/study.py" check "$table" "$out"

if [ -z "${RODPACK_BIN:-}" ]; then docker/build.sh; fi
RODPACK_BIN=$(absolute "${RODPACK_BIN:-$PWD/build/bin}")
export RODPACK_BIN
cores=${jobs:-$(nproc)}
if [ "$dry" = 1 ]; then
  exec "$python" "$here/study.py" plan "$table" "$out" "$cores"
fi

# The lock is free when run.sh and all that it has started here are gone, however they went.
mkdir -p "$out/.study" "$out/logs"
exec 8> "$out/.study/lock"
locked=0
flock -n 8 || locked=$?
if [ "$locked" = 1 ]; then
  echo "inputs/study/run.sh: another run.sh, or a run that it has left behind, is at work in $out" >&2
  exit 1
fi
"$python" "$here/study.py" prepare "$table" "$out" "$cores"

log=$out/logs/snakemake.log
if [ -n "$profile" ]; then
  # shellcheck disable=SC2046  # a list of words
  set -- --profile "$profile" --group-components $("$python" "$here/study.py" groups "$out" "$per_job") \
    ${jobs:+--jobs "$jobs"} "$@"
else
  set -- --cores "$cores" "$@"
fi
echo "log     $log"
"$python" "$here/progress.py" "$out" "${PROGRESS_S:-10}" $$ 8>&- &
watch=$!
status=0
interrupted=0
trap 'interrupted=1' INT
"$python" -m snakemake "$target" --snakefile "$here/Snakefile" --directory "$out/.study" \
  --config out="$out" partial="$partial" \
  --nolock --ignore-incomplete --keep-going --rerun-triggers mtime "$@" >> "$log" 2>&1 || status=$?
kill "$watch" 2> /dev/null || true
wait "$watch" 2> /dev/null || true
if [ -t 1 ]; then echo; fi
if [ "$interrupted" = 1 ]; then
  echo "interrupted: the same command goes on from here"
  exit 130
fi
"$python" "$here/study.py" summary "$out" "$status"
