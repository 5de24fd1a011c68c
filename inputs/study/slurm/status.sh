#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
# status.sh JOBID: says running, success or failed, as Snakemake's --cluster-status expects it.
# One squeue for all jobs every few seconds; the states lie in a file in between.
set -eu
list=slurm_jobs.txt
if [ -z "$(find "$list" -newermt '5 seconds ago' 2> /dev/null)" ]; then
  # A controller that does not answer says nothing about the job.
  if squeue --user="$(id -un)" --states=all --noheader --format='%i %T' > "$list.$$" 2> /dev/null; then
    mv "$list.$$" "$list"
  else
    rm -f "$list.$$"
    echo running
    exit 0
  fi
fi
state=$(awk -v job="$1" '$1 == job { print $2 }' "$list")
if [ -z "$state" ]; then
  # Submitted since, or gone from the controller's memory.
  state=$(squeue --jobs="$1" --states=all --noheader --format=%T 2> /dev/null || true)
fi
if [ -z "$state" ]; then
  state=$(sacct --jobs="$1" --allocations --noheader --parsable2 --format=State 2> /dev/null | head -n 1 || true)
fi
case $state in
  COMPLETED) echo success ;;
  PENDING | CONFIGURING | RUNNING | COMPLETING | SUSPENDED | STOPPED | REQUEUED | REQUEUE_HOLD | RESIZING | STAGE_OUT | SIGNALING)
    echo running
    ;;
  *) echo failed ;;
esac
