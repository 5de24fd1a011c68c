# SPDX-License-Identifier: GPL-2.0-or-later
"""Tables, JSON files and run folders; those of a study that is in the repository, and what is refused."""

import gzip
import tarfile
import unittest
import unittest.mock

import numpy as np
from support import REPOSITORY, FileTest, rodpack

from rodpack import Run, read_json, read_summary, read_table

STUDY = REPOSITORY / "inputs" / "study" / "results" / "reduced"


def read_columns(file):
    table = read_table(file)
    return {name: table[name] for name in table}


class Tables(FileTest):
    def test_names_and_numbers_as_they_stand_there(self):
        table = read_table(self.write("a.csv", "r_over_dp,g\n0.05,-1e-3\n.1,+12\n"))
        self.assertEqual((table.names, table.rows, list(table)), (("r_over_dp", "g"), 2, ["r_over_dp", "g"]))
        self.assert_equal(table["r_over_dp"], [0.05, 0.1])
        self.assert_equal(table["g"], [-0.001, 12])
        self.assertEqual(table.words("g"), ["-1e-3", "+12"])

    def test_fields_between_blanks_and_names_in_a_comment(self):
        table = read_table(self.write("a.txt", "# Time-averaged data\n# step  ke\n\n0 1.5\n100 2\n# end\n"))
        self.assert_equal(table["ke"], [1.5, 2])

    def test_words_of_a_comment_that_names_no_columns(self):
        # LIGGGHTS's own titles name the fix, here one that is called 'data'.
        titles = "# Time-averaged data for fix data\n#\n# step, or so, or\n# step ke\n"
        table = read_table(self.write("a.txt", titles + "0 1.5\n"))
        self.assertEqual((table.names, table.line), (("step", "ke"), 4))

    def test_a_header_of_very_many_columns(self):
        names = [f"{k:x}" for k in range(100_000)]
        self.assertEqual(read_table(self.write("a.txt", " ".join(names) + "\n")).names, tuple(names))
        self.refuses(read_table, self.write("a.txt", " ".join(names) + " 1869f\n"), 1, "'1869f' twice")

    def test_a_table_without_rows(self):
        self.assert_equal(read_table(self.write("a.csv", "x,y\n"))["y"], np.empty(0))

    def test_fields_that_may_be_missing(self):
        file = self.write("a.csv", "case,sem\na,\nb,nan\nc,2\nd,inf\n")
        self.refuses(lambda f: read_table(f).numbers("sem", missing=True), file, 5,
                     "a finite number or none", "'inf'")
        self.refuses(read_columns, file, 2, "column 'case'", "a finite number", "'a'")
        self.refuses(lambda f: read_table(f)["sem"], file, 2, "column 'sem'", "found ''")
        file = self.write("a.csv", "case,sem\na,\nb,nan\nc,2\n")
        self.assert_equal(read_table(file).numbers("sem", missing=True), [np.nan, np.nan, 2])

    def test_more_fields_than_memory_is_meant_for(self):
        file = self.write("a.csv.gz", gzip.compress(b"x,y\n" + b"1,2\n" * 4))
        with unittest.mock.patch("rodpack.tables.MOST_FIELDS", 8):
            self.assertEqual(read_table(file).rows, 4)
        with unittest.mock.patch("rodpack.tables.MOST_FIELDS", 7):
            self.refuses(read_table, file, 5, "expected a table of at most 7 fields")

    def test_what_is_refused(self):
        def refused(content, line, *words):
            self.refuses(read_columns, self.write("bad.csv", content), line, *words)
        refused("", None, "names of the columns")
        refused("\n\n", None, "names of the columns")
        refused("x,y\n1,2\n3\n", 3, "expected 2 fields (x y), found 1", "'3'")
        refused("x,y\n1,2,3\n", 2, "found 3")
        refused("x,x\n1,2\n", 1, "'x' twice")
        refused("#\n1 2\n", 1, "names of the columns, found none")
        refused("#\n", 1, "names of the columns, found none")
        refused("x,\n1,2\n", 1, "a name for each column, found none for column 2")
        refused("x,y\n1,2\n3,4", 3, "no line end")
        refused("x,y\n1,nan\n", 2, "column 'y'", "finite number", "'nan'")
        refused("x,y\n1,1.2.3\n", 2, "'1.2.3'")
        refused(b"x,y\n1,\0\n", 2, "NUL")
        refused(b"x,y\n\xff\xfe,1\n", 2, "expected text")
        file = self.write("a.csv", "x,y\n1,2\n")
        self.refuses(lambda f: read_table(f)["z"], file, 1, "no column 'z'", "x y")

    def test_damage_is_refused_or_harmless(self):
        def check(columns):
            self.assertEqual(len({column.size for column in columns.values()}), 1)
            self.assertTrue(all(np.isfinite(column).all() for column in columns.values()))
        file = self.write("a.csv", "x,y\n" + "".join(f"{k},{k / 7}\n" for k in range(30)))
        self.damage_is_refused_or_harmless(read_columns, file, check)


class Json(FileTest):
    def test_what_is_refused(self):
        def refused(content, line, *words):
            self.refuses(read_json, self.write("bad.json", content), line, "expected", *words)
        refused("", 1, "JSON object")
        refused('{"a": 1,\n"b": }', 2, "JSON object")
        refused('{"a": 1, "a": 2}', None, "'a' twice")
        refused('{"a": NaN}', None, "finite numbers", "NaN")
        refused('{"a": 1e999}', None, "finite numbers", "1e999")
        refused('{"a": 1' + "0" * 400 + "}", None, "finite numbers", "1000")
        refused("{" + ",".join(f'"{k}":1' for k in range(100_000)) + ',"99999":1}', None, "'99999' twice")
        refused("[1]", None, '{ "key": value, ... }')
        refused("[" * 100_000, None, "JSON object")
        refused(b'{"a": "\xff"}', None, "JSON object")
        refused('{"a": ' + "1" * 5000 + "}", None, "finite numbers", "1111")
        self.refuses(read_json, self.folder, None, "no regular file")
        self.every_cut_is_refused(read_json, self.write("a.json", '{"a": [1, 2.5], "b": null}'))

    def test_a_summary_is_of_the_format_that_is_documented(self):
        file = self.write("summary.json", '{"format": "rodpack-analysis 3", "janssen_depth_over_dp": null}')
        self.assertEqual(read_summary(file)["janssen_depth_over_dp"], None)
        for other in ("rodpack-analysis 2", "rodpack-ensemble 1"):
            file = self.write("summary.json", f'{{"format": "{other}"}}')
            self.refuses(read_summary, file, None, "'rodpack-analysis 3'", f"'{other}'",
                         "analyse the run again")
        self.refuses(read_summary, self.write("summary.json", "{}"), None, "'None'")

    def test_the_format_is_that_of_the_program(self):
        header = (REPOSITORY / "postproc" / "reading" / "run_folder.h").read_text()
        self.assertIn(f'"{rodpack.json_files.SUMMARY_FORMAT}"', header)


class Study(FileTest):
    """The reduced study, as inputs/study/archive.py has packed its runs."""

    def test_every_table_of_its_results(self):
        words = {"case", "quantity", "number", "averaged_from", "source", "name", "claim", "measured",
                 "verdict", "test", "remark"}
        files = [*STUDY.glob("*.csv"), *(REPOSITORY / "inputs" / "study").glob("*.csv")]
        self.assertGreater(len(files), 4)
        for file in files:
            table = read_table(file)
            for name in table:
                if name in words:
                    self.assertEqual(len(table.words(name)), table.rows)
                else:
                    table.numbers(name, missing=True)

    def test_every_run_of_its_archive(self):
        with tarfile.open(STUDY / "runs.tar.xz") as archive:
            archive.extractall(self.folder)
        runs = [Run(folder) for folder in sorted(self.folder.glob("runs/*/*"))]
        self.assertEqual(len(runs), 21 * 3)
        for run in runs:
            self.assertEqual(run.summary["particles"], run.parameters["particles"])
            self.assertEqual(run.summary["timestep"], run.result["step"])
            self.assertIn("rdf", run.tables)
            rdf = run.table("rdf")
            self.assertTrue((np.diff(rdf["r_over_dp"]) > 0).all())
            with self.assertRaises(FileNotFoundError):
                run.bodies
        # The coordination number is the mean of its distribution.
        counts = runs[0].table("forces_coordination")
        summary = runs[0].summary
        touching = (counts["number"] * counts["particles_with_touching_particles"]).sum()
        self.assertAlmostEqual(touching / summary["particles"], summary["coordination_number"], delta=1e-12)

    def test_a_folder_that_is_not_there(self):
        with self.assertRaisesRegex(FileNotFoundError, "no such run folder"):
            Run(self.folder / "none")


if __name__ == "__main__":
    unittest.main()
