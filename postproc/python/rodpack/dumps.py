# SPDX-License-Identifier: GPL-2.0-or-later
"""Dumps of bodies, spheres and contacts: LIGGGHTS text dumps, plain or .gz, one frame in memory at a time.

The columns are explained in liggghts-src-ext/doc/dump_multisphere_body.md, dump_multisphere_sphere.md and
dump_contact_gran.md; all values are in SI units, angles in rad.
"""

import os
import re
import sys

import numpy as np

from .errors import FormatError, first_repeated, listed, no_such_column, printable, shortened
from .named_arrays import NamedArrays
from .text import MOST_NUMBERS, Lines, number, whole_number

# Whole numbers up to here are read by way of a double to the last digit; no larger one becomes one of them.
LARGEST_WHOLE = 2**53 - 1

# Columns of whole numbers, lowest and highest value.
WHOLE = {name: (0, LARGEST_WHOLE) for name in
         ("id", "type", "body", "body_i", "body_j", "sphere_i", "sphere_j",
          "type_i", "type_j")}
WHOLE.update(nspheres=(1, 10**6), wall=(0, 1))

_TEXT_AT_A_TIME = 2**23  # bytes of memory for the text of rows

_FLAG = re.compile(r"[fpsm]{2}")


class Frame(NamedArrays):
    """One frame of a dump: a mapping from the names of the columns to arrays, one value per row.

    frame["x"]: float64, or int64 for ids, `type`, `nspheres` and `wall`; FormatError for a column that is
    not there. dict(frame) is a dict of arrays; len(frame) the number of columns, frame.rows that of rows.

    file, line: where the columns are named; step: the timestep; time: s, where the dump says it, else None;
    box: 3 x 2, lo and hi of x, y, z, m; periodic: three truth values; units: "si", others are refused;
    kind: "bodies", "spheres", "contacts", or None for a dump with other columns; names: of the columns.
    """

    units = "si"

    def __init__(self, file, line, step, time, box, periodic, columns):
        self.file, self.line, self.step, self.time = file, line, step, time
        self.box, self.periodic = box, periodic
        self._columns = columns
        self.names = tuple(columns)
        self.rows = len(columns[self.names[0]])
        marks = {"body_i": "contacts", "body": "spheres", "half_length": "bodies"}
        self.kind = next((kind for name, kind in marks.items() if name in columns), None)

    def __getitem__(self, name):
        if name not in self._columns:
            raise no_such_column(self.file, self.line, name, self.names)
        return self._columns[name]

    def __repr__(self):
        return f"<{self.kind or 'dump'} of step {self.step}: {self.rows} rows of {' '.join(self.names)}>"

    def stack(self, *names):
        """Columns side by side: frame.stack("x", "y", "z") is rows x 3."""
        return np.stack([self[name] for name in names], axis=-1)

    def records(self):
        """The frame as a NumPy structured array, a record per row."""
        records = np.empty(self.rows, [(name, self[name].dtype) for name in self.names])
        for name in self.names:
            records[name] = self[name]
        return records


class Dump:
    """The frames of one or several dump files in order of time, read anew by each `for`, one at a time.

    files: names, in order of their first step.
    """

    def __init__(self, files, last_step=None):
        self._last_step = last_step
        starts = sorted((first_step(file), os.fspath(file)) for file in files)
        for (step, before), (again, file) in zip(starts, starts[1:]):
            if step == again:
                raise FormatError(file, None, f"expected each step once, found step {step} as in {before}")
        if last_step is not None:
            later = starts
            starts = [(step, file) for step, file in starts if step <= last_step]
            if later and not starts:
                step, file = later[0]
                raise FormatError(file, None, f"expected a frame up to step {last_step}, at which the run "
                                              f"ended, found step {step} as the first")
        self._starts = starts
        self.files = tuple(file for _, file in starts)

    def __iter__(self):
        """Reads frame by frame. FormatError at the first that is malformed or whose step came before."""
        seen = {}
        for file in self.files:
            for frame in _frames(file):
                if frame.step in seen:
                    raise FormatError(file, frame.line, f"expected each step once, found step {frame.step} "
                                                        f"again, as at {seen[frame.step]}")
                seen[frame.step] = f"{file}:{frame.line}"
                if self._last_step is None or frame.step <= self._last_step:
                    yield frame

    def last(self):
        """The last frame. LookupError where there is none."""
        frame = None
        for frame in Dump(self.files[-1:], self._last_step):
            pass
        if frame is None:
            raise LookupError("no dump file given")
        return frame

    def at(self, step):
        """The frame of a step. LookupError where there is none."""
        earlier = [file for start, file in self._starts if start <= step]
        for frame in Dump(earlier[-1:], self._last_step):
            if frame.step == step:
                return frame
        raise LookupError(f"no frame of step {step} in {printable(' '.join(self.files[:1]))}"
                          f"{' and those after it' if len(self.files) > 1 else ''}")


def read_dump(files):
    """The frames of a dump file, plain or .gz, or of a list of such files, as a Dump:

        for frame in read_dump("dumps/bodies.100000.dump"):
            print(frame.step, frame["x"].mean())

    Frames are read when they are asked for. FormatError names file, line, what was found and what was
    expected: a frame cut short, rows with other than the named columns, anything but finite numbers, ids
    that are not whole, a particle or contact that stands twice, a tilted box, other units than SI, a step
    that comes twice, a file without a frame.
    """
    return Dump([files] if isinstance(files, (str, os.PathLike)) else files)


def first_step(file):
    """The step of the first frame of a file. FormatError where there is none."""
    with Lines(file) as lines:
        start = _read_start(lines)
        if start is None:
            raise FormatError(lines.file, None, "no frame in this file")
        return start[0]


def _frames(file):
    with Lines(file) as lines:
        start = _read_start(lines)
        if start is None:
            raise FormatError(lines.file, None, "no frame in this file")
        while start is not None:
            frame = _read_frame(lines, *start)
            # Before the frame is handed out: rows beyond its count, and a checksum that does not fit, show
            # in what follows.
            start = _read_start(lines)
            yield frame


def _read_start(lines):
    """Step and time (None where it is not said) of the frame that begins here; None at the file's end."""
    line = ""
    while line == "":
        line = lines.next()
        if line is None:
            return None
    time = None
    if line == "ITEM: UNITS":
        units = lines.need("the units")
        if units != "si":
            lines.fail(f"expected a dump in SI units ('si'), found units '{shortened(units)}'")
        line = lines.need("'ITEM: TIMESTEP'")
    if line == "ITEM: TIME":
        text = lines.need("a time")
        time = number(text.strip())
        if time is None:
            lines.fail(f"expected a time in s, found '{shortened(text)}'")
        line = lines.need("'ITEM: TIMESTEP'")
    if not line.startswith("ITEM: TIMESTEP"):
        surplus = lines.number > 1 and not line.startswith("ITEM:")
        lines.fail(f"expected 'ITEM: TIMESTEP', found '{shortened(line)}'"
                   + (" (more rows than the frame's count states?)" if surplus else ""))
    return _read_count(lines, "a timestep"), time


def _read_count(lines, what):
    text = lines.need(f"{what} (whole number)")
    value = whole_number(text.strip())
    if value is None or not 0 <= value <= LARGEST_WHOLE:
        lines.fail(f"expected {what} (whole number of 0 to {LARGEST_WHOLE}), found '{shortened(text)}'")
    return value


def _read_frame(lines, step, time):
    line = lines.need("'ITEM: NUMBER OF ...'")
    if not line.startswith("ITEM: NUMBER OF "):
        lines.fail(f"expected 'ITEM: NUMBER OF ...', found '{shortened(line)}'")
    rows = _read_count(lines, "the number of rows")
    box, periodic = _read_box(lines)
    names = _read_names(lines)
    header = lines.number
    if rows * len(names) > MOST_NUMBERS:
        lines.fail(f"expected a frame of at most {MOST_NUMBERS} numbers, found one of {rows} rows and "
                   f"{len(names)} columns")
    values = _read_rows(lines, names, rows)
    columns = {}
    for index, name in enumerate(names):
        columns[name] = np.ascontiguousarray(values[:, index])
        if name in WHOLE:
            columns[name] = _whole(lines.file, header, name, columns[name])
    _refuse_repeated_rows(lines.file, header, columns, values)
    return Frame(lines.file, header, step, time, box, periodic, columns)


def _read_box(lines):
    """Bounds and periodic directions of an upright box; a tilted one has other words or a third number."""
    line = lines.need("'ITEM: BOX BOUNDS ...'")
    if not line.startswith("ITEM: BOX BOUNDS"):
        lines.fail(f"expected 'ITEM: BOX BOUNDS ...', found '{shortened(line)}'")
    flags = line[len("ITEM: BOX BOUNDS"):].split()
    if flags and not (len(flags) == 3 and all(_FLAG.fullmatch(flag) for flag in flags)):
        lines.fail("expected the three boundary flags of an upright box, such as 'ff ff pp', found "
                   f"'{shortened(line)}' (a tilted box?)")
    box = np.empty((3, 2))
    for bounds in box:
        line = lines.need("a line 'lo hi' of the box bounds")
        found = [number(word) for word in line.split()]
        if len(found) != 2 or None in found or not found[0] < found[1]:
            lines.fail("expected two numbers lo < hi (the bounds of an upright box), found "
                       f"'{shortened(line)}'")
        bounds[:] = found
    return box, tuple(flag[0] == "p" for flag in flags) or (False,) * 3


def _read_names(lines):
    line = lines.need("'ITEM: ATOMS' or 'ITEM: ENTRIES' with the names of the columns")
    words = line.split()
    if words[:1] != ["ITEM:"] or words[1:2] not in (["ATOMS"], ["ENTRIES"]):
        lines.fail(f"expected 'ITEM: ATOMS' or 'ITEM: ENTRIES', found '{shortened(line)}'")
    names = words[2:]
    if not names:
        lines.fail("this line names no columns")
    twice = first_repeated(names)
    if twice is not None:
        lines.fail(f"expected each column once, found '{shortened(twice)}' twice")
    lines.need_line_end()
    return names


def _read_rows(lines, names, count):
    parts, read = [np.empty((0, len(names)))], 0
    while read < count:
        first = lines.number + 1
        texts = _read_texts(lines, count, read)
        parts.append(_numbers(lines.file, first, names, texts))
        read += len(texts)
    return np.concatenate(parts)


def _read_texts(lines, count, read):
    """The next rows of `count`, of which `read` have been read: as many as make some text in memory, since
    rows may be far longer than their numbers."""
    texts, size = [], 0
    while read + len(texts) < count and size < _TEXT_AT_A_TIME:
        line = lines.next()
        if line is None:
            lines.fail(f"the frame is cut short here: expected {count} rows, found {read + len(texts)}")
        if line.startswith("ITEM:"):
            lines.fail(f"the frame has too few rows: expected {count}, found {read + len(texts)}")
        lines.need_line_end()
        texts.append(line)
        size += sys.getsizeof(line)
    return texts


def _numbers(file, first, names, texts):
    """The numbers of rows, of which the first stands in line `first`."""
    # NumPy says neither line nor field of what it does not take, and takes "nan" and rows that are all short
    # alike: what is not plainly right is looked at again, word by word.
    try:
        values = np.loadtxt(texts, comments=None, ndmin=2) if any(map(str.strip, texts)) else np.empty(0)
    except ValueError:
        values = np.empty(0)
    if values.shape == (len(texts), len(names)) and np.isfinite(values).all():
        return values
    return np.array([_row(file, first + index, names, text) for index, text in enumerate(texts)])


def _row(file, line, names, text):
    words = text.split()
    if len(words) != len(names):
        raise FormatError(file, line, f"expected {len(names)} fields ({listed(names)}), found {len(words)}")
    values = [number(word) for word in words]
    for name, word, value in zip(names, words, values):
        if value is None:
            raise FormatError(file, line, f"column '{shortened(name)}': expected a finite number, found "
                                          f"'{shortened(word)}'")
    return values


def _whole(file, header, name, values):
    low, high = WHOLE[name]
    bad = np.flatnonzero((values != np.round(values)) | (values < low) | (values > high))
    if bad.size:
        raise FormatError(file, header + 1 + int(bad[0]), f"column '{name}': expected a whole number of "
                                                          f"{low} to {high}, found {values[bad[0]]:.17g}")
    return values.astype(np.int64)


def _refuse_repeated_rows(file, header, columns, values):
    """A particle has its id once; a contact, which has none, is told from others by all of its row."""
    if "body_i" in columns:
        if "sphere_i" not in columns or "sphere_j" not in columns:
            return
        keys, what = values, "contact"
    elif "id" in columns:
        keys, what = columns["id"][:, np.newaxis], "particle"
    else:
        return
    order = np.lexsort(keys.T)  # stable: of equal rows the first comes first
    twice = np.flatnonzero((keys[order[1:]] == keys[order[:-1]]).all(axis=1))
    if twice.size:
        first, again = (header + 1 + int(order[twice[0] + k]) for k in (0, 1))
        raise FormatError(file, again, f"expected each {what} once, found that of line {first} again")
