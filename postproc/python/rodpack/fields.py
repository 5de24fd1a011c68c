# SPDX-License-Identifier: GPL-2.0-or-later
"""Coarse-grained fields on a grid: fields.vti of rodpack and of dump stress/goldhirsch.

Names, units and signs of the fields: liggghts-src-ext/doc/compute_stress_goldhirsch.md. Any VTK image data
of one piece is read, in all encodings that VTK's writer has: ascii, base64 or raw, inline or appended,
plain or compressed with zlib.
"""

import base64
import binascii
import math
import re
import zlib
from xml.etree import ElementTree

import numpy as np

from .errors import FormatError, no_such_column, shortened
from .named_arrays import NamedArrays
from .text import MOST_NUMBERS, number, open_regular, whole_number

_TYPES = {"Float64": "f8", "Float32": "f4", "Int64": "i8", "Int32": "i4", "Int16": "i2", "Int8": "i1",
          "UInt64": "u8", "UInt32": "u4", "UInt16": "u2", "UInt8": "u1"}
_ORDERS = {"LittleEndian": "<", "BigEndian": ">"}
_HEADERS = {"UInt32": "u4", "UInt64": "u8"}
# What stands behind the XML's own end where data are appended.
_APPENDED = re.compile(rb"<AppendedData([^>]*)>\s*_")


class Fields(NamedArrays):
    """Fields on a grid: a mapping from their names, with the unit as in the file, to arrays.

    Arrays have the shape (y, x), or (y, x, component); on a grid of several places along z (z, y, x) and
    (z, y, x, component). fields["mass_density_kg_m2"][j, i] is the value at (fields.x[i], fields.y[j]).

    origin, spacing: of x, y, z, m; count: places along x, y, z; x, y, z: the places along each, m; time: s,
    where the file says it, else None; components: for each field the names of its components, such as
    ("xx", "xy", "yx", "yy"), () for a scalar. Vectors have three components, of which that along z is 0 in
    planar scenes.
    """

    def __init__(self, file, origin, spacing, count, time, arrays, components):
        self.file, self.origin, self.spacing, self.count, self.time = file, origin, spacing, count, time
        self.x, self.y, self.z = (origin[k] + spacing[k] * np.arange(count[k]) for k in range(3))
        self.components = components
        self.names = tuple(arrays)
        self._arrays = arrays

    def __getitem__(self, name):
        if name not in self._arrays:
            raise no_such_column(self.file, None, name, self.names)
        return self._arrays[name]

    def __repr__(self):
        return f"<fields at {' x '.join(map(str, self.count))} places: {' '.join(self.names)}>"

    def tensor(self, name):
        """A field of components xx xy yx yy (2D; nine in space) as (y, x, 2, 2), row index first."""
        array = self[name]
        size = {4: 2, 9: 3}.get(len(self.components[name]))
        if size is None:
            raise FormatError(self.file, None, f"field '{shortened(name)}': expected a tensor of 4 or 9 "
                                               f"components, found {len(self.components[name]) or 1}")
        return array.reshape(array.shape[:-1] + (size, size))


def read_fields(file):
    """Reads fields.vti as Fields. FormatError names the file and what is wrong: no VTK image data, a file cut
    short, several pieces, a turned grid, an unknown type or encoding, data of another size than the grid's,
    and any value that is not finite."""
    with open_regular(file) as stream:
        return _Image(str(file), stream.read()).fields()


def _value(word, dtype):
    """The number of this type that a word is; None for anything else."""
    if dtype.kind == "f":
        return number(word)
    value, range_of = whole_number(word), np.iinfo(dtype)
    return value if value is not None and range_of.min <= value <= range_of.max else None


class _Image:
    """The XML of an image file and what is appended to it."""

    def __init__(self, file, content):
        self.file = file
        match = _APPENDED.search(content)
        self.appended, self.appended_encoding = None, None
        if match:
            end = content.rfind(b"</AppendedData>")
            if end < match.end() or b"</VTKFile>" not in content[end:]:
                self.fail("is cut short: expected </AppendedData> and </VTKFile> at its end")
            self.appended = content[match.end():end]
            content = content[:match.start()] + b"<AppendedData" + match[1] + b"/>" + content[end + 15:]
        try:
            self.root = ElementTree.fromstring(content)
        except (ElementTree.ParseError, ValueError, LookupError) as error:  # the last: an unknown encoding
            line = getattr(error, "position", (None,))[0]
            raise FormatError(file, line, f"expected VTK image data (XML), found an error: {error}") from None
        if match:
            element = self.root.find("AppendedData")
            if element is None:
                self.fail("expected AppendedData as a part of VTKFile itself, found it elsewhere")
            self.appended_encoding = element.get("encoding", "")

    def fail(self, message):
        raise FormatError(self.file, None, message)

    def choice(self, element, name, table, default=None):
        """What `table` has for an attribute. FormatError, which lists what is known, for anything else."""
        found = element.get(name, default)
        if found not in table:
            known = " or ".join(each or "none" for each in table)
            self.fail(f"{element.tag} {name}: expected {known}, found '{shortened(str(found))}'")
        return table[found]

    def numbers(self, element, name, count, whole=False):
        """An attribute of so many numbers."""
        found = [(whole_number if whole else number)(word) for word in element.get(name, "").split()]
        if len(found) != count or None in found:
            self.fail(f"{element.tag} {name}: expected {count} {'whole ' if whole else ''}numbers, found "
                      f"'{shortened(element.get(name, ''))}'")
        return found

    def fields(self):
        root = self.root
        if root.tag != "VTKFile" or root.get("type") != "ImageData" or root.find("ImageData") is None:
            self.fail(f"expected a VTKFile of type ImageData, found '{shortened(root.tag)}' of type "
                      f"'{shortened(root.get('type', ''))}'")
        order = self.choice(root, "byte_order", _ORDERS)
        self.order = order
        self.header = np.dtype(order + self.choice(root, "header_type", _HEADERS, "UInt32"))
        self.compressed = self.choice(root, "compressor", {"": False, "vtkZLibDataCompressor": True}, "")
        image = root.find("ImageData")
        pieces = image.findall("Piece")
        extent = self.numbers(image, "WholeExtent", 6, whole=True)
        if len(pieces) != 1 or self.numbers(pieces[0], "Extent", 6, whole=True) != extent:
            self.fail("expected one piece that is the whole image")
        upright = [1, 0, 0, 0, 1, 0, 0, 0, 1]
        if "Direction" in image.attrib and self.numbers(image, "Direction", 9) != upright:
            self.fail(f"expected a grid along x, y, z, found Direction '{shortened(image.get('Direction'))}'")
        count = tuple(extent[2 * k + 1] - extent[2 * k] + 1 for k in range(3))
        if min(count) < 1:
            self.fail(f"expected a grid of one place or more along x, y, z, found {count}")
        spacing = np.array(self.numbers(image, "Spacing", 3))
        with np.errstate(over="ignore"):  # is said below
            origin = np.array(self.numbers(image, "Origin", 3)) + spacing * extent[::2]

        arrays, components = {}, {}
        shape = count[::-1] if count[2] > 1 else count[1::-1]
        for element in pieces[0].findall("PointData/DataArray"):
            name = element.get("Name", "")
            if name in arrays:
                self.fail(f"expected each field once, found '{shortened(name)}' twice")
            width = 1
            if "NumberOfComponents" in element.attrib:
                width = self.numbers(element, "NumberOfComponents", 1, whole=True)[0]
            if width < 1:
                self.fail(f"field '{shortened(name)}': expected one component or more, found {width}")
            values = self.values(element, name, math.prod(count) * width)
            if not np.isfinite(values).all():
                place = int(np.flatnonzero(~np.isfinite(values))[0])
                self.fail(f"field '{shortened(name)}': expected finite numbers, found {values[place]} at "
                          f"place {place // width}")
            arrays[name] = values.reshape(shape + (width,) if width > 1 else shape)
            unnamed = "xyz" if width == 3 else [str(k) for k in range(width)]
            names = tuple(element.get(f"ComponentName{k}", unnamed[k]) for k in range(width))
            components[name] = names if width > 1 else ()
        if not arrays:  # which have shown by their sizes that there are as many places as is said
            self.fail("expected a field or more in PointData, found none")
        with np.errstate(over="ignore", invalid="ignore"):
            last = origin + spacing * np.array(count)
        if not np.isfinite(last).all():
            self.fail("expected places that are finite numbers, found a grid of Spacing "
                      f"'{shortened(image.get('Spacing', ''))}' beyond them")
        return Fields(self.file, origin, spacing, count, self.time(image), arrays, components)

    def time(self, image):
        for element in image.findall("FieldData/DataArray"):
            if element.get("Name") == "TimeValue":
                time = float(self.values(element, "TimeValue", 1)[0])
                if not math.isfinite(time):
                    self.fail(f"field 'TimeValue': expected a finite number, found {time}")
                return time
        return None

    def values(self, element, name, size):
        """The `size` values of a DataArray."""
        dtype = np.dtype(self.order + self.choice(element, "type", _TYPES))
        form = self.choice(element, "format", {each: each for each in ("ascii", "binary", "appended")})
        where = f"field '{shortened(name)}'"
        if size > MOST_NUMBERS:
            self.fail(f"{where}: expected at most {MOST_NUMBERS} numbers, one for each place and component, "
                      f"found {size}")
        if form == "ascii":
            words = (element.text or "").split()
            found = [_value(word, dtype) for word in words]
            if None in found:
                self.fail(f"{where}: expected finite numbers of {element.get('type')}, found "
                          f"'{shortened(words[found.index(None)])}'")
            if len(found) != size:
                self.fail(f"{where}: expected {size} numbers, one for each place and component, found "
                          f"{len(found)}")
            return np.array(found, dtype.newbyteorder("="))
        if form == "binary":
            source = _Base64(self, where, (element.text or "").strip().encode())
        else:
            if self.appended is None:
                self.fail(f"{where}: expected appended data, found none in the file")
            offset = self.numbers(element, "offset", 1, whole=True)[0]
            if not 0 <= offset < len(self.appended):
                self.fail(f"{where}: expected an offset below {len(self.appended)}, where the data end, "
                          f"found {offset}")
            known = {"base64": _Base64, "raw": _Raw}
            if self.appended_encoding not in known:
                self.fail(f"AppendedData encoding: expected {' or '.join(known)}, found "
                          f"'{shortened(self.appended_encoding)}'")
            source = known[self.appended_encoding](self, where, self.appended[offset:])
        read = self.compressed_bytes if self.compressed else self.plain_bytes
        data = read(source, where, size * dtype.itemsize)
        return np.frombuffer(data, dtype).astype(dtype.newbyteorder("="))

    def plain_bytes(self, source, where, size):
        """Layout: number of bytes, bytes; in base64 coded together."""
        head = source.take(self.header.itemsize + size)
        stated = int(np.frombuffer(head, self.header, 1)[0])
        if stated != size:
            self.fail(f"{where}: expected {size} bytes for the grid's places, found {stated}")
        return head[self.header.itemsize:]

    def compressed_bytes(self, source, where, size):
        """Layout: number of blocks, size of a block and of the last one before compression (0: as the
        others), size of each compressed; then the blocks. In base64 both are coded by themselves."""
        word = self.header.itemsize
        blocks = int(np.frombuffer(source.peek(word), self.header)[0])
        # A block is larger than its header; the whole is no longer than the file.
        if blocks * word > len(source.data):
            self.fail(f"{where}: is cut short: expected {blocks} compressed blocks")
        head = np.frombuffer(source.take((3 + blocks) * word), self.header).astype(object)
        full, partial, lengths = int(head[1]), int(head[2]), [int(each) for each in head[3:]]
        sizes = [full] * blocks
        if blocks and partial:
            sizes[-1] = partial
        if sum(sizes) != size:
            self.fail(f"{where}: expected {size} bytes for the grid's places, found {sum(sizes)}")
        data = source.take(sum(lengths))
        parts, at = [], 0
        for expected, length in zip(sizes, lengths):
            unpack = zlib.decompressobj()
            try:
                # One byte more than is expected shows a block that is too long, whatever it would grow to.
                part = unpack.decompress(data[at:at + length], expected + 1)
            except zlib.error:
                part = b""
            if len(part) != expected or not unpack.eof:
                self.fail(f"{where}: a compressed block is damaged: expected one of {expected} bytes")
            parts.append(part)
            at += length
        return b"".join(parts)


class _Raw:
    """Bytes as they are."""

    def __init__(self, image, where, data):
        self.image, self.where, self.data, self.at = image, where, data, 0

    def stored(self, count):
        """Bytes in the file that hold `count` of the data."""
        return count

    def decoded(self, stored):
        return stored

    def peek(self, count):
        """The next `count` bytes of the data. FormatError where there are fewer."""
        stored = self.data[self.at:self.at + self.stored(count)]
        data = self.decoded(stored)[:count]
        if len(data) != count:
            self.image.fail(f"{self.where}: is cut short: expected {count} bytes, found {len(data)}")
        return data

    def take(self, count):
        """The same, and steps behind them, in base64 to the next group of four characters."""
        data = self.peek(count)
        self.at += self.stored(count)
        return data


class _Base64(_Raw):
    """Bytes coded in base64: four characters for each three."""

    def stored(self, count):
        return (count + 2) // 3 * 4

    def decoded(self, stored):
        try:
            return base64.b64decode(stored, validate=True)
        except (binascii.Error, ValueError):
            found = shortened(stored.decode("latin-1"))
            self.image.fail(f"{self.where}: expected data in base64, found '{found}'")
