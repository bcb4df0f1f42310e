# SPDX-License-Identifier: GPL-2.0-or-later
"""A run as labelled arrays: `raceway.open` returns a `Run`, which has a dataset for each component
of the bearing."""

import math
from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING, Any

import xarray as xr

from raceway.arrays import Floats
from raceway.errors import RunError
from raceway.files import FilePath
from raceway.runs import ring_signal
from raceway.runs.flaws import by_part
from raceway.runs.measured import title
from raceway.runs.recorded import Recorded
from raceway.runs.source import Signal
from raceway.runs.summary import summary
from raceway.runs.tables import RunTables
from raceway.runs.turning import Motion
from raceway.runs.warming import transient
from raceway.theory.bearing import Bearing
from raceway.units import prefixed

if TYPE_CHECKING:  # optional
    from MDAnalysis import Universe

IN_BLOCKS = ("contacts", "balls", "cage")


class Run:
    """The run in `folder`.

    Each dataset is read on first use. All values are in SI units, which are stated in `attrs`.

    - `contacts`: (time, raceway, ball) every recorded column of each contact; `azimuth` and
      `from_load_line` (rad, measured from the centre of the load zone) are coordinates
    - `balls`, `cage`: (time, ball) position (m), velocity (m/s) and spin (rad/s) of balls and cage
      balls; `azimuth` and `from_load_line` are angles about the outer ring
    - `rings`: (time) displacement, velocity and spin of the inner ring, and the force and moment
      that the balls exert on it
    - `bearing`: (time) sums and extremes over the contacts: capacitance, number of loaded balls,
      largest loads, losses
    - `heat`: (thermal_time) temperatures, losses and clearance at each jump, for a run with fix
      bearing/heat

    Every variable is also an attribute: `run.contacts.mu`. Names that cannot be attributes have a
    second name: `Q` for `load`, `lambda_ratio` for `lambda`, `radial_displacement` for `shift`.

    `time` is in s from the start of the measured window, with the same values in all datasets;
    `passes` is the same time in ball passes. `ball` is the atom number, and `raceway` is "inner" or
    "outer", or "inner 0", "inner 1", "outer 0" or "outer 1" for rings with two grooves. If there is
    no contact, quantities that vanish with the contact (load, pressure, capacitance ...) are 0 and
    undefined quantities (film, angle ...) are NaN.

    `samples`, a slice without a step, selects a range of samples. The memory needed for `blocks`
    and `bearing` does not grow with the length of the run; the memory for the other datasets does.

    Raises `RunError` if the record is missing or broken, or if `run.yaml` belongs to another run.
    An unfinished run can be read up to its latest sample.
    """

    def __init__(
        self, folder: FilePath, samples: slice = slice(None), bearing: int | None = None
    ) -> None:
        self.tables = RunTables(folder, samples, bearing)

    @property
    def bearing_numbers(self) -> list[int]:
        """Numbers of the bearings in the folder."""
        return self.tables.record.bearings

    def select(self, number: int) -> "Run":
        """Return the bearing `number` of the same run; raise `RunError` for an unknown number."""
        if number not in self.bearing_numbers:
            raise RunError(
                f"{self.tables.folder} has bearings {self.bearing_numbers[0]} to"
                f" {self.bearing_numbers[-1]}, but no bearing {number}"
            )
        tables = self.tables
        return Run(tables.folder, slice(tables.first, tables.stop), number)

    def __repr__(self):
        if self.tables.record.bearing is None:
            return f"<raceway run {self.tables.folder}: {len(self.bearing_numbers)} bearings>"
        if not len(self.tables.record):
            return f"<raceway run {self.tables.folder}: no sample yet>"
        settings = self.settings
        places = {side: f"{side} raceway" for side in ("inner", "outer")}
        flaws = "".join(f", {places.get(at, at)}: {words}" for at, words in self.flaws.items())
        state = "" if self.tables.finished else ", not finished"
        state += "" if self.tables.record.checked else ", without checksums"
        return (
            f"<raceway run {self.tables.folder}: {settings['bearing']}, {settings['lubricant']},"
            f" {prefixed(settings['load_N'], 'N', 4)}, {settings['rpm']:g} rpm, clearance"
            f" {prefixed(settings['clearance_m'], 'm', 4)}, {settings['host']}{flaws}{state}>"
        )

    @property
    def settings(self) -> dict[str, Any]:
        """Settings of the run, with the keys of `run.yaml`: names are text, and all other values
        are numbers in the unit at the end of the key."""
        return self.tables.settings

    @property
    def flaws(self) -> dict[str, str]:
        """Arguments of fix bearing/profile for each flawed part: "inner", "outer", or, for the ball
        with atom number 1, "ball 1". Raises `RunError` unless one bearing has been selected."""
        self.tables.record.need_one()
        return by_part(self.settings)

    @cached_property
    def contacts(self) -> xr.Dataset:
        """Dataset (time, raceway, ball). Values are read on first use."""
        return Recorded(self.tables).contacts

    @cached_property
    def balls(self) -> xr.Dataset:
        """Dataset (time, ball). Values are read on first use."""
        return Recorded(self.tables).balls

    @cached_property
    def cage(self) -> xr.Dataset:
        """Dataset (time) of a cage ring. For a cage chain: dataset (time, ball) of its balls, where
        `ball` is the atom number of a cage ball."""
        return Recorded(self.tables).cage

    @cached_property
    def rings(self) -> xr.Dataset:
        """Dataset (time) of the inner ring."""
        return Recorded(self.tables).rings

    @cached_property
    def bearing(self) -> xr.Dataset:
        """Dataset (time) of sums and extremes over the contacts."""
        return Recorded(self.tables).bearing

    @cached_property
    def heat(self) -> xr.Dataset:
        """Dataset (thermal_time) of the temperatures that fix bearing/heat wrote at each jump.
        Raises `RunError` if its table is missing."""
        return transient(self.tables.folder)

    def blocks(self, name: str) -> Iterator[xr.Dataset]:
        """Yield the dataset `name`, which is "contacts", "balls" or "cage", in blocks of a few
        thousand samples.

        Raise `ValueError` for any other name.
        """
        if name not in IN_BLOCKS:
            raise ValueError(f"no dataset '{name}' in blocks; there are {', '.join(IN_BLOCKS)}")
        for part in self.tables.record.blocks(self.tables.first, self.tables.stop):
            yield getattr(Recorded(self.tables.window(slice(*part))), name)

    def summary(self) -> dict[str, str | float | None]:
        """Return the results that `raceway summary` prints, keyed by name."""
        return summary(self.tables)

    @property
    def geometry(self) -> Bearing:
        """The bearing that was simulated."""
        return self.tables.geometry

    @property
    def motion(self) -> Motion:
        """Mean speeds of rings, cage and balls in rad/s."""
        return self.tables.motion

    @property
    def nominal_angle(self) -> float:
        """Contact angle of the unloaded bearing in rad, or 0 if its file does not state one."""
        return math.radians(self.settings.get("contact_angle_deg", 0))

    @property
    def where(self) -> str:
        """Path of the record."""
        return str(self.tables.record.path)

    @property
    def title(self) -> str:
        """Bearing, load, speed, lubricant and clearance in one line."""
        return title(self.tables)

    def signal(self, name: str = "shift", ring: str = "inner") -> Signal:
        """Return the samples of a column of a ring with their spacing, unit and meaning; see
        `ring_signal.of_run`."""
        return ring_signal.of_run(self, name, ring)

    def shaft_angle(self, samples: int | None = None) -> Floats:
        """Return the angle (N,) in rad of the inner ring relative to the outer ring, at all samples
        or at the first `samples`."""
        return self.tables.turning.shaft(self.tables.first, self.tables.last)[:samples]

    def shaft_speed(self, samples: int | None = None) -> Floats:
        """Return the speed (N,) in rad/s of the inner ring relative to the outer ring, at all
        samples or at the first `samples`."""
        return self.tables.turning.shaft_speed(self.tables.first, self.tables.last)[:samples]

    def universe(self) -> "Universe":
        """Return the run as an MDAnalysis `Universe`; see `raceway.runs.universe`."""
        from raceway.runs.universe import universe  # importing MDAnalysis takes a second

        return universe(self.tables)
