# SPDX-License-Identifier: GPL-2.0-or-later
"""A run folder: `run.yaml`, `contacts.dump`, `balls.dump`, `rings.dat`."""

from functools import cached_property
from pathlib import Path

import numpy as np
import yaml

from raceway import capacitance
from raceway.bearing import INNER, OUTER
from raceway.dump import read_dump, read_table
from raceway.errors import RunError

WORDS = ("bearing", "lubricant", "host", "integrator", "contact_columns", "ball_columns")
NUMBERS = ("load_N", "rpm", "clearance_m", "step_s", "passes", "balls", "ball_diameter_m", "inner_radius_m",
           "outer_radius_m", "inner_groove_m", "outer_groove_m", "load_azimuth_rad", "sample_s", "samples_per_pass",
           "inner_ring", "outer_ring")
AT_THE_END = ("wall_s", "simulated_s")  # written last: without them the run has not finished
LUBRICANT = ("viscosity_Pa_s", "pressure_viscosity_per_Pa", "permittivity", "roughness_m")
BALL = 1  # atom type
NO_LUBRICANT = ("dry", "none")


class Run:
    """What a run says of itself (`settings`) and, read when first asked for, what it wrote.

    Tables are `DataFrame`s in SI units whose column `sample` counts the samples of the measured window from 0.
    Raises `RunError` when the folder is not a finished run; so do the tables when their file is broken.
    """

    def __init__(self, folder):
        self.folder = Path(folder)
        self.settings = _settings(self.folder)

    @property
    def lubricated(self):
        """Whether the run had a lubricant."""
        return self.settings["lubricant"] not in NO_LUBRICANT

    @cached_property
    def contacts(self):
        """A row per live contact of a ball with a raceway and sample."""
        table = self._dump("contacts.dump", "contact_columns", ("ball", "raceway", "azimuth", "load", "pressure"))
        whole = {"ball": int, "raceway": int}
        samples, table = table.attrs["samples"], table.astype(whole)
        table.attrs["samples"] = samples
        return table

    @cached_property
    def balls(self):
        """A row per atom and sample."""
        return self._dump("balls.dump", "ball_columns", ("id", "type", "x", "y", "vx", "vy"))

    @cached_property
    def rings(self):
        """A row per sample: where the inner ring is and how it moves."""
        table = read_table(self.folder / "rings.dat")
        self._need(table, ("x", "y"), "rings.dat")
        # counted from the start of the window, like the dumps; the first row may be a later sample
        table["sample"] = np.rint(table["time"] / self.settings["sample_s"]).astype(int)
        return table

    @cached_property
    def pairs(self):
        """A row per sample and ball loaded on both raceways: `load_inner`, `load_outer` and, if the run has them,
        `capacitance_inner`, `capacitance_outer` and `capacitance`, both in series."""
        contacts = self.contacts
        names = ["sample", "ball"] + [name for name in ("load", "capacitance") if name in contacts]
        live = contacts.loc[contacts["load"] > 0, names + ["raceway"]]
        sides = [live.loc[live["raceway"] == side, names] for side in (INNER, OUTER)]
        pairs = sides[0].merge(sides[1], on=["sample", "ball"], suffixes=("_inner", "_outer"))
        if "capacitance_inner" in pairs:
            pairs["capacitance"] = capacitance.ball(pairs["capacitance_inner"], pairs["capacitance_outer"])
        return pairs

    @cached_property
    def bearing_capacitance(self):
        """Capacitance of the bearing in F, one value a sample (eq 12)."""
        total = self.pairs.groupby("sample")["capacitance"].sum()
        return total.reindex(range(self.contacts.attrs["samples"]), fill_value=0.0).to_numpy()

    def passes(self, sample):
        """Time of a sample (number or array) in ball passes since the start of the measured window."""
        return np.asarray(sample) / self.settings["samples_per_pass"]

    def from_load_line(self, azimuth):
        """Azimuths in rad (array) counted from the centre of the loaded zone, within -pi..pi."""
        return np.mod(azimuth - self.settings["load_azimuth_rad"] + np.pi, 2 * np.pi) - np.pi

    def _dump(self, name, key, needed):
        columns = self.settings[key].split()
        if twice := sorted({column for column in columns if columns.count(column) > 1}):
            raise RunError(f"{self.folder / 'run.yaml'}: {key} names {' '.join(twice)} twice")
        table = read_dump(self.folder / name, columns)
        self._need(table, needed, name)
        return table

    def _need(self, table, needed, name):
        if missing := [column for column in needed if column not in table]:
            raise RunError(f"{self.folder / name} has no column {' '.join(missing)}")


def _settings(folder):
    path = folder / "run.yaml"
    try:
        # every scalar as text: 6208 is a name, and YAML 1.1 takes 1e-05 for a string anyway
        data = yaml.load(path.read_text(), Loader=yaml.BaseLoader)
    except (OSError, UnicodeDecodeError) as error:
        raise RunError(f"cannot read {path}: {getattr(error, 'strerror', None) or error}") from None
    except yaml.YAMLError as error:
        mark = getattr(error, "problem_mark", None)
        where = f", line {mark.line + 1}" if mark else ""
        raise RunError(f"{path}{where}: {getattr(error, 'problem', None) or error}") from None
    if not isinstance(data, dict):
        raise RunError(f"{path} is not a list of 'name: value'")
    missing = [key for key in AT_THE_END if key not in data]
    if missing:
        raise RunError(f"run has not finished: {path} has no {' and no '.join(missing)}")
    lubricant = LUBRICANT if data.get("lubricant") not in (*NO_LUBRICANT, None) else ()
    needed = (*WORDS, *NUMBERS, *AT_THE_END, *lubricant)
    if missing := [key for key in needed if key not in data]:
        raise RunError(f"{path} has no {', '.join(missing)}")
    settings = dict(data)
    for key in (*NUMBERS, *AT_THE_END, *lubricant):
        try:
            settings[key] = float(data[key])
            if not np.isfinite(settings[key]):
                raise ValueError
        except (TypeError, ValueError):
            raise RunError(f"{path}: {key} is not a number: '{data[key]}'") from None
    for key in ("balls", "inner_ring", "outer_ring"):
        settings[key] = int(settings[key])
    for key in ("sample_s", "samples_per_pass", "wall_s"):
        if not settings[key] > 0:
            raise RunError(f"{path}: {key} = {data[key]} must be positive")
    return settings
