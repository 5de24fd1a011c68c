#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Does to a small deposition what machines do to runs, and looks at what comes of it.

  campaign.py PROGRAMS WORK [--short] [--seed N]

PROGRAMS  folder with liggghts and fault_at (build/bin)
WORK      folder for the runs, emptied first
--short   a few faults of each kind, half a minute; else every write and some 250 kills, an hour
--seed N  of the source of chance, default 1

After each fault the same command has to bring the run to the bits of one that nothing happened to, or
it is refused with one line. Exit status 1 where that is not so; the folder of a run that failed is kept.
"""

import argparse
import random
import sys
import time

import kinds
from scene import Failure, Scene

# How often, in the long form (None: at each) and in the short one.
PLAN = [
    (kinds.kills_at_random_moments, 200, 4),
    (kinds.kills_at_writes, None, 4),
    (kinds.full_at_writes, None, 4),
    (kinds.small_limits_of_file_size, 30, 2),
    (kinds.small_disks, 30, 2),
    (kinds.folders_that_become_read_only, 5, 1),
    (kinds.folders_that_vanish, 10, 1),
    (kinds.lost_ranks, 20, 1),
    (kinds.other_ranks, 9, 1),
    (kinds.damaged_restarts, 95, 3),
]


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("programs")
    parser.add_argument("work")
    parser.add_argument("--short", action="store_true")
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    scene = Scene(arguments.programs, arguments.work)
    failures = 0
    for kind, often, seldom in PLAN:
        name = kind.__name__.replace("_", " ")
        begin, done = time.monotonic(), 0
        try:
            for _ in kind(scene, random.Random(arguments.seed), seldom if arguments.short else often):
                done += 1
        except Failure as failure:
            failures += 1
            print(f"FAILED: {name}, after {done}: {failure}", flush=True)
        else:
            note = "" if done else " (not possible here)"
            print(f"{done:4} {name}{note}, {time.monotonic() - begin:.1f} s", flush=True)
    if failures == 0:
        scene.remove()
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
