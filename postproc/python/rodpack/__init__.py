# SPDX-License-Identifier: GPL-2.0-or-later
"""Reads what rodpack and its simulations write into NumPy arrays: dumps, fields.vti, tables, summary.json.

Run(folder) has all files of a run; read_dump, read_fields, read_table, read_json and read_summary read one
file each. A file that is not what it should be raises FormatError, which names file, line, what was found
and what was expected. rodpack.orientation: quaternions for OVITO and freud. Needs NumPy alone.
"""

from . import orientation
from .dumps import Dump, Frame, read_dump
from .errors import FormatError
from .fields import Fields, read_fields
from .json_files import read_json, read_summary
from .run import Run
from .tables import Table, read_table

__version__ = "0.2"
__all__ = ["Dump", "Fields", "FormatError", "Frame", "Run", "Table", "orientation", "read_dump",
           "read_fields", "read_json", "read_summary", "read_table"]
