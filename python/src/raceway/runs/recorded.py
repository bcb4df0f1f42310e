# SPDX-License-Identifier: GPL-2.0-or-later
"""The datasets of a run, whose values are read from its record on first use."""

from collections.abc import Mapping
from functools import cached_property

import numpy as np
import pandas as pd
import xarray as xr
from numpy.typing import ArrayLike
from xarray.backends import BackendArray
from xarray.core import indexing

from raceway.errors import RunError
from raceway.runs.columns import BEARING, CAGE, CONTACT, RING, Column
from raceway.runs.named import NamedDataset
from raceway.runs.record import CAGE_RING
from raceway.runs.record_tables import MOTION, rings
from raceway.runs.summary import ring_displacement
from raceway.runs.tables import RunTables

ABOUT = ("bearing", "lubricant", "host", "integrator", "load_N", "rpm", "clearance_m")


class _InFile(BackendArray):
    """A lazily read variable with a time dimension; `of` is applied to its values."""

    def __init__(self, record, name, samples, of=np.asarray):
        self.record, self.name, self.of = record, name, of
        self.shape, self.dtype = (samples, *record.shape(name)), np.dtype(float)

    def __getitem__(self, key):
        return indexing.explicit_indexing_adapter(
            key,
            self.shape,
            indexing.IndexingSupport.OUTER,
            self._pick,
        )

    def _pick(self, at):
        time, *others = at
        if isinstance(time, slice) and time.step in (None, 1):
            time = slice(*time.indices(self.shape[0]))  # exclude samples added after opening
        return self.of(self.record.pick(self.name, (time, *others)))


class Recorded:
    """The datasets that `Run` provides for the run `tables`."""

    def __init__(self, tables: RunTables) -> None:
        self.tables, self.record = tables, tables.record
        # The file may be growing, so all datasets use the samples found by the first read.
        self._window = slice(tables.first, tables.last if len(self.record) else 0)

    @cached_property
    def _file(self):
        """All variables of contacts, balls, cage and rings, for the window and the bearing."""
        record = self.record
        found = {
            name: self._in_file(name)[self._window]
            for name, dims in record.variables.items()
            if dims[:1] == ("time",) and dims != ("time", "bearing")
        }
        coords = {
            name: record.fixed(name) for name in ("ball", "cage_ball") if name in record.about
        }
        data = NamedDataset(found, coords={**coords, "raceway": record.raceways})
        for axis in "xyz":
            data[f"ring_origin_{axis}"] = ("ring", record.fixed(f"ring_origin_{axis}"))
        return data.set_coords("time")

    def _in_file(self, name, **made):
        array = _InFile(self.record, name, self._window.stop, **made)
        values = indexing.LazilyIndexedArray(array)
        return xr.Variable(self.record.variables[name], values, self.record.about[name])

    @property
    def _of_one(self):
        """True for a single bearing; ball passes and the load zone are defined only then."""
        return self.record.bearing is not None

    def _labelled(self, data):
        attrs = {key: value for key, value in self.tables.settings.items() if key in ABOUT}
        samples = self.tables.first + np.arange(data.sizes["time"])
        if self._of_one:
            about = {
                "units": "1",
                "long_name": "ball passes since the start of the measured window",
            }
            data = data.assign_coords(passes=("time", self.tables.passes(samples), about))
        data["time"].attrs["long_name"] = "time since the start of the measured window"
        data.attrs = attrs
        return data

    def _azimuths(self, data, azimuth, from_load_line):
        """Return `data` with these two `Variable` objects as coordinates."""
        found = [("azimuth", azimuth, CONTACT["azimuth"].meaning)]
        if self._of_one:
            found.append(
                ("from_load_line", from_load_line, "azimuth from the centre of the load zone")
            )
        for name, values, meaning in found:
            values.attrs = {"units": "rad", "long_name": meaning}
            data.coords[name] = values
        return data

    @property
    def contacts(self) -> xr.Dataset:
        """Dataset (time, raceway, ball)."""
        self.record.need_contacts()
        names = [name for name in self.record.contact_columns if name != "azimuth"]
        data = self._labelled(self._file[names])
        if "azimuth" in self.record.contact_columns:
            azimuth = self._in_file("azimuth")[self._window]
            line = self._in_file("azimuth", of=self.tables.from_load_line)[self._window]
            data = self._azimuths(data, azimuth, line)
        return data

    @property
    def rings(self) -> xr.Dataset:
        """Dataset (time) of the inner ring."""
        table = self.tables.rings
        data = {name: table[name] for name in table if name not in ("time", "sample")}
        return self._of_table({**data, "shift": ring_displacement(self.tables)}, RING)

    @property
    def bearing(self) -> xr.Dataset:
        """Dataset (time) of sums and extremes over the contacts."""
        return self._of_table(self.tables.totals, BEARING)

    def _of_table(
        self, table: Mapping[str, ArrayLike] | pd.DataFrame, columns: Mapping[str, Column]
    ) -> xr.Dataset:
        data = NamedDataset({name: ("time", np.asarray(table[name])) for name in table})
        first, count = self.tables.first, data.sizes["time"]
        time = self.record.read(["time"], first, first + count)["time"]
        for name in data.data_vars:
            if name in columns:
                about = {"units": columns[name].unit or "1", "long_name": columns[name].meaning}
                data[name].attrs.update(about)
        return self._labelled(data.assign_coords(time=("time", time, self.record.about["time"])))

    @property
    def balls(self) -> xr.Dataset:
        """Dataset (time, ball)."""
        return self._atoms("ball_", "ball")

    @property
    def cage(self) -> xr.Dataset:
        """Dataset (time, ball) of the cage balls of a chain, or dataset (time) of a cage ring."""
        ring = CAGE_RING in self.record.fixed("ring_raceway")
        if ring and (self._of_one or "cage_x" not in self._file):
            table = rings(self.record, self.tables.first, self.tables.last, CAGE_RING)
            return self._of_table({name: table[name] for name in CAGE}, CAGE)
        return self._atoms("cage_", "cage_ball")

    def _atoms(self, prefix, dimension):
        if f"{prefix}x" not in self._file:
            raise RunError(f"{self.record.path} has no {dimension.replace('_', ' ')}s")
        places = [f"ring_{kind}{axis}" for kind in ("", "origin_") for axis in "xy"]
        for name in [*(prefix + one for one in MOTION), *places]:
            self.record.variables[name]  # raises an error if it is missing
        data = self._file[[prefix + name for name in MOTION]]
        data = data.rename({prefix + name: name for name in MOTION})
        if dimension != "ball":
            data = data.rename({dimension: "ball"})
        data = self._labelled(data)
        # index of the outer ring that belongs to each ball
        outer = np.flatnonzero(self.record.fixed("ring_raceway") == 1)
        owners = self.record.fixed("ring_bearing")[outer]
        own = outer[np.searchsorted(owners, self.record.fixed(f"{dimension}_bearing"))]
        rings = self._file[[f"ring_{at}{name}" for name in "xy" for at in ("", "origin_")]].load()
        rings = rings.isel(ring=xr.DataArray(own, dims="ball"))
        x, y = (
            data[name] - (rings[f"ring_{name}"] + rings[f"ring_origin_{name}"]) for name in "xy"
        )
        azimuth = np.arctan2(y, x).variable
        line = (
            azimuth.copy(data=self.tables.from_load_line(azimuth.values)) if self._of_one else None
        )
        return self._azimuths(data, azimuth, line)
