# SPDX-License-Identifier: GPL-2.0-or-later
"""A run folder: settings and samples as tables."""

from collections.abc import Iterator
from functools import cached_property
from pathlib import Path

import numpy as np
import pandas as pd
from numpy.typing import ArrayLike

from raceway.arrays import Floats, Numbers
from raceway.errors import RunError
from raceway.files import FilePath
from raceway.runs import record_tables
from raceway.runs.pairs import pairs
from raceway.runs.record import Record
from raceway.runs.settings import AT_THE_END, NO_LUBRICANT, settings
from raceway.runs.turning import Motion, Turning
from raceway.theory.bearing import Bearing

READERS = {"contacts": record_tables.contacts, "balls": record_tables.atoms}


class RunTables:
    """The `settings` of a run and its samples as tables, read on first use.

    Tables are `DataFrame`s in SI units whose column `sample` counts the samples of the measured
    window from 0. For a run larger than memory, `samples`, a slice without step, selects some
    samples, or `blocks` reads all of them in turn. A running or stopped run can be read up to its
    latest sample; it is not `finished`. `bearing` selects one of several bearings by its number,
    from 1.

    Raises `RunError` if the record is missing or broken, or if `run.yaml` belongs to another run.
    """

    def __init__(
        self, folder: FilePath, samples: slice = slice(None), bearing: int | None = None
    ) -> None:
        self.folder = Path(folder)
        self.record = Record(folder, bearing)
        self.settings = settings(self.record)
        self.first, self.stop = _window(samples)
        self._turning: list[Turning] = []

    def window(self, samples: slice) -> "RunTables":
        """The same run with other `samples`. Its settings are not read or measured again."""
        part = RunTables.__new__(RunTables)
        part.folder, part.record, part.settings = self.folder, self.record, self.settings
        part.first, part.stop = _window(samples)
        part._turning = self._turning
        return part

    @property
    def turning(self) -> Turning:
        """Angles of rings, cage and balls. Raises `RunError` unless one bearing has been chosen."""
        self.record.need_one()
        if not self._turning:
            self._turning.append(Turning(self.record))
        return self._turning[0]

    @cached_property
    def motion(self) -> Motion:
        """Mean speeds over the samples. Raises `RunError` for fewer than two."""
        return self.turning.motion(self.first, self.last)

    @property
    def lubricated(self) -> bool:
        """True if the run had a lubricant."""
        return self.settings["lubricant"] not in NO_LUBRICANT

    @property
    def finished(self) -> bool:
        """True if the run has finished; before that, `settings` has no `step_s`, `simulated_s` and
        `wall_s`."""
        return all(key in self.settings for key in AT_THE_END)

    def need_finished(self) -> None:
        """Raise `RunError` for an unfinished run."""
        self.record.need_one()
        path = self.folder / "run.yaml"
        if not path.exists():
            raise RunError(f"{path}, which states whether the run has finished, is missing")
        if missing := [key for key in AT_THE_END if key not in self.settings]:
            raise RunError(f"run has not finished: {path} has no {' and no '.join(missing)}")

    @property
    def geometry(self) -> Bearing:
        """The `Bearing` that was simulated."""
        self.record.need_one()
        names = {
            "balls": "balls",
            "ball_diameter_m": "ball_diameter",
            "inner_radius_m": "inner_radius",
            "outer_radius_m": "outer_radius",
            "inner_groove_m": "inner_groove",
            "outer_groove_m": "outer_groove",
            "ball_young_Pa": "young",
            "ball_poisson": "poisson",
        }
        try:
            return Bearing.from_mapping({name: self.settings[key] for key, name in names.items()})
        except ValueError as error:
            raise RunError(f"{self.record.path}: {error}") from None

    @property
    def cage_ball_radius(self) -> float:
        """Radius of the cage balls, m; for a run without cage, their radius without pocket gap."""
        if "cage_ball_diameter_m" in self.settings:
            return self.settings["cage_ball_diameter_m"] / 2
        bearing = self.geometry
        return 2 * bearing.pitch_radius * np.sin(np.pi / (2 * bearing.balls)) - bearing.ball_radius

    @cached_property
    def contacts(self) -> pd.DataFrame:
        """One row for each sample and active contact of a ball with a raceway."""
        return record_tables.contacts(self.record, self.first, self.last)

    @cached_property
    def balls(self) -> pd.DataFrame:
        """One row for each atom and sample."""
        return record_tables.atoms(self.record, self.first, self.last)

    @cached_property
    def rings(self) -> pd.DataFrame:
        """One row for each sample: position and motion of the inner ring."""
        return record_tables.rings(self.record, self.first, self.last)

    @cached_property
    def totals(self) -> pd.DataFrame:
        """One row for each sample: sums and extremes over the bearing."""
        return record_tables.totals(self.record, self.first, self.last)

    @cached_property
    def pairs(self) -> pd.DataFrame:
        """`pairs.pairs` of the contacts: one row for each sample and ball loaded on both
        raceways."""
        return pairs(self.contacts)

    @property
    def bearing_capacitance(self) -> Floats:
        """Capacitance of the bearing in F, one value per sample (eq 12)."""
        return self.record.known(self.totals)["capacitance"].to_numpy()

    @cached_property
    def last(self) -> int:
        """End of the available samples, at most `stop`; in a growing record, the same end for all
        tables. Raises `RunError` without samples."""
        *_, (_, last) = self.record.blocks(self.first, self.stop)
        return last

    def blocks(self, name: str) -> Iterator[pd.DataFrame]:
        """Yield the table `name`, "contacts" or "balls", in blocks of whole samples and a few MB.

        The `attrs` of a block have `first` and the number of `samples`. Raises `RunError` without
        samples.
        """
        if name in self.__dict__:  # read already
            yield self.__dict__[name]
            return
        for part in self.record.blocks(self.first, self.last):
            yield READERS[name](self.record, *part)

    def by_raceway(self, contacts: pd.DataFrame) -> dict[str, np.ndarray]:
        """{"inner": mask of rows of `contacts`, "outer": ...}; with two grooves for a ball
        "inner_0", "inner_1", "outer_0", "outer_1"."""
        place = contacts["raceway"].to_numpy(int)
        if self.record.two_grooves:
            place = 2 * place + contacts["groove"].to_numpy(int)
        return {name.replace(" ", "_"): place == k for k, name in enumerate(self.record.raceways)}

    def passes(self, sample: ArrayLike) -> Numbers:
        """Number of ball passes from the start of the measured window to a sample (number or
        array), from the angle of the cage."""
        return self.turning.passes(sample)

    def from_load_line(self, azimuth: Numbers) -> Numbers:
        """Azimuths in rad (number or array) counted from the centre of the load zone, within
        -pi..pi."""
        return np.mod(azimuth - self.settings["load_azimuth_rad"] + np.pi, 2 * np.pi) - np.pi

    def angles(self, contacts: pd.DataFrame) -> Floats:
        """The azimuths of rows of contacts, in rad from the centre of the load zone. Raises
        `RunError` if the run has not recorded them."""
        if "azimuth" not in contacts:
            raise RunError(f"{self.record.path} has no column azimuth: record it as well")
        return self.from_load_line(contacts["azimuth"].to_numpy())


def _window(samples):
    """(first, stop) of a slice of samples."""
    if not isinstance(samples, slice):
        raise ValueError(f"samples is {samples!r}, must be slice(first, stop)")
    first, stop = samples.start or 0, samples.stop
    if samples.step not in (None, 1) or first < 0 or (stop is not None and stop <= first):
        raise ValueError(
            f"samples = {samples} must be slice(first, stop) with 0 <= first < stop and no step"
        )
    return first, stop
