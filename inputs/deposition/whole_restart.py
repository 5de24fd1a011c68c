#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Prints the last restart file of a run that is whole; nothing where there is none.

  whole_restart.py RUN_FOLDER

LIGGGHTS writes a restart file under its final name, so that one that was being written when the run
was killed, or when the disk was full, looks like any other; and it reads one that is cut off without a
word. Here the lengths that the file states about itself are added up, as LIGGGHTS's read_restart
goes through it: header, groups, contact law, fixes, then for each rank the number of its numbers
and the numbers. A file is whole when that sum is its size.
"""

import os
import re
import struct
import sys

# Flags of the header whose values are no 4-byte integers (LIGGGHTS 3.8.0's class WriteRestart).
TEXTS = {0, 4, 22}  # version, units, atom style
BIGINTS = {5, 23, 25, 28, 31, 34}  # step, numbers of atoms, bonds, angles, dihedrals, impropers
DOUBLES = range(37, 52)  # box, special factors, tilt
NPROCS, NTYPES, END = 7, 24, -1


class Cut(Exception):
    """The file ends before what it announces, or is none of this deck's."""


class File:
    def __init__(self, stream):
        self.stream = stream
        self.size = os.fstat(stream.fileno()).st_size

    def integer(self):
        data = self.stream.read(4)
        if len(data) < 4:
            raise Cut
        return struct.unpack("=i", data)[0]

    def skip(self, count):
        if count < 0 or self.stream.tell() + count > self.size:
            raise Cut
        self.stream.seek(count, os.SEEK_CUR)

    def skip_text(self):
        self.skip(self.integer())


def is_whole(name):
    try:
        with open(name, "rb") as stream:
            file = File(stream)
            ranks, types = _header(file)
            _groups(file)
            _forces(file, types)
            _fixes(file)
            for _ in range(ranks):
                file.skip(8 * file.integer())
            return stream.tell() == file.size
    except (Cut, OSError):
        return False


def _header(file):
    ranks = types = 0
    while (flag := file.integer()) != END:
        if flag in TEXTS:
            file.skip_text()
        elif flag in BIGINTS or flag in DOUBLES:
            file.skip(8)
        elif 0 <= flag < 37:
            value = file.integer()
            ranks = value if flag == NPROCS else ranks
            types = value if flag == NTYPES else types
        else:
            raise Cut
    return ranks, types


def _groups(file):
    names = file.integer()
    while names > 0:
        length = file.integer()
        file.skip(length)
        names -= length > 0  # a deleted group has left an empty name


def _forces(file, types):
    if file.integer() != END:  # masses by type: atom style granular has none
        raise Cut
    while (flag := file.integer()) != END:
        if flag != 0:  # pair style; bonds and the like do not occur
            raise Cut
        file.skip_text()
        file.skip(8 + 4 * (types * (types + 1) // 2))  # the contact law's number, set pairs


def _fixes(file):
    for _ in range(file.integer()):  # with a global state: id, style, state
        for _ in range(3):
            file.skip_text()
    for _ in range(file.integer()):  # with a state by atom: id, style, largest size
        file.skip_text()
        file.skip_text()
        file.skip(4)


def last_whole(folder):
    """Path of the last whole restart file of a run folder, or None."""
    files = {}
    restart = os.path.join(folder, "restart")
    for name in os.listdir(restart) if os.path.isdir(restart) else []:
        match = re.fullmatch(r"deposition\.(\d+)\.restart", name)
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
