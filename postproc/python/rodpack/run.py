# SPDX-License-Identifier: GPL-2.0-or-later
"""The folder of a run, its files read when they are asked for."""

from functools import cached_property
from pathlib import Path

from .dumps import Dump
from .errors import FormatError, printable
from .fields import read_fields
from .json_files import read_json, read_summary
from .tables import read_table


class Run:
    """A run folder of inputs/deposition (inputs/README.md lists its files), of a study, or one unpacked from
    what inputs/study/archive.py packs, which has no dumps.

        run = Run("results/quick")
        run.parameters["aspect_ratio"], run.summary["nematic_order_S2"]
        run.bodies.last()["x"], run.fields["solid_fraction"], run.table("rdf")["g"]

    Each file is read once, at the first use; FileNotFoundError where it is not there. Dumps are read anew.
    """

    def __init__(self, folder):
        self.folder = Path(folder)
        if not self.folder.is_dir():
            raise FileNotFoundError(f"{printable(str(folder))}: no such run folder")

    def __repr__(self):
        return f"Run({str(self.folder)!r})"

    @cached_property
    def parameters(self):
        """parameters.json: a dict, units in the names of the keys."""
        return read_json(self.folder / "parameters.json")

    @cached_property
    def result(self):
        """result.json: a dict; there once the bed is at rest."""
        return read_json(self.folder / "result.json")

    @cached_property
    def energies(self):
        """energies.csv: a Table."""
        return read_table(self.folder / "energies.csv")

    @cached_property
    def summary(self):
        """analysis/summary.json: a dict."""
        return read_summary(self.folder / "analysis" / "summary.json")

    @cached_property
    def fields(self):
        """analysis/fields.vti: Fields."""
        return read_fields(self.folder / "analysis" / "fields.vti")

    @property
    def tables(self):
        """Names of the tables of the analysis: "rdf" for analysis/rdf.csv."""
        return sorted(file.stem for file in (self.folder / "analysis").glob("*.csv"))

    def table(self, name):
        """A table of the analysis by its name: a Table."""
        return read_table(self.folder / "analysis" / f"{name}.csv")

    @property
    def bodies(self):
        """dumps/bodies.*.dump: a Dump, a row per particle."""
        return self._dump("bodies")

    @property
    def spheres(self):
        """dumps/spheres.*.dump: a Dump, a row per primary sphere."""
        return self._dump("spheres")

    @property
    def contacts(self):
        """dumps/contacts.*.dump: a Dump, a row per contact."""
        return self._dump("contacts")

    def _dump(self, kind):
        """Dumps after the step at which result.json says the run ended are left out: a run that was resumed
        may end earlier than the one before had come, and those are of a course that it did not take."""
        files = [*self.folder.glob(f"dumps/{kind}.*.dump"), *self.folder.glob(f"dumps/{kind}.*.dump.gz")]
        if not files:
            raise FileNotFoundError(f"{printable(str(self.folder))}/dumps/{kind}.*.dump: no such file")
        end = None
        if (self.folder / "result.json").exists():
            end = self.result.get("step")
            if not isinstance(end, int) or isinstance(end, bool) or end < 0:
                raise FormatError(self.folder / "result.json", None,
                                  f"key 'step': expected a whole number, 0 or more, found {end!r}")
        return Dump(files, end)
