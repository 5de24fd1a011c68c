# SPDX-License-Identifier: GPL-2.0-or-later
"""Lines and numbers of text files: what the readers of dumps and tables share."""

import gzip
import os
import re
import zlib

from .errors import FormatError, shortened

# Anything longer is no table of numbers, and would be held in memory as a whole.
LONGEST_LINE = 1_000_000
# A frame of a dump, a field of an image: 2 GB. A few kB of compressed text can hold any number of rows.
MOST_NUMBERS = 250_000_000

# Python's float() takes more: "nan", "1_000", other scripts' digits, blanks around.
_NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?", re.ASCII)
_WHOLE = re.compile(r"[+-]?\d{1,19}", re.ASCII)


def number(word):
    """The number that `word` is as a whole; None for anything else, infinite ones included."""
    if not _NUMBER.fullmatch(word):
        return None
    value = float(word)
    return value if abs(value) < float("inf") else None


def whole_number(word):
    """The whole number that `word` is, without point and exponent; None for anything else."""
    return int(word) if _WHOLE.fullmatch(word) else None


def open_regular(file):
    """Opens a file for reading bytes. A pipe without a writer would never answer: FormatError."""
    if os.path.exists(file) and not os.path.isfile(file):
        raise FormatError(file, None, "is no regular file, expected one")
    return open(file, "rb")


class Lines:
    """The lines of a text file, plain or gzip-compressed (told by its first bytes), one at a time.

    number: of the last line that was read, from 1; ended: whether a line end closed it.
    """

    def __init__(self, file):
        self.file = os.fspath(file)
        self.number = 0
        self.ended = True
        self._stream = open_regular(self.file)
        compressed = self._stream.read(2) == b"\x1f\x8b"
        self._stream.seek(0)
        if compressed:
            self._stream.close()
            self._stream = gzip.open(self.file, "rb")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._stream.close()

    def fail(self, message):
        """Raises FormatError for the current line."""
        raise FormatError(self.file, self.number or None, message)

    def next(self):
        """The next line without its end; None at the end of the file."""
        try:
            raw = self._stream.readline(LONGEST_LINE + 1)
        except (EOFError, zlib.error, gzip.BadGzipFile):
            self.fail("the compressed file is damaged or cut short after this line")
        if not raw:
            return None
        if len(raw) > LONGEST_LINE:
            self.fail(f"expected lines of at most {LONGEST_LINE} characters, found a longer one after this")
        self.number += 1
        self.ended = raw.endswith(b"\n")
        try:
            line = raw.decode("utf-8")
        except UnicodeDecodeError:
            found = shortened(raw.decode("latin-1"))
            self.fail(f"expected text, found '{found}': the file is damaged, or no text")
        if "\0" in line:
            self.fail("expected text, found a NUL character: the file is damaged, or no text")
        return line.rstrip("\r\n")

    def need(self, expected):
        """The next line. FormatError, which names what was expected, at the end of the file."""
        line = self.next()
        if line is None:
            self.fail(f"the file is cut short here: expected {expected}")
        return line

    def need_line_end(self):
        """FormatError when the file ends in the current line: its last number may have lost digits."""
        if not self.ended:
            self.fail("the file is cut short here: this line has no line end")
