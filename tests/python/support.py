# SPDX-License-Identifier: GPL-2.0-or-later
"""What the tests of postproc/python/ share: the package, a fresh folder, how a refusal reads."""

import os
import pickle
import sys
import tempfile
import unittest
from pathlib import Path

try:
    import numpy as np
except ImportError:
    print("skipped: no Python package numpy: install python3-numpy (docker/packages-tests.txt)")
    # The machine that decides about a change has all packages.
    sys.exit(1 if os.environ.get("CI") == "true" else 77)

REPOSITORY = Path(__file__).resolve().parent.parent.parent
PACKAGE = REPOSITORY / "postproc" / "python"
PROGRAMS = Path(os.environ.get("RODPACK_BIN", REPOSITORY / "build" / "bin"))
sys.path.insert(0, str(PACKAGE))

import rodpack  # noqa: E402  (found by the line above)


class FileTest(unittest.TestCase):
    """A test with a folder of its own."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="rodpack-python-")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def write(self, name, content):
        """Writes a file of the folder, a new one: many file systems wait for the disk when one is written
        over. Returns its path."""
        file = self.folder / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.unlink(missing_ok=True)
        file.write_bytes(content if isinstance(content, bytes) else content.encode())
        return file

    def refuses(self, read, file, line, *words):
        """Expects a FormatError of `read` that is one line, names file and line, and holds these words."""
        with self.assertRaises(rodpack.FormatError) as caught:
            read(file)
        message = str(caught.exception)
        where = f"{file}:{line}: " if line else f"{file}: "
        self.assertTrue(message.startswith(where), message)
        self.assertEqual(caught.exception.line, line)
        self.assertEqual(caught.exception.file, str(file))
        self.assertTrue(message.isprintable(), repr(message))  # one line, nothing for a terminal to obey
        # It comes through to another process.
        self.assertEqual(str(pickle.loads(pickle.dumps(caught.exception))), message)
        for word in words:
            self.assertIn(word, message)

    def assert_equal(self, found, expected):
        """The same numbers to the last bit, of the same shape."""
        np.testing.assert_array_equal(np.asarray(found), np.asarray(expected), strict_shape(found, expected))

    def every_cut_is_refused(self, read, file, up_to=0):
        """A file that ends anywhere before its end, less `up_to` bytes, is refused."""
        content = file.read_bytes()
        for length in range(len(content) - up_to):
            cut = self.write("cut", content[:length])
            with self.assertRaises(rodpack.FormatError, msg=f"{length} of {len(content)} bytes"):
                read(cut)

    def damage_is_refused_or_harmless(self, read, file, check, changes=400):
        """Changed, missing or new bytes: FormatError and nothing else, or data that `check` takes."""
        content = file.read_bytes()
        random = np.random.default_rng(1)
        refused = 0
        for _ in range(changes):
            at = int(random.integers(len(content)))
            byte = bytes([int(random.integers(256))])
            tail = content[at + int(random.integers(2)):]
            damaged = self.write("damaged", content[:at] + (byte if random.integers(4) else b"") + tail)
            try:
                check(read(damaged))
            except rodpack.FormatError:
                refused += 1
        self.assertGreater(refused, changes // 20)


def strict_shape(found, expected):
    """A message for arrays of other shapes, which NumPy would stretch to one another."""
    if np.shape(found) != np.shape(expected):
        raise AssertionError(f"shape {np.shape(found)}, expected {np.shape(expected)}")
    return ""
