# SPDX-License-Identifier: GPL-2.0-or-later
"""A run folder: its record, or `run.yaml`, `contacts.dump`, `balls.dump`, `rings.dat`."""

import warnings
from collections.abc import Iterator
from functools import cached_property
from pathlib import Path

import numpy as np
import pandas as pd
from numpy.typing import ArrayLike

from raceway import progress
from raceway.arrays import Floats, Numbers
from raceway.errors import RunError, RunWarning
from raceway.files import FilePath
from raceway.runs.dump import Index, blocks, first_steps, frames, read_dump, read_table
from raceway.runs.record import Record, there
from raceway.runs.same_run import need_same_run
from raceway.runs.settings import AT_THE_END, NO_LUBRICANT, said, settings, the_end
from raceway.runs.steps import Steps
from raceway.runs.text import FILES, need_text
from raceway.runs.told import Told
from raceway.runs.totals import pairs, totals
from raceway.theory.bearing import OUTER, Bearing

BALL, CAGE = 1, 2  # atom types
DUMPS = {
    "contacts": (
        "contacts.dump",
        "contact_columns",
        ("ball", "raceway", "azimuth", "load", "pressure"),
    ),
    "balls": ("balls.dump", "ball_columns", ("id", "type", "x", "y", "vx", "vy")),
}
WHOLE = ("ball", "raceway", "groove", "id", "type")
MOST = {"raceway": OUTER, "groove": 1}


class RunTables:
    """What a run says of itself (`settings`) and, read when first asked for, what it wrote.

    Tables are `DataFrame`s in SI units whose column `sample` counts the samples of the measured
    window from 0. `samples`, a slice without step, keeps to some of them: the way to look into a
    run larger than memory. The other is `blocks`. A run that is still going, or was stopped, can be
    read as far as it is; `finished` tells.

    Raises `RunError` when the folder has no `run.yaml` or a broken one, or a record that is of
    another run than its `run.yaml`; so do the tables when their file is broken.
    """

    def __init__(
        self, folder: FilePath, samples: slice = slice(None), bearing: int | None = None
    ) -> None:
        self.folder = Path(folder)
        self.record = Record(folder, bearing) if there(folder) else None
        if self.record is None and bearing not in (None, 1):
            raise RunError(f"{self.folder} has one bearing, not {bearing}")
        self.settings = self._of_record(self.record) if self.record else settings(self.folder)
        self.first, self.stop = _window(samples)

    def _of_record(self, record):
        beside = said(self.folder)
        end = the_end(self.folder, beside)
        need_same_run(record, beside)
        return Told({**record.settings(), **end}, (record.need_one, record.need_samples))

    def window(self, samples: slice) -> "RunTables":
        """The same run with other `samples`."""
        return RunTables(self.folder, samples, self.record.bearing if self.record else None)

    @property
    def source(self) -> dict[str, Path]:
        """The file that messages name, by what is in it: contacts, balls, rings."""
        if self.record:
            return dict.fromkeys(FILES, self.record.path)
        return {name: self.folder / file for name, file in FILES.items()}

    @property
    def lubricated(self) -> bool:
        """Whether the run had a lubricant."""
        return self.settings["lubricant"] not in NO_LUBRICANT

    @property
    def finished(self) -> bool:
        """Whether the run came to its end; until then `settings` has no `step_s`, `simulated_s` and
        `wall_s`."""
        return all(key in self.settings for key in AT_THE_END)

    def need_finished(self) -> None:
        """Raise `RunError` for a run that has not come to its end."""
        if self.record:
            self.record.need_one()
        path = self.folder / "run.yaml"
        if not path.exists():
            raise RunError(f"{path} is missing: it says whether the run has finished, and its cost")
        if missing := [key for key in AT_THE_END if key not in self.settings]:
            raise RunError(f"run has not finished: {path} has no {' and no '.join(missing)}")

    @property
    def geometry(self) -> Bearing:
        """The `Bearing` that was simulated; steel where the run does not say."""
        if self.record:
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
        return Bearing.from_mapping(
            {name: self.settings[key] for key, name in names.items() if key in self.settings}
        )

    @property
    def cage_ball_radius(self) -> float:
        """m; of a run that does not say, that of cage balls without pocket gap. A run without cage
        has one, too."""
        if "cage_ball_diameter_m" in self.settings:
            return self.settings["cage_ball_diameter_m"] / 2
        bearing = self.geometry
        return 2 * bearing.pitch_radius * np.sin(np.pi / (2 * bearing.balls)) - bearing.ball_radius

    @cached_property
    def contacts(self) -> pd.DataFrame:
        """A row per live contact of a ball with a raceway and sample."""
        return self._dump("contacts")

    @cached_property
    def balls(self) -> pd.DataFrame:
        """A row per atom and sample."""
        return self._dump("balls")

    @cached_property
    def rings(self) -> pd.DataFrame:
        """A row per sample: where the inner ring is and how it moves."""
        if self.record:
            return self.record.rings(self.first, self._end_of_samples())
        need_text(self.folder)
        table = read_table(self.folder / "rings.dat")
        self._need(table, ("time", "x", "y"), "rings.dat")
        # counted from the start of the window, like the dumps; the first row may be a later sample
        table["sample"] = self._samples(table, "rings.dat")
        if (self.first, self.stop) == (0, None):
            return table
        kept = (table["sample"] >= self.first) & (
            table["sample"] < (np.inf if self.stop is None else self.stop)
        )
        return table[kept].reset_index(drop=True)

    @cached_property
    def pairs(self) -> pd.DataFrame:
        """`totals.pairs` of the contacts: a row per sample and ball loaded on both raceways."""
        return pairs(self.contacts)

    @cached_property
    def totals(self) -> pd.DataFrame:
        """`totals.totals` of the contacts: a row per sample. Read in blocks."""
        if self.record:
            return self.record.totals(self.first, self._end_of_samples())
        return pd.concat([totals(block) for block in self.blocks("contacts")])

    @property
    def bearing_capacitance(self) -> Floats:
        """Capacitance of the bearing in F, one value a sample (eq 12)."""
        return self.totals["capacitance"].to_numpy()

    def blocks(self, name: str) -> Iterator[pd.DataFrame]:
        """Yield the table `name`, "contacts" or "balls", in pieces of whole samples and a few MB.

        Their `attrs` say which: `first` and how many `samples`. Raises `RunError` where there are
        none.
        """
        if name in self.__dict__:  # read already
            yield self.__dict__[name]
            return
        if self.record:
            read = self.record.contacts if name == "contacts" else self.record.atoms
            yield from (read(*part) for part in self.record.blocks(self.first, self.stop))
            return
        file, columns = self._columns(name)
        path = self.folder / file
        steps = self._steps(name)
        for block in progress.reading(
            path, blocks(path, columns, self.first, self.stop, self._index(name))
        ):
            steps.take(block.steps)
            yield _whole(block.table(columns), path)
        self._need_all(steps)

    def need_one_groove(self, what: str) -> None:
        """Raise `RunError` where rings have two grooves for a ball."""
        if self.record:
            two = len(self.record.raceways) > 2
        else:
            two = "groove" in self.settings["contact_columns"].split()
        if two:
            raise RunError(
                f"{self.folder} has rings of two grooves for a ball; {what} needs rings of one"
            )

    def need_balls(self) -> None:
        """Raise `RunError` where `run.yaml` names more balls than `balls.dump` has."""
        if self.record:
            return
        file, columns = self._columns("balls")
        if not (self.folder / file).exists():
            return
        frame = next(frames(self.folder / file, columns))
        there = np.count_nonzero(frame.values[:, columns.index("type")] == BALL)
        if self.settings["balls"] > there:
            raise RunError(
                f"{self.folder / 'run.yaml'}: balls = {self.settings['balls']}, but {file} has"
                f" {there}"
            )

    def time(self, samples: Numbers) -> Floats:
        """Times of `samples` (array of numbers that follow one another) in s."""
        if self.record:
            return self.record.read(["time"], samples[0], samples[-1] + 1)["time"]
        return samples * self.settings["sample_s"]

    def passes(self, sample: ArrayLike) -> Numbers:
        """Time of a sample (number or array) in ball passes since the start of the measured
        window."""
        return np.asarray(sample) / self.settings["samples_per_pass"]

    def from_load_line(self, azimuth: Numbers) -> Numbers:
        """Azimuths in rad (number or array) counted from the centre of the loaded zone, within
        -pi..pi."""
        return np.mod(azimuth - self.settings["load_azimuth_rad"] + np.pi, 2 * np.pi) - np.pi

    def angles(self, contacts: pd.DataFrame) -> Floats:
        """The azimuths of rows of contacts, in rad from the centre of the loaded zone. Raises
        `RunError` where the run has not recorded them."""
        if "azimuth" not in contacts:
            raise RunError(f"{self.source['contacts']} has no column azimuth: record it as well")
        return self.from_load_line(contacts["azimuth"].to_numpy())

    def _end_of_samples(self):
        """Number of samples that are there, at most `stop`."""
        *_, (_, last) = self.record.blocks(self.first, self.stop)
        return last

    def frames(self, name: str, start: int, stop: int) -> tuple[pd.DataFrame, list[int]]:
        """(the table `name` of the samples `start` to `stop`, their steps)."""
        if self.record:
            read = self.record.contacts if name == "contacts" else self.record.atoms
            steps = self.record.read(["step"], start, stop)["step"]
            return read(start, stop), steps.astype(int).tolist()
        file, columns = self._columns(name)
        parts = list(blocks(self.folder / file, columns, start, stop, self.index(name)))
        steps = sum((part.steps for part in parts), [])
        return pd.concat([part.table(columns) for part in parts]), steps

    def _dump(self, name):
        if self.record:
            first, stop = self.first, self._end_of_samples()
            read = self.record.contacts if name == "contacts" else self.record.atoms
            return read(first, stop)
        file, columns = self._columns(name)
        path, steps = self.folder / file, self._steps(name)
        table = read_dump(path, columns, self.first, self.stop, self._index(name))
        steps.take(table.attrs.pop("steps"))
        self._need_all(steps)
        return _whole(table, path)

    def _steps(self, name):
        """`Steps` of the dump behind `name`, which are those of the other dump."""
        path, other = (
            self.folder / DUMPS[one][0]
            for one in (name, "balls" if name == "contacts" else "contacts")
        )
        known = first_steps(other) if other.exists() else []
        spacing = known[1] - known[0] if len(known) == 2 else None
        return Steps(path, known[0] if known and not self.first else None, spacing)

    def _samples(self, table, name):
        """Numbers of the samples, from their time and step."""
        path, wrong = self.folder / name, "holds times that are no samples"
        samples = np.rint(table["time"].to_numpy() / self.settings["sample_s"])
        if not np.all(np.abs(samples) < 1e15):
            raise RunError(f"{path} {wrong}")
        samples = samples.astype(int)
        Steps(path, spacing=1).take(samples)
        last = round(self.settings["passes"] * self.settings["samples_per_pass"])
        if self.finished and samples[-1] != last:
            warnings.warn(
                f"{path} ends with sample {samples[-1]}, a finished run with {last}",
                RunWarning,
                stacklevel=3,
            )
        if "step" in table:
            steps = Steps(path)
            steps.take(table["step"].to_numpy())
            for dump, _, _ in DUMPS.values():
                known = first_steps(self.folder / dump) if (self.folder / dump).exists() else []
                if len(known) == 2 and np.any(
                    table["step"] != known[0] + samples * (known[1] - known[0])
                ):
                    raise RunError(f"{path} has not the steps of {dump}")
        return samples

    def _need_all(self, steps):
        """Warn where a finished run has not all of its samples, or more."""
        expected = round(self.settings["passes"] * self.settings["samples_per_pass"]) + 1
        if self.finished and (self.first, self.stop) == (0, None) and steps.count != expected:
            warnings.warn(
                f"{steps.path} holds {steps.count} samples, a finished run of"
                f" {self.settings['passes']:g} passes has {expected}",
                RunWarning,
                stacklevel=3,
            )

    def _index(self, name):
        return self.index(name) if self.first else None

    def index(self, name: str) -> Index | range:
        """As long as there are samples of the table `name`; `dump.Index` of its file if that is
        one."""
        if self.record:
            return range(len(self.record))
        need_text(self.folder)
        if name not in self._indices:
            self._indices[name] = Index(self.folder / DUMPS[name][0])
        return self._indices[name]

    @cached_property
    def _indices(self):
        return {}

    def _columns(self, name):
        """(file, names of its columns)"""
        need_text(self.folder)
        file, key, needed = DUMPS[name]
        columns = self.settings[key].split()
        if twice := sorted({column for column in columns if columns.count(column) > 1}):
            raise RunError(f"{self.folder / 'run.yaml'}: {key} names {' '.join(twice)} twice")
        self._need(columns, needed, file)
        return file, columns

    def _need(self, table, needed, name):
        if missing := [column for column in needed if column not in table]:
            raise RunError(f"{self.folder / name} has no column {' '.join(missing)}")


def _whole(table, path):
    for name in (name for name in WHOLE if name in table):
        values, most = table[name].to_numpy(), MOST.get(name, 1e15)
        wrong = (values != np.rint(values)) | ~((values >= 0) & (values <= most))
        if wrong.any():
            raise RunError(
                f"{path}: {name} is {values[wrong][0]:g}, must be a whole number from 0 to {most:g}"
            )
    attrs, table = table.attrs, table.astype({name: int for name in WHOLE if name in table})
    table.attrs = attrs
    return table


def _window(samples):
    """(first, stop) of a slice of samples."""
    first, stop = samples.start or 0, samples.stop
    if samples.step not in (None, 1) or first < 0 or (stop is not None and stop <= first):
        raise ValueError(
            f"samples = {samples} must be slice(first, stop) with 0 <= first < stop and no step"
        )
    return first, stop
