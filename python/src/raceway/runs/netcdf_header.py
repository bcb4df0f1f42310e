# SPDX-License-Identifier: GPL-2.0-or-later
"""Read the header of a file in netCDF classic format, which describes the variables and their
places. The format is specified in the NetCDF User Guide, "File Format Specifications".

Other readers also arrange the values of all variables, which takes longer than a summary needs for
the few that it reads.
"""

import math
import struct
from mmap import mmap
from typing import NamedTuple

import numpy as np

COUNT, PAIR = struct.Struct(">i"), struct.Struct(">2i")
PLACES = {1: struct.Struct(">i"), 2: struct.Struct(">q")}  # by the version of the format
TEXT = 2  # the type of characters
TYPES = {1: ">i1", TEXT: "S1", 3: ">i2", 4: ">i4", 5: ">f4", 6: ">f8"}
DTYPES = {kind: np.dtype(name) for kind, name in TYPES.items()}
DIMENSIONS, VARIABLES, ATTRIBUTES = 10, 11, 12  # tags of lists


class Variable(NamedTuple):
    """A variable of the file. The `shape` of a `timed` variable is that of one sample, and `begin`
    is the offset of its first sample."""

    dimensions: tuple[str, ...]
    shape: tuple[int, ...]
    timed: bool
    about: bytes  # its list of attributes
    dtype: np.dtype
    begin: int

    @property
    def size(self) -> int:
        """Number of bytes, or the number in one sample, a multiple of 4."""
        return _whole(math.prod(self.shape) * self.dtype.itemsize)

    @property
    def attributes(self) -> dict[str, str | float]:
        """The attributes of the variable."""
        return _Reader(self.about).attributes()

    def values(self, content: mmap) -> np.ndarray:
        """Return the values of a variable without time, in native byte order."""
        count = math.prod(self.shape)
        held = content[self.begin : self.begin + count * self.dtype.itemsize]
        found = np.frombuffer(held, self.dtype, count).reshape(self.shape)
        return found.astype(self.dtype.newbyteorder("="))


class Header(NamedTuple):
    """A header: the number of samples, the attributes of the file and its variables."""

    samples: int
    attributes: dict[str, str | float]
    variables: dict[str, Variable]


def read(content: mmap) -> Header:
    """Return the `Header` at the beginning of `content`.

    Raise `ValueError`, `LookupError`, `TypeError` or `struct.error` if there is none.
    """
    if content[:3] != b"CDF":
        raise ValueError("not in netCDF classic format")
    place, reader = PLACES[content[3]], _Reader(content, 4)
    samples = reader.number()
    dimensions = [(reader.text(), reader.number()) for _ in reader.items(DIMENSIONS)]
    attributes = reader.attributes()
    found = {}
    for _ in reader.items(VARIABLES):
        name = reader.text()
        own = [dimensions[reader.number()] for _ in range(reader.number())]
        timed = bool(own) and own[0][1] == 0  # the length 0 marks the dimension of the samples
        about = reader.skip_attributes()
        kind, _ = reader.take(PAIR)
        (begin,) = reader.take(place)
        names, shape = zip(*own) if own else ((), ())
        found[name] = Variable(names, shape[int(timed) :], timed, about, DTYPES[kind], begin)
    return Header(samples, attributes, found)


class _Reader:
    """Reads one part of a header after another."""

    def __init__(self, content, at=0):
        self._content, self._at = content, at

    def take(self, numbers):
        found = numbers.unpack_from(self._content, self._at)
        if found[0] < 0:
            raise ValueError(f"{found[0]} is negative")
        self._at += numbers.size
        return found

    def number(self):
        return self.take(COUNT)[0]

    def items(self, tag):
        """Return the range of the numbers of the items in a list."""
        said, count = self.take(PAIR)
        if said != tag and (said or count):
            raise ValueError(f"tag {said} instead of {tag}")
        return range(count)

    def text(self):
        return self._bytes(self.number()).decode()

    def attributes(self):
        return {self.text(): self._value() for _ in self.items(ATTRIBUTES)}

    def skip_attributes(self):
        """Return a list of attributes as it is in the file."""
        begin, content = self._at, self._content
        count, at = self.items(ATTRIBUTES), self._at
        for _ in count:
            at += 4 + _whole(COUNT.unpack_from(content, at)[0])
            kind, length = PAIR.unpack_from(content, at)
            at += 8 + _whole(length * DTYPES[kind].itemsize)
        self._at = at
        return content[begin:at]

    def _value(self):
        """Return a text or the first of several numbers."""
        kind, count = self.take(PAIR)
        found = self._bytes(count * DTYPES[kind].itemsize)
        if kind == TEXT:
            return found.rstrip(b"\0").decode()
        return float(np.frombuffer(found, DTYPES[kind])[0])

    def _bytes(self, count):
        found = self._content[self._at : self._at + count]
        if len(found) < count:
            raise ValueError("ends early")
        self._at += _whole(count)
        return found


def _whole(size):
    """Return `size` rounded up to a multiple of 4."""
    return (size + 3) & ~3
