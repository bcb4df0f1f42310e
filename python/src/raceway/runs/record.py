# SPDX-License-Identifier: GPL-2.0-or-later
"""The record of a run: the file that fix bearing/record wrote, read in pieces.

The file is netCDF classic: `xarray.open_dataset` opens it without this module. It may still be
growing: each read sees the samples that its header counts at that moment.
"""

from collections.abc import Iterator, Mapping
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from scipy.io import netcdf_file

from raceway.arrays import Floats
from raceway.errors import RunError
from raceway.files import FilePath

NAME = "record.nc"
BLOCK = 8 << 20  # bytes per read
NUMBERS = (("time",), ("time", "ring"), ("time", "bearing"))


class _Known(dict):
    def __init__(self, path, values):
        super().__init__(values)
        self.path = path

    def __missing__(self, name):
        raise RunError(f"{self.path} has no variable {name}")


class Record:
    """The record in `folder`: all its bearings, or the one with the number `bearing` (from 1).

    Arrays are read on demand, from sample `start` to `stop`. Raises `RunError` for a folder without
    record, a file that is broken or of another kind, and an unknown bearing number.
    """

    def __init__(self, folder: FilePath, bearing: int | None = None) -> None:
        self.path = Path(folder) / NAME
        if not self.path.exists():
            raise RunError(f"{folder} {_without_record(Path(folder))}")
        try:
            with netcdf_file(self.path, mmap=True) as file:
                self.attrs = {name: _plain(value) for name, value in file._attributes.items()}
                self.variables = {name: v.dimensions for name, v in file.variables.items()}
                self.about = {
                    name: {key: _plain(value) for key, value in v._attributes.items()}
                    for name, v in file.variables.items()
                }
                self._fixed = {
                    name: v.data.astype(v.data.dtype.newbyteorder("="))
                    for name, v in file.variables.items()
                    if "time" not in v.dimensions
                }
                self._row = _row(file)
                self._begin = _begin(file)
        except OSError as error:
            raise RunError(f"cannot read {self.path}: {error.strerror or error}") from None
        except (TypeError, ValueError, KeyError, IndexError):  # raised by scipy for such bytes
            raise RunError(
                f"cannot read {self.path}: it is cut short or damaged, or no record at all"
            ) from None
        self.variables = self.known(self.variables)
        self._fixed = self.known(self._fixed)
        if missing := {"time", "ball", "ring_bearing", "finished"} - set(self.variables):
            raise RunError(f"{self.path} has no variable {' '.join(sorted(missing))}")
        self.bearings = self._fixed["bearing"].tolist()
        if bearing is None and len(self.bearings) == 1:
            bearing = self.bearings[0]
        if bearing is not None and bearing not in self.bearings:
            raise RunError(
                f"{self.path} has the bearings {self.bearings[0]} to {self.bearings[-1]},"
                f" not {bearing}"
            )
        self.bearing = bearing
        self.record_bytes = self._row.itemsize
        self._numbers: tuple[tuple[int, int], dict[str, Floats]] = ((-1, -1), {})  # none yet

    def known(self, values: Mapping[str, Any]) -> dict[str, Any]:
        """`values` by variable; a missing name raises `RunError`."""
        return _Known(self.path, values)

    def __len__(self) -> int:
        """Number of samples in the header at this moment."""
        with open(self.path, "rb", buffering=0) as file:
            return int.from_bytes(
                file.read(8)[4:], "big"
            )  # netCDF classic: after "CDF" and version

    def part(self, dimension: str) -> slice:
        """Slice of a dimension that belongs to the bearing."""
        if self.bearing is None or dimension not in ("ball", "cage_ball", "ring", "bearing"):
            return slice(None)
        owner = self._fixed["bearing" if dimension == "bearing" else f"{dimension}_bearing"]
        here = np.flatnonzero(owner == self.bearing)
        return slice(here[0], here[-1] + 1) if len(here) else slice(0, 0)

    def fixed(self, name: str) -> np.ndarray:
        """The bearing's values of a variable without time."""
        dims = self.variables[name]
        return self._fixed[name][tuple(self.part(dim) for dim in dims)]

    def read(self, names: list[str], start: int = 0, stop: int | None = None) -> dict[str, Floats]:
        """{name: array} of variables with time, native byte order, for the bearing.

        The file is read once. Variables with one number per sample and bearing or ring are read
        together and cached until other samples are requested: a summary needs them one by one.
        """
        first, last, _ = slice(start, stop).indices(len(self))
        numbers = [n for n, dims in self.variables.items() if dims in NUMBERS]
        if not set(names) <= set(numbers):
            return self._scan(names, first, last)
        if self._numbers[0] != (first, last):
            self._numbers = (first, last), self._scan(numbers, first, last)
        return {name: self._numbers[1][name] for name in names}

    def _scan(self, names, first, last):
        """{name: array} of the samples `first` to `last`, a few MB of the file at a time."""
        parts = {n: (slice(None), *self._parts(n)) for n in names}
        count = max(0, last - first)
        none = np.empty(0, self._row)
        found = {n: np.empty((count, *none[n][part].shape[1:])) for n, part in parts.items()}
        rows = np.empty(min(count, max(1, BLOCK // self.record_bytes)), self._row)
        with open(self.path, "rb", buffering=0) as file:
            file.seek(self._begin + first * self.record_bytes)
            for at in range(0, count, max(1, len(rows))):
                some = rows[: count - at]
                if file.readinto(memoryview(some).cast("B")) != some.nbytes:
                    raise RunError(f"{self.path} ends before its sample {first + at + len(some)}")
                for name, part in parts.items():
                    found[name][at : at + len(some)] = some[name][part]
        return found

    def shape(self, name: str) -> tuple[int, ...]:
        """Shape of one sample of a variable with time, for the bearing."""
        return np.empty(0, self._row)[name][(slice(None), *self._parts(name))].shape[1:]

    def _parts(self, name):
        return tuple(self.part(dim) for dim in self.variables[name][1:])

    def pick(self, name: str, key: tuple) -> Floats:
        """Values of a variable with time at an index (slices, integers and arrays, one per
        dimension), for the bearing."""
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
        """A variable at scattered samples; the samples between are neither read nor mapped."""
        kind, offset = self._row.fields[name][:2]
        rows = np.empty((np.size(samples), kind.itemsize), np.uint8)
        with open(self.path, "rb", buffering=0) as file:
            for row, sample in zip(rows, np.ravel(samples).tolist(), strict=True):
                file.seek(self._begin + sample * self.record_bytes + offset)
                if file.readinto(row) != row.nbytes:
                    raise RunError(f"{self.path} ends before its sample {sample + 1}")
        found = rows.view(kind.base).reshape((*np.shape(samples), *kind.shape))
        return found[(..., *self._parts(name))].astype(float)

    @cached_property
    def raceways(self) -> list[str]:
        """ "inner" and "outer"; "inner 0", "inner 1", "outer 0" and "outer 1" where a ring may have
        two grooves for a ball."""
        return [b"".join(name).decode().strip() for name in self._fixed["raceway"]]

    @property
    def two_grooves(self) -> bool:
        """True if a ring may have two grooves for a ball (gothic arch)."""
        return len(self.raceways) > 2

    @cached_property
    def contact_columns(self) -> list[str]:
        """Names of the contact columns; none in a summary record."""
        return [n for n, dims in self.variables.items() if dims == ("time", "raceway", "ball")]

    def blocks(self, start: int, stop: int | None) -> Iterator[tuple[int, int]]:
        """(start, stop) of blocks of a few MB."""
        self.need_samples()
        stop = len(self) if stop is None else min(stop, len(self))
        if start >= stop:
            raise RunError(f"{self.path} holds {len(self)} samples, none from number {start} on")
        size = max(1, BLOCK // self.record_bytes)
        for first in range(start, stop, size):
            yield first, min(first + size, stop)

    def timed(self, prefix: str) -> list[str]:
        """Names of the variables with time that begin with `prefix`."""
        return [n for n, dims in self.variables.items() if n.startswith(prefix) and "time" in dims]

    def need_one(self) -> None:
        """Raise `RunError` unless the record has one bearing or one has been chosen."""
        if self.bearing is None:
            raise RunError(
                f"{self.path} has {len(self.bearings)} bearings: choose one with --bearing NUMBER,"
                " in Python run.select(number)"
            )

    def need_samples(self) -> None:
        """Raise `RunError` if the header counts no sample."""
        if not len(self):
            raise RunError(f"{self.path} holds no sample: its run has just begun or was stopped")

    def need_contacts(self) -> None:
        """Raise `RunError` if the record has no contact columns."""
        if not self.contact_columns:
            raise RunError(
                f"{self.path} holds no contacts: record them with -var record all, in a deck of"
                " one's own with 'contacts usual' of fix bearing/record"
            )


def _without_record(folder):
    """Reason for a missing record in the folder, and the remedy."""
    if not folder.is_dir():
        return "is no folder: a run makes one, -var out NAME"
    if (folder / "contacts.dump").exists() or (folder / "balls.dump").exists():
        return (
            f"has text dumps and no {NAME}: raceway reads records; run the deck again with -var"
            " record all, or read its dumps with raceway of commit a7b5052"
        )
    return (
        f"has no {NAME}: its run recorded nothing, or it is gone; -var record all or fix"
        " bearing/record makes one"
    )


def _plain(value):
    return value.decode() if isinstance(value, bytes) else float(np.ravel(value)[0])


def _timed(file):
    return {name: v for name, v in file.variables.items() if "time" in v.dimensions}


def _place(variable):
    """Memory address of the first value of a variable."""
    return variable.data.__array_interface__["data"][0]


def _begin(file):
    """Offset of the first sample in the file."""
    first = min(map(_place, _timed(file).values()), default=0)
    return first - file._mm_buf.__array_interface__["data"][0]


def _row(file):
    """Type of one sample: all variables with time, at their offsets."""
    timed = _timed(file)
    begin = min(map(_place, timed.values()), default=0)
    return np.dtype(
        {
            "names": list(timed),
            "formats": [(v.data.dtype, v.data.shape[1:]) for v in timed.values()],
            "offsets": [_place(v) - begin for v in timed.values()],
            "itemsize": next((v.data.strides[0] for v in timed.values()), 1),
        }
    )
