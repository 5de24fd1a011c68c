#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Prints the last restart file of a run that is whole; nothing where there is none.

  whole_restart.py RUN_FOLDER

A file is whole when its last line, the seal, states its length and its checksum
(liggghts-src-ext/stock/restart_seal.h); liggghts refuses any other.
"""

import os
import re
import sys
import zlib

SEAL = re.compile(rb"rodpack-restart-1 ([0-9a-f]{16}) [0-9a-f]{16} ([0-9a-f]{8})\n")
SEAL_SIZE = 61


def is_whole(name):
    try:
        with open(name, "rb") as file:
            content = file.read()
    except OSError:
        return False
    seal = SEAL.fullmatch(content[-SEAL_SIZE:])
    return (
        seal is not None
        and int(seal[1], 16) == len(content)
        and int(seal[2], 16) == zlib.crc32(content[:-SEAL_SIZE])
    )


def last_whole(folder):
    """Path of the last whole restart file of a run folder, or None."""
    files = {}
    restart = os.path.join(folder, "restart")
    for name in os.listdir(restart) if os.path.isdir(restart) else []:
        match = re.fullmatch(r"\w+\.(\d+)\.restart", name)
        if match:
            files[int(match[1])] = os.path.join(restart, name)
    return next((files[step] for step in sorted(files, reverse=True) if is_whole(files[step])), None)


def main():
    if len(sys.argv) != 2:
        print("usage: whole_restart.py RUN_FOLDER", file=sys.stderr)
        return 2
    file = last_whole(sys.argv[1])
    if file:
        print(file)
    return 0


if __name__ == "__main__":
    sys.exit(main())
