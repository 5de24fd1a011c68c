# SPDX-License-Identifier: GPL-2.0-or-later
"""What is raised for a file that cannot be used, and how values are shown in it."""


class FormatError(ValueError):
    """A file is not what it should be: str() is one line with file, line, what was found and expected.

    file: name of the file; line: counted from 1, None where the fault has no line.
    """

    def __init__(self, file, line, message):
        # The arguments are kept as they are, so that the error comes through to another process.
        super().__init__(str(file), line, message)
        self.file, self.line = str(file), line

    def __str__(self):
        place = self.file if self.line is None else f"{self.file}:{self.line}"
        return f"{printable(place)}: {self.args[2]}"


def printable(text):
    """`text` on one line, '?' for what a terminal could take for a command: names of files may hold it."""
    return "".join(each if each.isprintable() else "?" for each in text)


def shortened(text):
    """`text` cut off after 60 characters, as printable() shows it."""
    return printable(text[:60]) + ("..." if len(text) > 60 else "")


def first_repeated(names):
    """The first name that has been before; None where each is there once. A header may have 100 000."""
    seen = set()
    for name in names:
        if name in seen:
            return name
        seen.add(name)
    return None


def listed(names):
    """Names of columns for a message, 50 at most."""
    return " ".join([shortened(name) for name in names[:50]] + ["..."] * (len(names) > 50))


def no_such_column(file, line, name, names):
    """The error for a column that a file does not have; lists those that it has."""
    return FormatError(file, line, f"no column '{shortened(str(name))}'; the columns are: {listed(names)}")
