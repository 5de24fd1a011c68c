# SPDX-License-Identifier: GPL-2.0-or-later
"""fields.vti: every encoding of VTK's own writer (vtk_encodings.cpp), and what is refused."""

import base64
import subprocess
import unittest
import zlib

import numpy as np
from support import PROGRAMS, FileTest, rodpack

from rodpack import read_fields

# Two places along x, one along y: two doubles, 1 and 2.5, in text.
PLAIN = """\
<VTKFile type="ImageData" byte_order="LittleEndian">
<ImageData WholeExtent="0 1 0 0 0 0" Origin="0 0 0" Spacing="1 1 1">
<Piece Extent="0 1 0 0 0 0"><PointData>
<DataArray type="Float64" Name="phi" format="ascii">1 2.5</DataArray>
</PointData></Piece></ImageData></VTKFile>
"""


def coded(*words, then=b""):
    """Numbers of a header, and bytes behind them, in base64."""
    return base64.b64encode(np.array(words, "<u4").tobytes() + then).decode()


class Encodings(FileTest):
    names = ("default", "ascii", "binary", "binary_zlib", "appended", "raw", "raw_zlib_big_64",
             "small_blocks")

    def setUp(self):
        super().setUp()
        subprocess.run([PROGRAMS / "vtk_encodings", self.folder], check=True)

    def test_all_hold_the_same_numbers(self):
        # As vtk_encodings.cpp writes them: x from 10 by 1, y from 20 by 2, x fastest in the file.
        x, y = np.meshgrid([10.0, 11.0, 12.0], [20.0, 22.0])
        for name in self.names:
            with self.subTest(name):
                fields = read_fields(self.folder / f"{name}.vti")
                self.assertEqual((fields.count, fields.time), ((3, 2, 1), 0.1))
                self.assert_equal(fields.origin, [10, 20, 0])
                self.assert_equal(fields.spacing, [1, 2, 1])
                self.assert_equal(fields.x, x[0])
                self.assert_equal(fields.y, y[:, 0])
                self.assertEqual(list(fields), ["ratio", "tensor_N_m", "number"])
                self.assert_equal(fields["ratio"], 1 + x / y)
                self.assert_equal(fields["tensor_N_m"], np.stack([x, y, -x, y * y], axis=-1))
                self.assertEqual(fields.components["tensor_N_m"], ("xx", "xy", "yx", "yy"))
                self.assert_equal(fields.tensor("tensor_N_m")[1, 2], [[12, 22], [-12, 22**2]])
                self.assert_equal(fields["number"], [[0, 1, 2], [3, 4, 5]])
                self.assertEqual(fields["number"].dtype, np.int32)
                self.assertTrue(fields["ratio"].dtype.isnative)

    def test_the_encodings_are_what_they_are_called(self):
        marks = {"ascii": b'format="ascii"', "binary": b'format="binary"', "raw": b'encoding="raw"',
                 "raw_zlib_big_64": b'byte_order="BigEndian" header_type="UInt64"',
                 "default": b"vtkZLibDataCompressor", "appended": b'encoding="base64"'}
        for name, mark in marks.items():
            self.assertIn(mark, (self.folder / f"{name}.vti").read_bytes(), name)

    def test_an_encoding_that_is_not_known_is_refused(self):
        self.refuses(read_fields, self.folder / "unknown_lz4.vti", None, "compressor",
                     "expected none or vtkZLibDataCompressor, found 'vtkLZ4DataCompressor'")

    def test_every_cut_is_noticed(self):
        # All that follows </VTKFile> is the line's end.
        for name in ("default", "ascii", "raw_zlib_big_64"):
            self.every_cut_is_refused(read_fields, self.folder / f"{name}.vti", up_to=1)

    def test_damage_is_refused_or_harmless(self):
        def check(fields):
            self.assertNotIn("no such field", fields)
            for name in fields:
                self.assertTrue(np.isfinite(fields[name]).all())
                self.assertEqual(fields[name].shape[:2], (fields.y.size, fields.x.size))
        for name in self.names:
            self.damage_is_refused_or_harmless(read_fields, self.folder / f"{name}.vti", check, 200)


class Refusals(FileTest):
    def changed(self, old, new, line, *words, text=PLAIN):
        self.assertIn(old, text)
        self.refuses(read_fields, self.write("bad.vti", text.replace(old, new)), line, *words)

    def test_the_text_itself_is_read(self):
        fields = read_fields(self.write("good.vti", PLAIN))
        self.assert_equal(fields["phi"], [[1, 2.5]])
        self.assertIsNone(fields.time)
        self.refuses(lambda _: fields["psi"], self.folder / "good.vti", None, "no column 'psi'", "phi")
        self.refuses(lambda _: fields.tensor("phi"), self.folder / "good.vti", None, "a tensor", "found 1")

    def test_in_space_the_slowest_axis_comes_first(self):
        text = PLAIN.replace("0 1 0 0 0 0", "0 1 0 0 0 2").replace("1 2.5", "1 2 3 4 5 6")
        self.assert_equal(read_fields(self.write("space.vti", text))["phi"], [[[1, 2]], [[3, 4]], [[5, 6]]])

    def test_what_is_no_image(self):
        for content, line in (("", 1), ("hello", 1), (b"\x7fELF\0\0", 1), ("<a>\n<b></a>", 2), ("\n", 2)):
            self.refuses(read_fields, self.write("bad.vti", content), line, "VTK image data (XML)")
        self.refuses(read_fields, self.write("bad.vti", "<html/>"), None, "type ImageData", "'html'")
        self.changed('"ImageData"', '"PolyData"', None, "type ImageData", "'PolyData'")
        self.refuses(read_fields, self.folder, None, "no regular file")

    def test_grids_that_are_not_ours(self):
        self.changed('<Piece Extent="0 1', '<Piece Extent="0 0', None, "one piece that is the whole image")
        self.changed("0 1 0 0 0 0", "1 0 0 0 0 0", None, "one place or more")
        self.changed('WholeExtent="0 1 0 0 0 0"', 'WholeExtent="0 1 0 0"', None, "WholeExtent",
                     "6 whole numbers")
        self.changed('Spacing="1 1 1"', 'Spacing="1 nan 1"', None, "Spacing", "'1 nan 1'")
        self.changed('Origin="0 0 0"', "", None, "Origin", "3 numbers")
        self.changed('Spacing="1 1 1"', 'Spacing="1 1 1" Direction="0 1 0 1 0 0 0 0 1"', None, "Direction")

    def test_grids_that_are_larger_than_their_data(self):
        none = PLAIN.replace('<DataArray type="Float64" Name="phi" format="ascii">1 2.5</DataArray>', "")
        for last in ("1", "1999999999", "999999999999999999"):
            self.changed("0 1 0 0 0 0", f"0 {last} 0 0 0 0", None, "a field or more", text=none)
        self.changed("0 1 0 0 0 0", "0 249999999 0 0 0 0", None, "expected 250000000 numbers")
        self.changed("0 1 0 0 0 0", "0 250000000 0 0 0 0", None,
                     "expected at most 250000000 numbers, one for each place and component, found 250000001")
        self.changed('Spacing="1 1 1"', 'Spacing="1e308 1 1"', None, "places that are finite")
        self.changed("0 1 0 0 0 0", "9 10 0 0 0 0", None, "places that are finite",
                     text=PLAIN.replace('Spacing="1 1 1"', 'Spacing="1e308 1 1"'))

    def test_parts_that_are_elsewhere(self):
        self.changed("<Piece", '<AppendedData encoding="raw">_xx</AppendedData><Piece', None,
                     "AppendedData as a part of VTKFile itself")
        self.changed("<VTKFile", '<?xml version="1.0" encoding="foo"?><VTKFile', None, "unknown encoding")
        nan = coded(8, then=np.array([np.nan]).tobytes())
        self.changed("<Piece", '<FieldData><DataArray type="Float64" Name="TimeValue" format="binary">' + nan
                     + "</DataArray></FieldData><Piece", None, "'TimeValue'", "a finite number, found nan")

    def test_types_and_encodings_that_are_not_known(self):
        self.changed("LittleEndian", "MiddleEndian", None, "byte_order", "'MiddleEndian'")
        self.changed('"LittleEndian"', '"LittleEndian" header_type="UInt8"', None, "header_type", "'UInt8'")
        self.changed("Float64", "String", None, "type", "'String'")
        self.changed('"ascii"', '"hex"', None, "format", "'hex'")
        self.changed('format="ascii"', 'format="appended" offset="0"', None, "expected appended data")
        appended = PLAIN.replace('format="ascii"', 'format="appended" offset="0"')
        self.changed("</ImageData>", '</ImageData><AppendedData encoding="zip">_AAAA</AppendedData>', None,
                     "AppendedData encoding", "'zip'", text=appended)

    def test_values_that_are_too_few_too_many_or_none(self):
        self.changed("1 2.5", "1", None, "field 'phi'", "expected 2 numbers", "found 1")
        self.changed("1 2.5", "1 2 3", None, "expected 2 numbers", "found 3")
        self.changed("1 2.5", "1 nan", None, "finite numbers", "'nan'")
        self.changed("1 2.5", "1 1e999", None, "finite numbers", "'1e999'")
        self.changed("1 2.5", "1 256", None, "numbers of UInt8", "'256'",
                     text=PLAIN.replace("Float64", "UInt8"))
        self.changed("x", "x", None, "numbers of Int32", "'2.5'", text=PLAIN.replace("Float64", "Int32"))
        self.changed('Name="phi"', 'Name="phi" NumberOfComponents="2"', None, "expected 4 numbers")
        self.changed('Name="phi"', 'Name="phi" NumberOfComponents="0"', None, "one component or more")
        another = '<DataArray type="Float64" Name="phi" format="ascii">1 2</DataArray>'
        self.changed("<DataArray", another + "<DataArray", None, "'phi' twice")

    def binary(self, text, compressed=False):
        """The image with these data in base64. Returns its path."""
        content = PLAIN.replace('format="ascii">1 2.5', f'format="binary">{text}')
        if compressed:
            content = content.replace('LittleEndian"', 'LittleEndian" compressor="vtkZLibDataCompressor"')
        return self.write("binary.vti", content)

    def refuses_binary(self, text, *words, compressed=False):
        self.refuses(read_fields, self.binary(text, compressed), None, *words)

    def test_binary_data_of_another_size(self):
        values = np.array([1, 2.5]).tobytes()
        good = coded(16, then=values)
        self.assert_equal(read_fields(self.binary(good))["phi"], [[1, 2.5]])
        self.refuses_binary(good[:-4], "is cut short")
        self.refuses_binary("!" + good[1:], "base64")
        self.refuses_binary(coded(8, then=values), "expected 16 bytes", "found 8")
        self.refuses_binary(coded(16, then=np.array([1, np.inf]).tobytes()), "found inf at place 1")

    def test_compressed_data_that_claim_what_they_are_not(self):
        def refused(text, *words):
            self.refuses_binary(text, *words, compressed=True)
        packed = zlib.compress(np.array([1, 2.5]).tobytes())
        good = coded(1, 16, 0, len(packed)) + coded(then=packed)
        self.assert_equal(read_fields(self.binary(good, compressed=True))["phi"], [[1, 2.5]])
        # Without its checksum, the last four bytes, a block may have any content.
        refused(coded(1, 16, 0, len(packed) - 4) + coded(then=packed[:-4]), "compressed block is damaged")
        long = zlib.compress(bytes(10**6))
        refused(coded(1, 16, 0, len(long)) + coded(then=long), "compressed block is damaged")
        refused(coded(4_000_000_000), "is cut short: expected 4000000000 compressed blocks")
        refused(coded(1, 8, 0, 4), "expected 16 bytes", "found 8")
        refused(coded(1, 16, 0, 4) + "AAAAAA==", "compressed block is damaged")
        refused(coded(1, 16, 0, 400) + "AAAAAA==", "is cut short")
        refused(coded(0, 16, 0), "expected 16 bytes", "found 0")

    def test_a_block_of_more_bytes_than_an_address_can_count(self):
        size = 1_518_000_000 * 10**9 * 8
        self.assertTrue(2**63 < size < 2**64)
        packed = zlib.compress(bytes(10))
        head = base64.b64encode(np.array([1, size, 0, len(packed)], "<u8").tobytes()).decode()
        text = PLAIN.replace("0 1 0 0 0 0", "0 1517999999 0 999999999 0 0").replace(
            'format="ascii">1 2.5', f'format="binary">{head}{coded(then=packed)}').replace(
            'LittleEndian"', 'LittleEndian" header_type="UInt64" compressor="vtkZLibDataCompressor"')
        self.refuses(read_fields, self.write("bad.vti", text), None, "at most 250000000 numbers")


if __name__ == "__main__":
    unittest.main()
