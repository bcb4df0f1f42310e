# SPDX-License-Identifier: GPL-2.0-or-later
"""The settings and samples in the folder of a run, as tables."""

import re
from collections.abc import Iterator
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from raceway.arrays import Floats, Numbers
from raceway.errors import RunError
from raceway.files import FilePath
from raceway.runs import record_tables
from raceway.runs.record import Record
from raceway.runs.settings import AT_THE_END, NO_LUBRICANT, settings
from raceway.runs.turning import Motion, Turning
from raceway.theory.bearing import Bearing

if TYPE_CHECKING:
    import pandas as pd

READERS = {"contacts": record_tables.contacts, "balls": record_tables.atoms}


class RunTables:
    """The `settings` of a run and its samples as tables, which are read on first use.

    Tables are `DataFrame` objects in SI units, or dicts of columns. Their column `sample` counts
    the samples of the measured window from 0. For a run larger than memory, `samples`, a slice
    without a step, selects a range of samples, or `blocks` reads all of them one block at a time. A
    run that is still running or was stopped can be read up to its latest sample; `finished` is then
    False. `bearing` selects one of several bearings by its number, counted from 1.

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
        """Return the same run with different `samples`, without reading or measuring its settings
        again."""
        part = RunTables.__new__(RunTables)
        part.folder, part.record, part.settings = self.folder, self.record, self.settings
        part.first, part.stop = _window(samples)
        part._turning = self._turning
        return part

    @property
    def turning(self) -> Turning:
        """Angles of rings, cage and balls. Raises `RunError` unless one bearing has been
        selected."""
        self.record.need_one()
        if not self._turning:
            self._turning.append(Turning(self.record))
        return self._turning[0]

    @cached_property
    def motion(self) -> Motion:
        """Mean speeds over the samples. Raises `RunError` if there are fewer than two samples."""
        return self.turning.motion(self.first, self.last)

    @property
    def lubricated(self) -> bool:
        """True if the run had a lubricant."""
        return self.settings["lubricant"] not in NO_LUBRICANT

    def pair_keyword(self, name: str) -> str | None:
        """Return the first value of a keyword in the commands of the pair style, or None if these
        do not contain it or were not recorded."""
        found = re.search(rf"\b{name} (\S+)", str(self.record.attrs.get("pair_commands", "")))
        return found[1] if found else None

    @property
    def finished(self) -> bool:
        """True if the run has finished; until then, `settings` lacks `step_s`, `simulated_s` and
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

    @cached_property
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
            "ring_young_Pa": "ring_young",
            "ring_poisson": "ring_poisson",
        }
        try:
            return Bearing.from_mapping({name: self.settings[key] for key, name in names.items()})
        except ValueError as error:
            raise RunError(f"{self.record.path}: {error}") from None

    @property
    def cage_ball_radius(self) -> float:
        """Radius of the cage balls in m; for a run without a cage, the radius that leaves no gap in
        the pockets."""
        if "cage_ball_diameter_m" in self.settings:
            return self.settings["cage_ball_diameter_m"] / 2
        bearing = self.geometry
        return 2 * bearing.pitch_radius * np.sin(np.pi / (2 * bearing.balls)) - bearing.ball_radius

    @cached_property
    def contacts(self) -> "pd.DataFrame":
        """One row for each sample and active contact of a ball with a raceway."""
        return record_tables.contacts(self.record, self.first, self.last)

    @cached_property
    def balls(self) -> "pd.DataFrame":
        """One row for each atom and sample."""
        return record_tables.atoms(self.record, self.first, self.last)

    @cached_property
    def ring_columns(self) -> dict[str, Floats]:
        """The columns of `rings`."""
        return record_tables.rings(self.record, self.first, self.last)

    @cached_property
    def rings(self) -> "pd.DataFrame":
        """One row for each sample: position and motion of the inner ring."""
        import pandas as pd

        return pd.DataFrame(self.ring_columns)

    @cached_property
    def total_columns(self) -> dict[str, Floats]:
        """The columns of `totals`."""
        return record_tables.totals(self.record, self.first, self.last)

    @cached_property
    def totals(self) -> "pd.DataFrame":
        """One row for each sample: sums and extremes over the bearing."""
        import pandas as pd

        count = len(self.total_columns["pressure"])
        index = pd.RangeIndex(self.first, self.first + count, name="sample")
        return pd.DataFrame(self.total_columns, index=index)

    @cached_property
    def pairs(self) -> "pd.DataFrame":
        """Result of `pairs.pairs` for the contacts: one row for each sample and ball that is loaded
        on both raceways."""
        from raceway.runs.pairs import pairs

        return pairs(self.contacts)

    @property
    def bearing_capacitance(self) -> Floats:
        """Capacitance of the bearing in F (eq 12), with one value per sample."""
        return self.record.known(self.total_columns)["capacitance"]

    @cached_property
    def last(self) -> int:
        """End of the available samples, at most `stop`. It is the same for all tables, even if the
        record is still growing. Raises `RunError` if there are no samples."""
        *_, (_, last) = self.record.blocks(self.first, self.stop)
        return last

    def blocks(self, name: str) -> Iterator["pd.DataFrame"]:
        """Yield the table `name`, "contacts" or "balls", in blocks of a few MB that consist of
        whole samples.

        The `attrs` of a block contain its `first` sample and its number of `samples`. Raise
        `RunError` if there are no samples.
        """
        if name in self.__dict__:  # the table has been read before
            yield self.__dict__[name]
            return
        for part in self.record.blocks(self.first, self.last):
            yield READERS[name](self.record, *part)

    def by_raceway(self, contacts: "pd.DataFrame") -> dict[str, np.ndarray]:
        """Return a dict that maps "inner" and "outer" to masks of the rows of `contacts`.

        If a ball may touch two grooves of a ring, the keys are "inner_0", "inner_1", "outer_0" and
        "outer_1".
        """
        place = contacts["raceway"].to_numpy(int)
        if self.record.two_grooves:
            place = 2 * place + contacts["groove"].to_numpy(int)
        return {name.replace(" ", "_"): place == k for k, name in enumerate(self.record.raceways)}

    def passes(self, sample: ArrayLike) -> Numbers:
        """Return the number of ball passes from the start of the measured window to a sample
        (number or array), computed from the angle of the cage."""
        return self.turning.passes(sample)

    def from_load_line(self, azimuth: Numbers) -> Numbers:
        """Return azimuths in rad (number or array) relative to the centre of the load zone, in the
        range from -pi to pi."""
        return np.mod(azimuth - self.settings["load_azimuth_rad"] + np.pi, 2 * np.pi) - np.pi

    def angles(self, contacts: "pd.DataFrame") -> Floats:
        """Return the azimuths of the rows of `contacts` in rad, relative to the centre of the load
        zone. Raise `RunError` if the run has not recorded them."""
        if "azimuth" not in contacts:
            raise RunError(f"{self.record.path} has no column azimuth; it must be recorded")
        return self.from_load_line(contacts["azimuth"].to_numpy())


def _window(samples):
    """Return (first, stop) of a slice of samples."""
    if not isinstance(samples, slice):
        raise ValueError(f"samples is {samples!r}, must be slice(first, stop)")
    first, stop = samples.start or 0, samples.stop
    if samples.step not in (None, 1) or first < 0 or (stop is not None and stop <= first):
        raise ValueError(
            f"samples = {samples} must be slice(first, stop) with 0 <= first < stop and no step"
        )
    return first, stop
