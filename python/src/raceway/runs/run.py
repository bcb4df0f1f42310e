# SPDX-License-Identifier: GPL-2.0-or-later
"""A run as labelled arrays: `raceway.open` gives one object with a dataset for each thing a bearing
is made of."""

from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from raceway.errors import RunError
from raceway.files import FilePath
from raceway.runs.columns import ATOM, BEARING, CONTACT, RING
from raceway.runs.flaws import by_part
from raceway.runs.named import NamedDataset
from raceway.runs.recorded import Recorded
from raceway.runs.summary import ring_displacement, summary
from raceway.runs.tables import BALL, CAGE, RunTables
from raceway.theory.bearing import INNER, OUTER

if TYPE_CHECKING:  # optional
    from MDAnalysis import Universe

SIDES = {INNER: "inner", OUTER: "outer"}


class Run:
    """The run in `folder`. Every dataset is read when first asked for; all values are SI units and
    say so in `attrs`.

    - `contacts`: (time, raceway, ball) what the dump has of each contact; `azimuth` and
      `from_load_line` (rad, the latter counted from the centre of the loaded zone) are coordinates
    - `balls`, `cage`: (time, ball) position (m), velocity (m/s), spin (rad/s) of balls and cage
      balls; `azimuth` and `from_load_line` about the outer ring
    - `rings`: (time) displacement, velocity and spin of the inner ring, force and moment of the
      balls on it
    - `bearing`: (time) sums and extremes over the contacts: capacitance, balls loaded, largest
      loads, losses

    Every variable is an attribute, too: `run.contacts.mu`. Those that Python takes for something
    else have a second name: `Q` for `load`, `lambda_ratio` for `lambda`, `radial_displacement` for
    `shift`.

    `time` is in s from the start of the measured window, the same values in all of them; `passes`
    beside it counts ball passes. `ball` is the atom number, `raceway` "inner" or "outer"; where
    rings have two grooves for a ball, "inner 0", "inner 1", "outer 0" or "outer 1". Where a ball
    does not touch a raceway, what vanishes with the contact (load, pressure, capacitance ...) is 0
    and what it does not have (film, angle ...) NaN.

    `samples`, a slice without step, keeps to some samples: `blocks` and `bearing` need no more
    memory for a large run, the other datasets do.

    Raises `RunError` when the folder has no `run.yaml` or a broken one, or a record that is of
    another run; the datasets do when their file is broken, and warn when it ends inside a frame. A
    run that is still going can be read as far as it is.
    """

    def __init__(
        self, folder: FilePath, samples: slice = slice(None), bearing: int | None = None
    ) -> None:
        self.tables = RunTables(folder, samples, bearing)

    @property
    def bearing_numbers(self) -> list[int]:
        """Numbers of the bearings in the folder."""
        return self.tables.record.bearings if self.tables.record else [1]

    def select(self, number: int) -> "Run":
        """The same run, one bearing of it. Raises `RunError` when there is none of that number."""
        if number not in self.bearing_numbers:
            raise RunError(
                f"{self.tables.folder} has the bearings {self.bearing_numbers[0]} to"
                f" {self.bearing_numbers[-1]}, not {number}"
            )
        tables = self.tables
        return Run(tables.folder, slice(tables.first, tables.stop), number)

    def __repr__(self):
        if self.tables.record and self.tables.record.bearing is None:
            return f"<raceway run {self.tables.folder}: {len(self.bearing_numbers)} bearings>"
        if self.tables.record and not len(self.tables.record):
            return f"<raceway run {self.tables.folder}: no sample yet>"
        settings = self.settings
        places = {side: f"{side} raceway" for side in ("inner", "outer")}
        flaws = "".join(f", {places.get(at, at)}: {words}" for at, words in self.flaws.items())
        state = "" if self.tables.finished else ", not finished"
        return (
            f"<raceway run {self.tables.folder}: {settings['bearing']}, {settings['lubricant']},"
            f" {settings['load_N']:g} N, {settings['rpm']:g} rpm, clearance"
            f" {settings['clearance_m']:g} m, {settings['host']}{flaws}{state}>"
        )

    @property
    def settings(self) -> dict[str, Any]:
        """What was run, `run.yaml` as a dict: names as text, the rest as numbers in the units their
        names end with."""
        return self.tables.settings

    @property
    def flaws(self) -> dict[str, str]:
        """Words of fix bearing/profile by raceway, "inner" and "outer", and by ball, "ball 1" for
        that of atom number 1; nothing of one without flaws. Raises `RunError` unless one bearing
        has been chosen."""
        if self.tables.record:
            self.tables.record.need_one()
        return by_part(self.settings)

    @cached_property
    def contacts(self) -> xr.Dataset:
        """Dataset (time, raceway, ball). Of a record, values are read when they are used."""
        if self.tables.record:
            return Recorded(self.tables).contacts
        return self._contacts(self.tables.contacts)

    @cached_property
    def balls(self) -> xr.Dataset:
        """Dataset (time, ball)."""
        if self.tables.record:
            return Recorded(self.tables).balls
        return self._atoms(self.tables.balls, BALL)

    @cached_property
    def cage(self) -> xr.Dataset:
        """Dataset (time, ball) of the cage balls; their `ball` is their own atom number."""
        if self.tables.record:
            return Recorded(self.tables).cage
        return self._atoms(self.tables.balls, CAGE)

    @cached_property
    def rings(self) -> xr.Dataset:
        """Dataset (time). The first row a run writes is its sample 1."""
        table = self.tables.rings
        names = [name for name in table if name not in ("time", "sample")]
        data = {name: ("time", table[name].to_numpy()) for name in names}
        data["shift"] = ("time", ring_displacement(self.tables))
        return self._label(data, table["sample"].to_numpy(), RING)

    @cached_property
    def bearing(self) -> xr.Dataset:
        """Dataset (time), worked out in blocks."""
        table = self.tables.totals
        return self._label(
            {name: ("time", table[name].to_numpy()) for name in table},
            table.index.to_numpy(),
            BEARING,
        )

    def blocks(self, name: str) -> Iterator[xr.Dataset]:
        """Yield the dataset `name`, "contacts", "balls" or "cage", in pieces of some thousand
        samples.

        Raises `ValueError` for another name.
        """
        makers = {
            "contacts": self._contacts,
            "balls": lambda table: self._atoms(table, BALL),
            "cage": lambda table: self._atoms(table, CAGE),
        }
        if name not in makers:
            raise ValueError(f"no dataset '{name}' comes in blocks: {', '.join(makers)} do")
        if record := self.tables.record:
            for part in record.blocks(self.tables.first, self.tables.stop):
                yield getattr(Recorded(self.tables.window(slice(*part))), name)
            return
        for table in self.tables.blocks("contacts" if name == "contacts" else "balls"):
            yield makers[name](table)

    def summary(self) -> dict[str, str | float | None]:
        """The figures that `raceway summary` prints, by name: `raceway.summary.summary`."""
        return summary(self.tables)

    def universe(self) -> "Universe":
        """The run for MDAnalysis: `raceway.runs.universe`."""
        from raceway.runs.universe import universe  # MDAnalysis takes a second to load

        return universe(self.tables)

    def _label(self, data, samples, columns):
        coords = {"time": self.tables.time(samples)}
        data = NamedDataset(data, coords=coords, attrs=self._attrs())
        data["time"].attrs.update(
            units="s", long_name="time since the start of the measured window"
        )
        data.coords["passes"] = (
            "time",
            self.tables.passes(samples),
            {"units": "1", "long_name": "ball passes since the start of the measured window"},
        )
        for name in data.data_vars:
            if name in columns:
                data[name].attrs.update(
                    units=columns[name].unit or "1", long_name=columns[name].meaning
                )
        return data

    def _attrs(self):
        keys = ("bearing", "lubricant", "host", "integrator", "load_N", "rpm", "clearance_m")
        return {key: self.settings[key] for key in keys}

    def _azimuths(self, data, azimuth):
        dims = tuple(data.sizes)[: azimuth.ndim]
        for name, values, meaning in (
            ("azimuth", azimuth, CONTACT["azimuth"].meaning),
            (
                "from_load_line",
                self.tables.from_load_line(azimuth),
                "azimuth from the centre of the loaded zone",
            ),
        ):
            data.coords[name] = (dims, values, {"units": "rad", "long_name": meaning})
        return data

    def _contacts(self, table):
        first, samples = table.attrs["first"], table.attrs["samples"]
        self.tables.need_balls()
        # balls have the first atom numbers; a table may hold others (many bearings) or not all
        # (clearance)
        balls = np.union1d(table["ball"], np.arange(1, self.settings["balls"] + 1))
        raceways, raceway = list(SIDES.values()), table["raceway"].to_numpy()
        if "groove" in table:
            raceways = [f"{side} {groove}" for side in raceways for groove in (0, 1)]
            raceway = 2 * raceway + table["groove"].to_numpy()
        shape = (samples, len(raceways), len(balls))
        place = (
            table["sample"].to_numpy() - first,
            raceway,
            np.searchsorted(balls, table["ball"]),
        )
        flat = np.ravel_multi_index(place, shape, mode="raise")
        if len(np.unique(flat)) != len(flat):
            raise RunError(
                f"{self.tables.source['contacts']}: a ball touches one raceway twice in a sample"
            )
        data, azimuth = {}, None
        for name in table:
            if name in ("ball", "raceway", "groove", "sample"):
                continue
            values = np.full(np.prod(shape), CONTACT[name].absent if name in CONTACT else np.nan)
            values[flat] = table[name]
            values = values.reshape(shape)
            if name == "azimuth":
                azimuth = values
            else:
                data[name] = (("time", "raceway", "ball"), values)
        data = self._label(data, np.arange(first, first + samples), CONTACT)
        data = data.assign_coords(raceway=raceways, ball=balls)
        return self._azimuths(data, azimuth)

    def _atoms(self, table, kind):
        first, samples = table.attrs["first"], table.attrs["samples"]
        rows = table[table["type"] == kind].sort_values(["sample", "id"], kind="stable")
        ids = np.unique(rows["id"])
        axis = table[table["id"] == self.settings["outer_ring"]]
        same = len(rows) == samples * len(ids) and len(axis) == samples
        same = same and axis["sample"].is_unique
        # each atom once in every sample: of two that changed places over samples the sum is right
        if not same or (rows["id"].to_numpy().reshape(samples, -1) != ids).any():
            raise RunError(f"{self.tables.source['balls']}: not every sample has the same atoms")
        names = [name for name in table if name not in ("id", "type", "sample")]
        data = {
            name: (("time", "ball"), rows[name].to_numpy().reshape(samples, len(ids)))
            for name in names
        }
        data = self._label(data, np.arange(first, first + samples), ATOM).assign_coords(ball=ids)
        x, y = (
            data[name].to_numpy() - axis.sort_values("sample")[name].to_numpy()[:, None]
            for name in "xy"
        )
        return self._azimuths(data, np.arctan2(y, x))
