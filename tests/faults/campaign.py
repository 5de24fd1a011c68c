#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Does to small runs of the decks with run folders what machines do to runs, and looks at what comes of it.

  campaign.py PROGRAMS WORK [--short] [--seed N] [--deck NAME ...]

PROGRAMS  folder with liggghts and fault_at (build/bin)
WORK      folder for the runs, emptied first
--short   a few faults of each kind, a minute; else every write and some 250 kills, an hour for a deck
--seed N  of the source of chance, default 1
--deck    of inputs/, default all of them

After each fault the same command has to bring the run to the bits of one that nothing happened to, or
it is refused with one line. Exit status 1 where that is not so; the folder of a run that failed is kept.
"""

import argparse
import random
import sys
import time
from pathlib import Path

import kinds
from scene import DECKS, Failure, Scene

# How often, in the long form (None: at each), in the short one, and there with decks that share
# everything but their own text with the first.
PLAN = [
    (kinds.kills_at_random_moments, 200, 4, 2),
    (kinds.kills_at_writes, None, 4, 2),
    (kinds.full_at_writes, None, 4, 1),
    (kinds.small_limits_of_file_size, 30, 2, 0),
    (kinds.small_disks, 30, 2, 0),
    (kinds.folders_that_become_read_only, 5, 1, 0),
    (kinds.folders_that_vanish, 10, 1, 0),
    (kinds.lost_ranks, 20, 1, 0),
    (kinds.other_ranks, 9, 1, 0),
    (kinds.damaged_restarts, 95, 3, 3),
]


def campaign(scene, often, seed):
    """Runs every kind of fault as often as said; the number of kinds with one that went wrong."""
    failures = 0
    for (kind, *_), count in zip(PLAN, often):
        if count == 0:
            continue
        name = kind.__name__.replace("_", " ")
        begin, done = time.monotonic(), 0
        try:
            for _ in kind(scene, random.Random(seed), count):
                done += 1
        except Failure as failure:
            failures += 1
            print(f"FAILED: {name}, after {done}: {failure}", flush=True)
        else:
            note = "" if done else " (not possible here)"
            print(f"{done:4} {name}{note}, {time.monotonic() - begin:.1f} s", flush=True)
    if failures == 0:
        scene.remove()
    return failures


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("programs")
    parser.add_argument("work")
    parser.add_argument("--short", action="store_true")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--deck", nargs="+", choices=DECKS, default=list(DECKS))
    arguments = parser.parse_args()
    failures = 0
    for deck in arguments.deck:
        print(deck, flush=True)
        column = 1 if not arguments.short else 2 if deck == next(iter(DECKS)) else 3
        scene = Scene(arguments.programs, Path(arguments.work) / deck, deck)
        failures += campaign(scene, [row[column] for row in PLAN], arguments.seed)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
