# SPDX-License-Identifier: GPL-2.0-or-later
"""The record of a run, `record.nc`: what fix bearing/record wrote, read in pieces.

The file is netCDF classic: `xarray.open_dataset` opens it without this module. It may still grow:
every reading sees the samples that its header counts at that moment.
"""

from collections.abc import Iterator
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd

from raceway.arrays import Floats
from raceway.errors import RunError
from raceway.files import FilePath

NAME = "record.nc"
BLOCK = 8 << 20  # bytes read together
RAD_S = np.pi / 30  # of one revolution a minute
MOTION = "x y z vx vy vz omegax omegay omegaz".split()
NUMBERS = (("time",), ("time", "ring"), ("time", "bearing"))
RING = "x y z vx vy vz spin fx fy fz mx my mz".split()


class Record:
    """The record in `folder`, all its bearings or the one with the number `bearing` (from 1).

    Arrays are read when asked for, `start` to `stop` in samples. Raises `RunError` when the file is
    none of a run, is broken, or has no such bearing.
    """

    def __init__(self, folder: FilePath, bearing: int | None = None) -> None:
        self.path = Path(folder) / NAME
        try:
            with _opened(self.path) as file:
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
        except (TypeError, ValueError, KeyError, IndexError):  # what scipy makes of such bytes
            raise RunError(
                f"cannot read {self.path}: it is cut short or damaged, or no record at all"
            ) from None
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

    def __len__(self) -> int:
        """Samples that the header counts now."""
        with open(self.path, "rb", buffering=0) as file:
            return int.from_bytes(
                file.read(8)[4:], "big"
            )  # netCDF classic: after "CDF" and version

    def __bool__(self) -> bool:
        return True  # one without samples is a record, too: its run has just begun

    def part(self, dimension: str) -> slice:
        """What of a dimension belongs to the bearing: a slice."""
        if self.bearing is None or dimension not in ("ball", "cage_ball", "ring", "bearing"):
            return slice(None)
        owner = self._fixed["bearing" if dimension == "bearing" else f"{dimension}_bearing"]
        here = np.flatnonzero(owner == self.bearing)
        return slice(here[0], here[-1] + 1) if len(here) else slice(0, 0)

    def fixed(self, name: str) -> np.ndarray:
        """A variable without time, of the bearing."""
        dims = self.variables[name]
        return self._fixed[name][tuple(self.part(dim) for dim in dims)]

    def read(self, names: list[str], start: int = 0, stop: int | None = None) -> dict[str, Floats]:
        """{name: array} of variables with time, native byte order, of the bearing.

        The file is gone through once. What is one number a sample and bearing or ring is read
        together and kept until other samples are asked for: summaries ask for one after another.
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
        """Of one sample of a variable with time: what belongs to the bearing."""
        return np.empty(0, self._row)[name][(slice(None), *self._parts(name))].shape[1:]

    def _parts(self, name):
        return tuple(self.part(dim) for dim in self.variables[name][1:])

    def pick(self, name: str, key: tuple) -> Floats:
        """What an index (slices, integers and arrays, one a dimension) picks of a variable with
        time, of the bearing."""
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
        """A variable at samples here and there: nothing between them is read or mapped."""
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

    @cached_property
    def contact_columns(self) -> list[str]:
        """Names of the columns of contacts; none in a summary."""
        return [n for n, dims in self.variables.items() if dims == ("time", "raceway", "ball")]

    def blocks(self, start: int, stop: int | None) -> Iterator[tuple[int, int]]:
        """(start, stop) of pieces of a few MB."""
        self.need_samples()
        stop = len(self) if stop is None else min(stop, len(self))
        if start >= stop:
            raise RunError(f"{self.path} holds {len(self)} samples, none from number {start} on")
        size = max(1, BLOCK // self.record_bytes)
        for first in range(start, stop, size):
            yield first, min(first + size, stop)

    # ---- as tables -------------------------------------------------------------------------------
    def contacts(self, start: int, stop: int) -> pd.DataFrame:
        """A row per contact and sample: `DataFrame`; with `groove` where rings have two."""
        self.need_contacts()
        if "load" not in self.contact_columns:
            raise RunError(f"{self.path} has no column load: record it with the other contacts")
        data = self.read(self.contact_columns, start, stop)
        live = data["load"].transpose(0, 2, 1) > 0
        sample, ball, place = np.nonzero(live)
        raceway, groove = np.divmod(place, len(self.raceways) // 2)
        rings = self._rings_of_balls()
        table = pd.DataFrame(
            {
                "ball": self.fixed("ball")[ball].astype(int),
                "ring": rings[raceway, ball],
                "raceway": raceway,
                **({"groove": groove} if len(self.raceways) > 2 else {}),
                **{name: values.transpose(0, 2, 1)[live] for name, values in data.items()},
                "sample": sample + start,
            }
        )
        table.attrs.update(first=start, samples=len(live))
        return table

    def _rings_of_balls(self):
        """Atom number of the inner and the outer ring of every ball: (2, balls)."""
        number = np.zeros((2, max(self.bearings) + 1), dtype=int)
        number[self._fixed["ring_raceway"], self._fixed["ring_bearing"]] = self._fixed["ring"]
        return number[:, self.fixed("ball_bearing")]

    def atoms(self, start: int, stop: int) -> pd.DataFrame:
        """A row per ball, cage ball and ring, and sample: `DataFrame` as of a dump. A ring's spin
        is that about its own axis."""
        if "ball_x" not in self.variables:
            raise RunError(f"{self.path} is a summary: it has no motion of balls")
        parts = []
        for kind, prefix, dimension in ((1, "ball_", "ball"), (2, "cage_", "cage_ball")):
            if dimension in self.variables:
                data = self.read([prefix + name for name in MOTION], start, stop)
                parts.append((kind, self.fixed(dimension), list(data.values())))
        data = self.read([f"ring_{name}" for name in RING[:7]], start, stop)
        origin = [self.fixed(f"ring_origin_{axis}") for axis in "xyz"]
        values = list(data.values())
        place = [value + at for value, at in zip(values[:3], origin)]
        spin = [np.zeros_like(values[6]) for _ in range(3)]
        spin["xyz".index(self.attrs["axis"])] = values[6]
        parts.append(
            (3 + self.fixed("ring_raceway"), self.fixed("ring"), place + values[3:6] + spin)
        )
        samples = len(values[0])
        ids = np.concatenate([part[1] for part in parts]).astype(int)
        kinds = np.concatenate([np.broadcast_to(kind, len(tags)) for kind, tags, _ in parts])
        motion = {
            name: np.concatenate([part[2][k] for part in parts], axis=1).ravel()
            for k, name in enumerate(MOTION)
        }
        table = pd.DataFrame(
            {
                "id": np.tile(ids, samples),
                "type": np.tile(kinds, samples),
                **motion,
                "sample": np.repeat(np.arange(start, start + samples), len(ids)),
            }
        )
        table.attrs.update(first=start, samples=samples)
        return table

    def rings(self, start: int, stop: int) -> pd.DataFrame:
        """A row per sample: step, time and what the inner ring does, `DataFrame`."""
        self.need_one()
        inner = int(np.flatnonzero(self.fixed("ring_raceway") == 0)[0])
        names = [name for name in self.variables if name.startswith("ring_") and self._timed(name)]
        data = self.read(["step", "time", *names], start, stop)
        table = pd.DataFrame({"step": data["step"], "time": data["time"]})
        for name in names:
            table[name.removeprefix("ring_")] = data[name][:, inner]
        if "bearing_capacitance" in self.variables:
            table["capacitance"] = self.read(["bearing_capacitance"], start, stop)[
                "bearing_capacitance"
            ][:, 0]
        table["sample"] = np.arange(start, start + len(table))
        return table

    def totals(self, start: int, stop: int) -> pd.DataFrame:
        """A row per sample: sums and extremes over the bearing, `DataFrame`."""
        self.need_one()
        names = [n for n in self.variables if n.startswith("bearing_") and self._timed(n)]
        data = self.read(names, start, stop)
        table = pd.DataFrame(
            {name.removeprefix("bearing_"): values[:, 0] for name, values in data.items()}
        )
        table = table.astype({"contacts": int, "loaded_balls": int})
        table["pressure"] = table[["pressure_inner", "pressure_outer"]].max(axis=1)
        table.index = pd.RangeIndex(start, start + len(table), name="sample")
        return table

    def _timed(self, name):
        return "time" in self.variables[name]

    def need_one(self) -> None:
        """Raise `RunError` unless the record is of one bearing or one has been chosen."""
        if self.bearing is None:
            raise RunError(
                f"{self.path} has {len(self.bearings)} bearings: choose one with --bearing NUMBER,"
                " in Python run.select(number)"
            )

    def need_samples(self) -> None:
        """Raise `RunError` where the header counts no sample."""
        if not len(self):
            raise RunError(f"{self.path} holds no sample: its run has just begun or was stopped")

    def need_contacts(self) -> None:
        """Raise `RunError` where the record has no columns of contacts."""
        if not self.contact_columns:
            raise RunError(
                f"{self.path} holds no contacts: record them with -var record all, in a deck of"
                " one's own with 'contacts usual' of fix bearing/record"
            )

    # ---- what was run ----------------------------------------------------------------------------
    def settings(self) -> dict[str, Any]:
        """What the file says of the run, by the names of `run.yaml`; what no deck has told, such as
        the load, is what was measured: means over the record."""
        one = {} if self.bearing is None else self._bearing()
        told = {key: value for key, value in self.attrs.items() if key != "pair_commands"}
        columns = {
            "contact_columns": " ".join(["ball", "ring", "raceway", *self.contact_columns]),
            "ball_columns": " ".join(["id", "type", *MOTION]),
        }
        found = {"bearing": "unnamed", "integrator": "unknown", **one, **told, **columns}
        if self.bearing is not None:
            found = {**self._measured(found), **found}
        return found

    def _bearing(self):
        value = {
            name: float(self.fixed(name)[0])
            for name, dims in self.variables.items()
            if dims == ("bearing",) and name != "bearing"
        }
        wet = np.isfinite(value["viscosity"])
        rings = dict(zip(self.fixed("ring_raceway").tolist(), self.fixed("ring").tolist()))
        found = {
            "lubricant": "oil" if wet else "dry",
            "balls": int(value["balls"]),
            "ball_diameter_m": value["ball_diameter"],
            "inner_radius_m": value["inner_radius"],
            # that of the bearing without clearance, which stands beside it
            "outer_radius_m": value["outer_radius"] - value["clearance"] / 2,
            "inner_groove_m": value["inner_groove"],
            "outer_groove_m": value["outer_groove"],
            "clearance_m": value["clearance"],
            "ball_young_Pa": value["ball_young"],
            "ball_poisson": value["ball_poisson"],
            "inner_ring": rings.get(0),
            "outer_ring": rings.get(1),
        }
        if value["cage_balls"]:
            found["cage_ball_diameter_m"] = value["cage_ball_diameter"]
        if wet:
            found["viscosity_Pa_s"] = value["viscosity"]
            found["pressure_viscosity_per_Pa"] = value["pressure_viscosity"]
            found["permittivity"] = value["permittivity"]
            found["roughness_m"] = float(np.hypot(value["ring_roughness"], value["ball_roughness"]))
        return found

    def _measured(self, told):
        if not len(self):
            return {}
        spin = self.read(["ring_spin"])["ring_spin"].mean(axis=0)
        side = self.fixed("ring_raceway")
        force = self.read(["ring_fx", "ring_fy"])
        # the load pushes the inner ring to where its balls push it back from
        x, y = (-float(force[name][:, side == 0].mean()) for name in ("ring_fx", "ring_fy"))
        cage = float(self.read(["bearing_cage_speed"])["bearing_cage_speed"].mean())
        sample_s = told["sample_s"]
        ball_pass = 2 * np.pi / (told["balls"] * abs(cage)) if cage else np.nan
        return {
            "load_N": float(np.hypot(x, y)),
            "load_azimuth_rad": float(np.arctan2(y, x)),
            "rpm": abs(float(spin[side == 0].sum() - spin[side == 1].sum())) / RAD_S,
            "samples_per_pass": ball_pass / sample_s,
            "passes": (len(self) - 1) * sample_s / ball_pass,
        }


def there(folder: FilePath) -> bool:
    """Whether `folder` has a record."""
    return (Path(folder) / NAME).exists()


def _opened(path):
    from scipy.io import netcdf_file  # takes a while to load; folders of text need none of it

    return netcdf_file(path, mmap=True)


def _plain(value):
    return value.decode() if isinstance(value, bytes) else float(np.ravel(value)[0])


def _timed(file):
    return {name: v for name, v in file.variables.items() if "time" in v.dimensions}


def _place(variable):
    """Where in memory the first value of a variable is."""
    return variable.data.__array_interface__["data"][0]


def _begin(file):
    """Where in the file the first sample is."""
    first = min(map(_place, _timed(file).values()), default=0)
    return first - file._mm_buf.__array_interface__["data"][0]


def _row(file):
    """The type of one sample: all variables with time, where they are in it."""
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
