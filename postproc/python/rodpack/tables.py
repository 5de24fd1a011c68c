# SPDX-License-Identifier: GPL-2.0-or-later
"""Tables: CSV of rodpack and the deposition, and what LIGGGHTS's fix print and fix ave/time write."""


import numpy as np

from .errors import FormatError, first_repeated, listed, no_such_column, shortened
from .named_arrays import NamedArrays
from .text import Lines, number

# As words of Python, some 60 bytes each: 1.5 GB.
MOST_FIELDS = 25_000_000


class Table(NamedArrays):
    """A mapping from the names of the columns, units in them as in the file, to arrays of one value per row.

    table["x_m"]: float64, every field a finite number, else FormatError with the line; words() has columns
    of words, numbers() those in which fields may be missing. rows: their number; names: of the columns.
    """

    def __init__(self, file, header, names, lines, fields):
        self.file, self.line, self.names = file, header, tuple(names)
        self._lines, self._fields = lines, fields
        self.rows = len(lines)

    def __getitem__(self, name):
        return self.numbers(name)

    def __repr__(self):
        return f"<table of {self.rows} rows of {' '.join(self.names)}>"

    def words(self, name):
        """The fields of a column as they stand in the file, a list."""
        if name not in self.names:
            raise no_such_column(self.file, self.line, name, self.names)
        index = self.names.index(name)
        return [row[index] for row in self._fields]

    def numbers(self, name, missing=False):
        """A column as float64. missing=True: NaN for fields that are empty or "nan": no value."""
        absent = {"": np.nan, "nan": np.nan, "-nan": np.nan} if missing else {}
        values = np.empty(self.rows)
        for row, word in enumerate(self.words(name)):
            value = absent.get(word)
            if value is None:
                value = number(word)
            if value is None:
                expected = "a finite number or none" if missing else "a finite number"
                raise FormatError(self.file, self._lines[row], f"column '{shortened(name)}': expected "
                                                               f"{expected}, found '{shortened(word)}'")
            values[row] = value
        return values


def read_table(file):
    """Reads a table: fields between commas if the line of the names holds one (CSV), else between blanks.

    The names stand in the last line that begins with '#' before the first row, or else in the first line;
    empty lines and later comments are passed over. FormatError, with the line: no names, one that comes
    twice, a row with another number of fields, a last line without line end, what is not text, more than
    MOST_FIELDS fields.
    """
    names, header, comma = None, None, False
    comment = None  # the last one, and its line: prose, where another one follows
    numbers, fields = [], []
    with Lines(file) as lines:
        while (text := lines.next()) is not None:
            text = text.strip()
            lines.need_line_end()
            if not text:
                continue
            if text.startswith("#"):
                comment = text[1:].strip(), lines.number
                continue
            if names is None:
                header = comment[1] if comment else lines.number
                text_of_names = comment[0] if comment else text
                names, comma = _names(lines.file, header, text_of_names), "," in text_of_names
                if not comment:
                    continue
            row = _split(text, comma)
            if len(row) != len(names):
                lines.fail(f"expected {len(names)} fields ({listed(names)}), found {len(row)}: "
                           f"'{shortened(text)}'")
            if (len(fields) + 1) * len(names) > MOST_FIELDS:
                lines.fail(f"expected a table of at most {MOST_FIELDS} fields, found more")
            numbers.append(lines.number)
            fields.append(row)
        if names is None:
            if not comment:
                raise FormatError(lines.file, None,
                                  "expected a line with the names of the columns, found an empty file")
            header, names = comment[1], _names(lines.file, comment[1], comment[0])
        return Table(lines.file, header, names, numbers, fields)


def _split(text, comma):
    return [word.strip() for word in text.split(",")] if comma else text.split()


def _names(file, line, text):
    names = _split(text, "," in text)
    if not names:
        raise FormatError(file, line, "expected the names of the columns, found none")
    if not all(names):
        raise FormatError(file, line, "expected a name for each column, found none for column "
                                      f"{names.index('') + 1}")
    twice = first_repeated(names)
    if twice is not None:
        raise FormatError(file, line, f"expected each column once, found '{shortened(twice)}' twice")
    return names
