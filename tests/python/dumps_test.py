# SPDX-License-Identifier: GPL-2.0-or-later
"""Dumps: what is read, to the last bit, and what is refused."""

import gzip
import os
import tracemalloc
import unittest

import numpy as np
from support import FileTest, rodpack

from rodpack import Run, read_dump

BODIES = """\
ITEM: TIMESTEP
5
ITEM: NUMBER OF ATOMS
2
ITEM: BOX BOUNDS pp ff ff
-0.25 0.75
0 1e-3
-0.5 0.5
ITEM: ATOMS id x half_length nspheres
9007199254740991 0.1 -2.5e-3 3
4 +1e300 .5 1
"""
CONTACTS = """\
ITEM: TIMESTEP
5
ITEM: NUMBER OF ENTRIES
2
ITEM: BOX BOUNDS ff ff ff
0 1
0 1
0 1
ITEM: ENTRIES body_i body_j sphere_i sphere_j wall fx
1 2 3 4 0 0.5
1 2 3 4 0 0.25
"""


def frame(step, rows="1 0.5\n", count=1):
    """A frame of the columns id and x."""
    return (f"ITEM: TIMESTEP\n{step}\nITEM: NUMBER OF ATOMS\n{count}\nITEM: BOX BOUNDS\n0 1\n0 1\n0 1\n"
            f"ITEM: ATOMS id x\n{rows}")


def read_all(file):
    return list(read_dump(file))


class Reading(FileTest):
    def read(self, content, name="bodies.dump"):
        return read_all(self.write(name, content))

    def check_bodies(self, frames):
        self.assertEqual(len(frames), 1)
        bodies = frames[0]
        self.assertEqual((bodies.step, bodies.rows, bodies.units, bodies.kind, bodies.time, bodies.line),
                         (5, 2, "si", "bodies", None, 9))
        self.assert_equal(bodies.box, [[-0.25, 0.75], [0, 1e-3], [-0.5, 0.5]])
        self.assertEqual(bodies.periodic, (True, False, False))
        self.assertEqual(bodies.names, ("id", "x", "half_length", "nspheres"))
        # 2^53 - 1 would not survive a detour over numbers of fewer digits.
        self.assert_equal(bodies["id"], [2**53 - 1, 4])
        self.assertEqual((bodies["id"].dtype, bodies["nspheres"].dtype), (np.int64, np.int64))
        self.assert_equal(bodies["x"], [0.1, 1e300])
        self.assert_equal(bodies["half_length"], [-0.0025, 0.5])

    def test_every_value_is_the_double_of_its_text(self):
        self.check_bodies(self.read(BODIES))

    def test_compressed_ones_are_told_by_their_content(self):
        self.check_bodies(self.read(gzip.compress(BODIES.encode()), "bodies.dump.gz"))
        self.check_bodies(self.read(gzip.compress(BODIES.encode()), "bodies.dump"))

    def test_lines_may_end_as_on_other_systems(self):
        self.check_bodies(self.read(BODIES.replace("\n", "\r\n")))

    def test_units_and_time_before_a_frame(self):
        frames = self.read("ITEM: UNITS\nsi\nITEM: TIME\n2.5\n" + frame(7))
        self.assertEqual((frames[0].step, frames[0].time), (7, 2.5))

    def test_a_frame_is_a_mapping(self):
        bodies = self.read(BODIES)[0]
        self.assertEqual(list(bodies), ["id", "x", "half_length", "nspheres"])
        self.assertIn("x", bodies)
        self.assertNotIn("y", bodies)
        self.assert_equal(dict(bodies)["x"], bodies["x"])
        self.assert_equal(bodies.stack("x", "half_length"), [[0.1, -0.0025], [1e300, 0.5]])
        records = bodies.records()
        self.assertEqual(records.dtype.names, bodies.names)
        self.assertEqual(records[1].tolist(), (4, 1e300, 0.5, 1))

    def test_kinds_are_told_by_their_columns(self):
        self.assertEqual(self.read(CONTACTS)[0].kind, "contacts")
        self.assertEqual(self.read(frame(1, "1 2\n").replace("id x", "id body"))[0].kind, "spheres")
        self.assertIsNone(self.read(frame(1))[0].kind)

    def test_an_empty_frame_has_columns_without_rows(self):
        empty = self.read(frame(0, "", 0))[0]
        self.assertEqual((empty.rows, empty["x"].shape, empty["id"].dtype), (0, (0,), np.int64))

    def test_many_frames_come_one_at_a_time(self):
        rows = "".join(f"{k} {k / 7!r}\n" for k in range(20_000))
        file = self.write("long.dump", "".join(frame(step, rows, 20_000) for step in range(8)))
        tracemalloc.start()
        steps = [each.step for each in read_dump(file)]
        largest = tracemalloc.get_traced_memory()[1]
        tracemalloc.stop()
        self.assertEqual(steps, list(range(8)))
        # A frame's text, 0.5 MB, as lines of Python is some 2 MB, its numbers 0.3 MB; two frames are held
        # while one follows the other. Eight would be 16 MB.
        self.assertLess(largest, 8e6)

    def test_numbers_of_all_sizes(self):
        random = np.random.default_rng(1)
        values = random.standard_normal(1000) * 10.0 ** random.integers(-300, 300, 1000)
        rows = "".join(f"{k} {value:.17g}\n" for k, value in enumerate(values))
        self.assert_equal(self.read(frame(1, rows, 1000))[0]["x"], values)


class Series(FileTest):
    """Several frames in files of one or several."""

    def test_files_are_in_order_of_time(self):
        files = [self.write(f"b.{step}.dump", frame(step)) for step in (900, 10000, 0)]
        dump = read_dump(files)
        self.assertEqual([each.step for each in dump], [0, 900, 10000])
        self.assertEqual([each.step for each in dump], [0, 900, 10000])  # anew, from the beginning
        self.assertEqual(dump.files, tuple(str(files[k]) for k in (2, 0, 1)))
        self.assertEqual((dump.last().step, dump.at(900).step), (10000, 900))
        with self.assertRaisesRegex(LookupError, "no frame of step 901"):
            dump.at(901)

    def test_frames_within_files_are_found(self):
        files = [self.write("a.dump", frame(0) + frame(5)), self.write("b.dump", frame(10) + frame(15))]
        self.assertEqual([read_dump(files).at(step).step for step in (0, 5, 10, 15)], [0, 5, 10, 15])
        self.assertEqual(read_dump(files).last().step, 15)
        with self.assertRaises(LookupError):
            read_dump([]).last()

    def test_a_step_that_comes_twice_is_refused(self):
        again = self.write("a.dump", frame(5) + frame(6) + frame(5))
        self.refuses(read_all, again, 29, "step 5 again", "a.dump:9")
        files = [self.write("x.dump", frame(5)), self.write("y.dump", frame(5))]
        self.refuses(lambda _: read_dump(files), files[1], None, "expected each step once", str(files[0]))
        files = [self.write("x.dump", frame(1) + frame(5)), self.write("y.dump", frame(4) + frame(5))]
        self.refuses(lambda _: read_all(files), files[1], 19, "step 5 again")

    def test_a_run_has_its_dumps_up_to_its_end(self):
        for step in (0, 100, 200, 300):
            self.write(f"run/dumps/bodies.{step}.dump", frame(step))
        self.write("run/dumps/bodies.200.dump.part", "ITEM: TIM")
        run = Run(self.folder / "run")
        self.assertEqual([each.step for each in run.bodies], [0, 100, 200, 300])
        # A run that was resumed ended earlier than the one that was interrupted had come.
        self.write("run/result.json", '{"step": 200}')
        self.assertEqual([each.step for each in Run(self.folder / "run").bodies], [0, 100, 200])
        with self.assertRaisesRegex(FileNotFoundError, "spheres"):
            run.spheres
        (self.folder / "run/dumps/bodies.0.dump").unlink()
        self.write("run/result.json", '{"step": 50}')
        self.refuses(lambda _: Run(self.folder / "run").bodies, self.folder / "run/dumps/bodies.100.dump",
                     None, "up to step 50, at which the run ended", "found step 100")
        self.refuses(lambda _: Run(self.write("run/result.json", '{"step": 2.5}').parent).bodies,
                     self.folder / "run/result.json", None, "key 'step'", "2.5")


class Refusals(FileTest):
    def refused(self, content, line, *words, name="bad.dump"):
        self.refuses(read_all, self.write(name, content), line, *words)

    def changed(self, old, new, line, *words, text=BODIES):
        self.assertIn(old, text)
        self.refused(text.replace(old, new, 1), line, *words)

    def test_files_without_a_frame(self):
        self.refused("", None, "no frame")
        self.refused("\n\n", None, "no frame")
        self.refused(gzip.compress(b""), None, "no frame")
        with self.assertRaises(FileNotFoundError):
            read_all(self.folder / "none.dump")
        self.refuses(read_all, self.folder, None, "no regular file")
        os.mkfifo(self.folder / "pipe")
        self.refuses(read_all, self.folder / "pipe", None, "no regular file")

    def test_what_is_no_text_dump(self):
        self.refused(b"\x7fELF\x02\x01\x01\0\0\0\n" * 3, 1, "NUL")
        self.refused(b"ITEM: TIMESTEP\n\xff\xfe\n", 2, "expected text")
        self.refused("hello\n", 1, "expected 'ITEM: TIMESTEP', found 'hello'")
        self.refused("\x1b[31mred\n", 1, "found '?[31mred'")
        self.refused(frame(1, "1\n").replace("id x", "id \x1b[2Jx"), 10, "(id ?[2Jx)")
        self.refused(frame(1, "1 a\n").replace("id x", "id \x1b[2Jx"), 10, "column '?[2Jx'")
        self.refused("x" * 1_000_001, None, "at most 1000000 characters")

    def test_a_file_s_name_keeps_to_one_line_too(self):
        file = self.write("a\n\x1b[31mb.dump", "hello\n")
        with self.assertRaises(rodpack.FormatError) as caught:
            read_all(file)
        self.assertEqual(str(caught.exception),
                         f"{self.folder}/a??[31mb.dump:1: expected 'ITEM: TIMESTEP', found 'hello'")
        self.assertEqual(caught.exception.file, str(file))
        with self.assertRaisesRegex(FileNotFoundError, "no.where: no such run folder"):
            Run(self.folder / "no\nwhere")

    def test_a_head_of_very_many_columns(self):
        names = " ".join(f"{k:x}" for k in range(100_000))
        self.refused(frame(1, "1\n", 1).replace("id x", names + " 1869f"), 9, "'1869f' twice")

    def test_heads_that_are_no_heads(self):
        self.changed("\n5\n", "\n5.5\n", 2, "timestep", "'5.5'")
        self.changed("\n5\n", "\n-5\n", 2, "timestep", "'-5'")
        self.changed("\n5\n", "\n9007199254740992\n", 2, "timestep", "of 0 to 9007199254740991")
        self.changed("ITEM: NUMBER OF ATOMS", "ITEM: ATOMS", 3, "ITEM: NUMBER OF")
        self.changed("ATOMS\n2\n", "ATOMS\ntwo\n", 4, "number of rows", "'two'")
        self.changed("ITEM: BOX BOUNDS", "ITEM: BOX", 5, "BOX BOUNDS")
        self.changed("pp ff ff", "xy xz yz pp ff ff", 5, "upright box")
        self.changed("-0.25 0.75", "-0.25 0.75 0.1", 6, "upright box")
        self.changed("-0.25 0.75", "-0.25 nan", 6, "lo < hi")
        self.changed("-0.25 0.75", "1 0.75", 6, "lo < hi", "'1 0.75'")
        self.changed("ITEM: ATOMS id", "ITEM: THINGS id", 9, "'ITEM: ATOMS' or 'ITEM: ENTRIES'")
        self.changed("ATOMS id x half_length nspheres", "ATOMS", 9, "names no columns")
        self.changed("id x half", "x x half", 9, "'x' twice")
        self.refused("ITEM: UNITS\ncgs\n" + BODIES, 2, "SI units", "'cgs'")
        self.refused("ITEM: TIME\nnow\n" + BODIES, 2, "a time", "'now'")

    def test_rows_that_have_other_fields_than_columns(self):
        self.changed("0.1 -2.5e-3 3", "0.1 3", 10, "expected 4 fields (id x half_length nspheres), found 3")
        self.changed(".5 1\n", ".5 1 1\n", 11, "found 5")
        self.changed("9007199254740991 0.1 -2.5e-3 3", "", 10, "found 0")
        # All rows short alike, which NumPy takes for a table of three columns.
        self.refused(frame(1, "1\n2\n", 2), 10, "expected 2 fields (id x), found 1")
        self.refused(frame(1, "1 2 3\n4 5 6\n", 2), 10, "found 3")

    def test_more_and_fewer_rows_than_stated(self):
        self.changed("ATOMS\n2\n", "ATOMS\n1\n", 11, "more rows than the frame's count states?")
        self.changed("ATOMS\n2\n", "ATOMS\n3\n", 11, "cut short", "expected 3 rows, found 2")
        self.refused(frame(1, "1 2\n", 2) + frame(2), 11, "too few rows: expected 2, found 1")
        self.changed("ATOMS\n2\n", "ATOMS\n62500000\n", 11, "cut short")

    def refused_in_little_memory(self, packed, line, *words):
        """`packed` holds over 50 MB of text, of which no more than a part is ever in memory."""
        file = self.write("bomb.dump.gz", packed)
        tracemalloc.start()
        self.refuses(read_all, file, line, *words)
        largest = tracemalloc.get_traced_memory()[1]
        tracemalloc.stop()
        self.assertLess(largest, 25e6)

    def test_compressed_text_that_would_fill_the_memory(self):
        self.changed("ATOMS\n2\n", "ATOMS\n62500001\n", 9,
                     "at most 250000000 numbers, found one of 62500001 rows and 4 columns")
        # 50 MB of line ends, and rows of a few numbers that are 100 kB long.
        self.refused_in_little_memory(gzip.compress(frame(1, "", 60_000_000).encode() + b"\n" * 50_000_000), 10,
                                      "expected 2 fields (id x), found 0")
        rows = "".join(f"{k} 1{' ' * 99_990}\n" for k in range(600))
        self.refused_in_little_memory(gzip.compress(frame(1, rows, 601).encode()), 609,
                                      "expected 601 rows, found 600")

    def test_the_frame_before_surplus_rows_is_not_handed_out(self):
        with self.assertRaises(rodpack.FormatError):
            next(iter(read_dump(self.write("a.dump", frame(1, "1 2\n2 3\n", 1)))))

    def test_what_is_no_finite_number(self):
        for word in ("nan", "-nan", "inf", "-inf", "1e999", "0x10", "1_000", "1,5", "abc", "1e", ".", "--1",
                     "1d5", "\u0661"):
            self.changed("0.1", word, 10, "column 'x'", "a finite number", f"'{word}'")

    def test_ids_and_counts_are_whole_and_in_their_range(self):
        self.changed("\n4 ", "\n4.5 ", 11, "column 'id'", "whole number", "4.5")
        self.changed("\n4 ", "\n-4 ", 11, "column 'id'", "of 0 to 9007199254740991")
        # rounds to 2^53 as a double
        self.changed("9007199254740991", "9007199254740993", 10, "column 'id'", "of 0 to 9007199254740991")
        self.changed(".5 1\n", ".5 0\n", 11, "column 'nspheres'", "of 1 to 1000000")
        self.changed("3 4 0 0.5", "3 4 2 0.5", 10, "column 'wall'", "of 0 to 1", text=CONTACTS)

    def test_what_stands_twice(self):
        self.changed("9007199254740991", "4", 11, "each particle once, found that of line 10")
        self.changed("0.25", "0.5", 11, "each contact once, found that of line 10", text=CONTACTS)

    def test_columns_that_are_not_there(self):
        bodies = read_all(self.write("a.dump", BODIES))[0]
        self.refuses(lambda _: bodies["vx"], self.folder / "a.dump", 9, "no column 'vx'",
                     "id x half_length nspheres")
        self.refuses(lambda _: bodies.stack("x", "y"), self.folder / "a.dump", 9, "no column 'y'")

    def test_every_cut_is_noticed(self):
        self.every_cut_is_refused(read_all, self.write("whole.dump", BODIES))
        self.every_cut_is_refused(read_all, self.write("whole.dump.gz", gzip.compress(BODIES.encode())))

    def test_of_several_frames_the_whole_ones_come_before_the_error(self):
        steps = []
        with self.assertRaisesRegex(rodpack.FormatError, "a.dump:20: .*cut short"):
            for each in read_dump(self.write("a.dump", frame(1) + frame(2)[:-2])):
                steps.append(each.step)
        self.assertEqual(steps, [1])

    def test_damage_is_refused_or_harmless(self):
        def check(frames):
            for each in frames:
                for name in each:
                    self.assertEqual(each[name].shape, (each.rows,))
                    self.assertTrue(np.isfinite(each[name]).all())
        for text in (BODIES, CONTACTS, frame(1) + frame(2)):
            self.damage_is_refused_or_harmless(read_all, self.write("a.dump", text), check)
            packed = self.write("a.dump.gz", gzip.compress(text.encode()))
            self.damage_is_refused_or_harmless(read_all, packed, check)


if __name__ == "__main__":
    unittest.main()
