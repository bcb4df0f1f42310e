# SPDX-License-Identifier: GPL-2.0-or-later
"""Reader for the record of a run, i.e. the file that fix bearing/record writes.

The file is in netCDF classic format, so `xarray.open_dataset` can open it without this module. It
may still be growing: each read covers the samples that the header counts at that time.
"""

import re
import struct
from collections.abc import Iterator, Mapping
from functools import cached_property
from mmap import ACCESS_READ, mmap
from pathlib import Path
from typing import Any

import numpy as np

from raceway.arrays import Floats
from raceway.core import library
from raceway.errors import RunError, unreadable
from raceway.files import FilePath
from raceway.runs import netcdf_header
from raceway.runs.frame import along, own_name

NAME = "record.nc"
BLOCK = 8 << 20  # bytes per read
CHECKSUM = "checksum"  # attribute and variable, see src-package/core/record/netcdf_header.h
HEADER_SUM = re.compile(rb"sum ([0-9a-f]{8}) of (\d{10}) header bytes")
DAMAGED = (TypeError, ValueError, LookupError, ArithmeticError, MemoryError, struct.error)
CAGE_RING = 2  # value of ring_raceway for a one-piece cage
NUMBERS = (("time",), ("time", "ring"), ("time", "bearing"))


class _Known(dict):
    def __init__(self, path, values):
        super().__init__(values)
        self.path = path

    def __missing__(self, name):
        raise RunError(f"{self.path} has no variable {name}")


class Record:
    """The record in `folder`, for all its bearings or for the one with the number `bearing`.

    Bearings are numbered from 1. The components of vectors refer to the frame of the bearings
    (`runs.frame`), whose z axis is the bearing axis. Positions are relative to the seat of the
    selected bearing or, for all bearings, to the origin of the host's box.

    Arrays are read on demand, from sample `start` to `stop`. Every sample that is read is verified
    by means of its checksum. `checked` is False for a record from a version without checksums.
    Raises `RunError` if the folder has no record, if the file is damaged or not a record, and if
    the bearing number is unknown.
    """

    def __init__(self, folder: FilePath, bearing: int | None = None) -> None:
        self.path = Path(folder) / NAME
        if not self.path.exists():
            raise RunError(f"{folder} {_without_record(Path(folder))}")
        try:
            with (
                open(self.path, "rb") as file,
                mmap(file.fileno(), 0, access=ACCESS_READ) as content,
            ):
                self.checked = _check_header(self.path, content)
                self._describe(netcdf_header.read(content), content)
        except OSError as error:
            raise RunError(unreadable(self.path, error)) from None
        except DAMAGED:
            raise RunError(
                f"cannot read {self.path}: it is truncated or damaged, or it is not a record"
            ) from None
        self.variables = self.known(self.variables)
        self._fixed = self.known(self._fixed)
        if missing := {"time", "ball", "bearing", "ring_bearing", "finished"} - set(self.variables):
            raise RunError(f"{self.path} has no variable {' '.join(sorted(missing))}")
        self.attrs.pop(CHECKSUM, None)
        self._check_length()
        self.bearings = self._fixed["bearing"].tolist()
        if bearing is None and len(self.bearings) == 1:
            bearing = self.bearings[0]
        if bearing is not None and bearing not in self.bearings:
            raise RunError(
                f"{self.path} has bearings {self.bearings[0]} to {self.bearings[-1]}, but no"
                f" bearing {bearing}"
            )
        self.bearing = bearing
        self._slices: dict[str, slice] = {}  # parts of the dimensions that have been needed
        self._seat = [0.0, 0.0, 0.0] if bearing is None else self._seat_of_outer()
        self.record_bytes = self._row.itemsize
        self._kept = (0, np.empty(0, self._row))  # the first sample of a block and its samples
        self._numbers: tuple[tuple[int, int], dict[str, Floats]] = ((-1, -1), {})  # none yet

    def _check_length(self):
        """Check that a finished record has exactly as many samples as its header states.

        A growing record may have more.
        """
        if (CHECKSUM in self.variables) != self.checked:
            raise RunError(f"{self.path} is damaged: the checksum of its header is missing")
        bytes_, samples = self.path.stat().st_size, len(self)
        wanted = self._begin + samples * self._row.itemsize
        if bytes_ < wanted or (self._finished and bytes_ > wanted):
            raise RunError(
                f"cannot read {self.path}: it is truncated or damaged: {samples} samples need"
                f" {wanted} bytes, but it has {bytes_}"
            )

    def _check_samples(self, rows, first):
        """Verify the checksums of whole samples, of which the first has the number `first`."""
        if not self.checked:
            return
        wrong = np.flatnonzero(_sums(rows, len(rows), first) != rows[CHECKSUM].astype(np.uint32))
        if len(wrong):
            raise RunError(
                f"{self.path} is damaged: sample {first + wrong[0] + 1} differs from its checksum."
                " Run its deck again"
            )

    def _describe(self, header, content):
        self.attrs = header.attributes
        axis = self.attrs.get("axis", "z")
        held = {own_name(name, axis): v for name, v in header.variables.items()}
        self.variables = {name: v.dimensions for name, v in held.items()}
        self._held = header.variables
        self._fixed = {name: v.values(content) for name, v in held.items() if not v.timed}
        timed = {name: v for name, v in held.items() if v.timed}
        self._begin = min(v.begin for v in timed.values())
        self._row = np.dtype(
            {
                "names": list(timed),
                "formats": [(v.dtype, v.shape) for v in timed.values()],
                "offsets": [v.begin - self._begin for v in timed.values()],
                "itemsize": sum(v.size for v in timed.values()),
            }
        )
        self._finished = bool(np.any(self._fixed["finished"]))
        self._samples = header.samples

    @cached_property
    def about(self) -> dict[str, dict[str, str | float]]:
        """The attributes of the variables."""
        return {name: v.attributes for name, v in self._held.items()}

    def _seat_of_outer(self):
        """Return the origin of the bearing's frame in the host's box, in components of that
        frame."""
        last = np.argmax(self.fixed("ring_raceway") % CAGE_RING)  # 0: an inner ring or a cage
        return [float(self._fixed[f"ring_origin_{x}"][self.part("ring")][last]) for x in "xyz"]

    def _from_seat(self, name, values):
        place = along(name)
        return values if place is None or not self._seat[place] else values - self._seat[place]

    def known(self, values: Mapping[str, Any]) -> dict[str, Any]:
        """Return `values` as a dict that raises `RunError` for a missing variable."""
        return _Known(self.path, values)

    def __len__(self) -> int:
        """Return the number of samples that the header counts at this time."""
        if self._finished:
            return self._samples
        with open(self.path, "rb", buffering=0) as file:
            return int.from_bytes(
                file.read(8)[4:], "big"
            )  # netCDF classic: after "CDF" and version

    def part(self, dimension: str) -> slice:
        """Return the slice of a dimension that belongs to the selected bearing."""
        if self.bearing is None or dimension not in ("ball", "cage_ball", "ring", "bearing"):
            return slice(None)
        if dimension not in self._slices:
            owner = self._fixed["bearing" if dimension == "bearing" else f"{dimension}_bearing"]
            here = np.flatnonzero(owner == self.bearing)
            self._slices[dimension] = slice(here[0], here[-1] + 1) if len(here) else slice(0, 0)
        return self._slices[dimension]

    def fixed(self, name: str) -> np.ndarray:
        """Return the values of a variable without a time dimension for the selected bearing."""
        dims = self.variables[name]
        return self._from_seat(name, self._fixed[name][tuple(self.part(dim) for dim in dims)])

    def read(self, names: list[str], start: int = 0, stop: int | None = None) -> dict[str, Floats]:
        """Return {name: array} for variables with a time dimension, in native byte order.

        The arrays cover the selected bearing. The file is read only once. A block that was read is
        kept until another one is read. From a record that is larger, variables with one number per
        sample and bearing or ring are read together and kept, because a summary reads such
        variables one by one.
        """
        first, last, _ = slice(start, stop).indices(len(self))
        numbers = [n for n, dims in self.variables.items() if dims in NUMBERS]
        if last - first <= self._block or not set(names) <= set(numbers):
            return self._scan(names, first, last)
        kept, end = self._numbers[0]
        if not kept <= first <= last <= end:
            kept = first
            self._numbers = (first, last), self._scan(numbers, first, last)
        return {name: self._numbers[1][name][first - kept : last - kept] for name in names}

    def _scan(self, names, first, last):
        """Return {name: array} for the samples `first` to `last`."""
        parts = {n: (slice(None), *self._parts(n)) for n in names}
        count = max(0, last - first)
        none = np.empty(0, self._row)
        found = {n: np.empty((count, *none[n][part].shape[1:])) for n, part in parts.items()}
        for at, rows in self._rows(first, count):
            for name, part in parts.items():
                found[name][at : at + len(rows)] = rows[name][part]
        return {name: self._from_seat(name, values) for name, values in found.items()}

    def _rows(self, first, count):
        """Yield (number from 0, samples) for blocks of `count` samples from `first`."""
        kept, rows = self._kept
        if kept <= first and first + count <= kept + len(rows):
            yield 0, rows[first - kept : first - kept + count]
            return
        rows = np.empty(min(count, self._block), self._row)
        with open(self.path, "rb", buffering=0) as file:
            file.seek(self._begin + first * self.record_bytes)
            for at in range(0, count, self._block):
                some = rows[: count - at]
                if file.readinto(memoryview(some).cast("B")) != some.nbytes:
                    raise RunError(f"{self.path} ends before its sample {first + at + len(some)}")
                self._check_samples(some, first + at)
                yield at, some
        if count <= self._block:
            self._kept = first, rows

    @property
    def _block(self):
        """Number of samples in a block."""
        return max(1, BLOCK // self.record_bytes)

    def shape(self, name: str) -> tuple[int, ...]:
        """Return the shape of one sample of a variable with a time dimension, for the selected
        bearing."""
        return np.empty(0, self._row)[name][(slice(None), *self._parts(name))].shape[1:]

    def _parts(self, name):
        return tuple(self.part(dim) for dim in self.variables[name][1:])

    def pick(self, name: str, key: tuple) -> Floats:
        """Return the values of a variable with a time dimension at an index, for the selected
        bearing. The index has a slice, integer or array for each dimension."""
        time = key[0]
        if isinstance(time, slice) and time.step in (None, 1):
            values = self.read([name], time.start or 0, time.stop)[name]
        else:
            values = self._scattered(name, np.arange(len(self))[time])
        for axis, one in reversed(list(enumerate(key[1:]))):
            at = axis + (0 if isinstance(time, (int, np.integer)) else 1)
            values = values[(slice(None),) * at + (one,)]
        return values

    def _scattered(self, name, samples):
        """Return a variable at scattered samples. Those in between are read only if all of them
        fit into one block."""
        if np.size(samples) and np.ptp(samples) < self._block:
            first = np.min(samples)
            return self._scan([name], first, np.max(samples) + 1)[name][samples - first]
        parts = self._parts(name)
        row = np.empty(1, self._row)
        found = np.empty((np.size(samples), *row[name][(slice(None), *parts)].shape[1:]))
        with open(self.path, "rb", buffering=0) as file:
            for k, sample in enumerate(np.ravel(samples).tolist()):
                file.seek(self._begin + sample * self.record_bytes)
                if file.readinto(memoryview(row).cast("B")) != row.nbytes:
                    raise RunError(f"{self.path} ends before its sample {sample + 1}")
                self._check_samples(row, sample)
                found[k] = row[name][(0, *parts)]
        return self._from_seat(name, found.reshape((*np.shape(samples), *found.shape[1:])))

    @cached_property
    def raceways(self) -> list[str]:
        """Names of the raceways: "inner" and "outer", or "inner 0", "inner 1", "outer 0" and
        "outer 1" if a ball may touch two grooves of a ring."""
        return [b"".join(name).decode().strip() for name in self._fixed["raceway"]]

    @property
    def two_grooves(self) -> bool:
        """True if a ball may touch two grooves of a ring (gothic arch)."""
        return len(self.raceways) > 2

    @cached_property
    def contact_columns(self) -> list[str]:
        """Names of the contact columns; empty for a summary record."""
        return [n for n, dims in self.variables.items() if dims == ("time", "raceway", "ball")]

    def blocks(self, start: int, stop: int | None) -> Iterator[tuple[int, int]]:
        """Yield (start, stop) of blocks of a few MB."""
        self.need_samples()
        stop = len(self) if stop is None else min(stop, len(self))
        if start >= stop:
            raise RunError(f"{self.path} has {len(self)} samples, none from number {start} on")
        for first in range(start, stop, self._block):
            yield first, min(first + self._block, stop)

    def timed(self, prefix: str) -> list[str]:
        """Return the names of the variables with a time dimension that begin with `prefix`."""
        return [n for n, dims in self.variables.items() if n.startswith(prefix) and "time" in dims]

    def need_one(self) -> None:
        """Raise `RunError` unless the record has one bearing or one has been selected."""
        if self.bearing is None:
            raise RunError(
                f"{self.path} has {len(self.bearings)} bearings: select one with --bearing NUMBER"
                " or, in Python, with run.select(number)"
            )

    def need_samples(self) -> None:
        """Raise `RunError` if the header counts no samples."""
        if not len(self):
            raise RunError(f"{self.path} has no samples: its run has just begun or was stopped")

    def need_contacts(self) -> None:
        """Raise `RunError` if the record has no contact columns."""
        if not self.contact_columns:
            raise RunError(
                f"{self.path} has no contacts: record them with -var record all or, in your own"
                " deck, with 'contacts usual' of fix bearing/record"
            )


def _without_record(folder):
    """Return the reason why the folder has no record, and the remedy."""
    if not folder.is_dir():
        return "is not a folder: a run with -var out NAME creates one"
    if (folder / "contacts.dump").exists() or (folder / "balls.dump").exists():
        return (
            f"has text dumps but no {NAME}: raceway reads records; run the deck again with -var"
            " record all, or read the dumps with raceway at commit a7b5052"
        )
    return (
        f"has no {NAME}: its run recorded nothing, or the file was removed; -var record all or fix"
        " bearing/record writes one"
    )


def _check_header(path, content):
    """Return True if the header has a valid checksum, and False if it has no checksum."""
    if not (said := HEADER_SUM.search(content, 0, 1 << 16)):
        return False
    head = bytearray(content[: int(said[2])])
    head[4:8] = bytes(4)  # number of samples
    head[slice(*said.span(1))] = b"0" * 8
    if len(head) < int(said[2]) or _sums(head, 1) != int(said[1], 16):
        raise RunError(f"cannot read {path}: it is truncated or damaged in its header")
    return True


def _sums(content, samples, first=None):
    """Return the checksum of a header, or the checksums of samples.

    `first` is the number of the first sample. Each sample ends with its recorded checksum, which is
    not included in the sum.
    """
    numbers, sums = np.frombuffer(content, np.int32), np.empty(samples, np.int32)
    width = len(numbers) // max(samples, 1)
    library().call(
        "record_checksums",
        samples=samples,
        width=width,
        summed=width if first is None else width - 1,
        first=first or 0,
        rows=numbers,
        sums=sums,
    )
    return sums.view(np.uint32)
