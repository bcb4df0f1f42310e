# SPDX-License-Identifier: GPL-2.0-or-later
"""Values from finished runs. The products of the paper read tables of runs only in this module.

Azimuths are in degrees from the load line, from -180 to 180. In one ball pass, the nine balls of a
6208 sweep the whole ring, so the values of all balls together represent one ball around the ring.
"""

import re
from collections.abc import Mapping
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np

from raceway import inputs
from raceway.arrays import Floats, Integers
from raceway.errors import RunError
from raceway.files import FilePath
from raceway.paper.cases import Case, Plan
from raceway.paper.runner import LOG
from raceway.runs import whole_capacitance
from raceway.runs.record_tables import BALL, CAGE
from raceway.runs.run import Run
from raceway.runs.summary import summary
from raceway.runs.tables import RunTables
from raceway.theory.bearing import INNER
from raceway.theory.capacitance import VACUUM
from raceway.theory.capacitors import FLOODED, Filling

GRID = np.arange(-180.0, 181.0)


class Reading:
    """Values from one run of a radially loaded, rotating bearing."""

    def __init__(self, case: Case, folder: FilePath, filling: Filling = FLOODED) -> None:
        self.case, self.given, self.tables = case, case.given, RunTables(folder)
        self.filling = filling

    @cached_property
    def figures(self) -> dict[str, Any]:
        """The `summary` of the run."""
        return summary(self.tables)

    @cached_property
    def _azimuths(self):
        contacts = self.tables.contacts
        return contacts[["sample", "ball", "raceway"]].assign(
            psi=np.degrees(self.tables.angles(contacts))
        )

    def around(self, raceway: int, column: str) -> tuple[Floats, Floats]:
        """Return (psi in degrees, values), sorted by psi, for a column of the active contacts of
        one raceway."""
        rows = self.tables.contacts["raceway"].to_numpy() == raceway
        return _sorted(
            self._azimuths["psi"].to_numpy()[rows], self.tables.contacts[column].to_numpy()[rows]
        )

    def ball_capacitance(self) -> tuple[Floats, Floats]:
        """Return (psi in degrees, capacitance in F), sorted by psi, of each ball that is loaded on
        both raceways, with the inner and the outer contact in series."""
        place = self._azimuths[self._azimuths["raceway"] == INNER]
        rows = self.tables.pairs.merge(place, on=["sample", "ball"])
        return _sorted(rows["psi"].to_numpy(), rows["capacitance"].to_numpy())

    def top(self, raceway: int, column: str) -> float:
        """Return the value of a column of the contacts of one raceway on the load line, psi = 0."""
        return float(np.interp(0.0, *self.around(raceway, column)))

    def top_capacitance(self) -> float:
        """Return the capacitance in F of a ball on the load line."""
        return float(np.interp(0.0, *self.ball_capacitance()))

    @cached_property
    def _whole(self):
        run = Run(self.tables.folder)
        run.tables = self.tables  # the contacts of these tables have already been read
        found = whole_capacitance.over_time(run, self.filling)
        line = run.balls["from_load_line"].sel(time=found["time"])
        return _sorted(
            np.degrees(line.to_numpy().ravel()), found["one_ball"].to_numpy().ravel()
        ), float(found["bearing"].mean())

    def whole_ball_capacitance(self) -> tuple[Floats, Floats]:
        """Return (psi in degrees, total capacitance in F), sorted by psi, of every ball."""
        return self._whole[0]

    def whole_top_capacitance(self) -> float:
        """Return the capacitance in F of a ball on the load line, including the surroundings of the
        plates."""
        return float(np.interp(0.0, *self.whole_ball_capacitance()))

    def whole_capacitance(self) -> float:
        """Return the mean capacitance in F of the bearing, including all surroundings of the
        plates."""
        return self._whole[1]

    def permittivity(self, raceway: int) -> tuple[Floats, Floats]:
        """Return (psi in degrees, relative permittivity) of contacts, computed from capacitance,
        film thickness and area (eq 8)."""
        psi, value = self.around(raceway, "capacitance")
        area = np.pi * self.around(raceway, "a")[1] * self.around(raceway, "b")[1]
        return psi, value * self.around(raceway, "h_c")[1] / (VACUUM * area)

    def loaded_balls(self) -> Integers:
        """Return the number of balls that are loaded on both raceways for each sample."""
        pairs = self.tables.pairs.groupby("sample").size()
        return pairs.reindex(range(self.tables.contacts.attrs["samples"]), fill_value=0).to_numpy()

    def cage_contact_share(self, ball_radius: float, cage_radius: float) -> float:
        """Return the fraction of neighbouring pairs of ball and cage ball that are in contact, over
        all samples."""
        balls = self.tables.balls
        places = {
            kind: (
                balls[balls["type"] == kind]
                .sort_values(["sample", "id"])[["x", "y", "z"]]
                .to_numpy()
            )
            for kind in (BALL, CAGE)
        }
        count = int(self.tables.settings["balls"])
        ball, cage = (places[kind].reshape(-1, count, 1, 3) for kind in (BALL, CAGE))
        gap = np.linalg.norm(ball - np.swapaxes(cage, 1, 2), axis=-1) - ball_radius - cage_radius
        touching = np.count_nonzero(gap < 0, axis=(1, 2))
        return float(touching.mean() / (2 * count))

    def coulomb_use(self) -> float:
        """Return the largest ratio of friction force to mu times normal force over all contacts."""
        contacts = self.tables.contacts[self.tables.contacts["normal"] > 0]
        return float((contacts["friction"].abs() / (contacts["mu"] * contacts["normal"])).max())

    def spin(self) -> float:
        """Return the mean spin in rad/s of a ball about the bearing axis, which is positive if it
        is opposite to the rotation of the inner ring."""
        balls = self.tables.balls
        return -float(balls.loc[balls["type"] == BALL, "omegaz"].mean())


def gridded(psi: Floats, values: Floats) -> Floats:
    """Interpolate values at whole degrees.

    They are zero where there is no sample nearby, for instance outside the load zone.
    """
    result = np.interp(GRID, psi, values, period=360)
    gap = np.min(np.abs((GRID[:, None] - psi[None, :] + 180) % 360 - 180), axis=1)
    return np.where(gap < 0.5, result, 0.0)


def _sorted(psi, values):
    order = np.argsort(psi, kind="stable")
    return psi[order], values[order]


ENDPLAY = {
    "angle": re.compile(r"^free contact angle (\S+) degrees", re.M),
    "endplay": re.compile(r"^free endplay (\S+) m", re.M),
}


def endplay(folder: Path) -> tuple[float, float]:
    """Return (free contact angle in degrees, free endplay in m) that inputs/in.axial printed.

    Raise `RunError` if it did not print them.
    """
    path = folder / LOG
    text = path.read_text(errors="replace")
    found = [pattern.search(text) for pattern in ENDPLAY.values()]
    if not all(found):
        raise RunError(f"{path} has no free contact angle and endplay")
    return tuple(float(match[1]) for match in found)


class Readings:
    """The finished cases of a plan, organised by set."""

    def __init__(self, plan: Plan, folders: Mapping[Case, Path]) -> None:
        self.plan, self.folders, self._kept = plan, folders, {}

    def filling(self, bearing: str) -> Filling:
        """Return flooded surroundings with the shoulders of a bearing in inputs/."""
        path = self.plan.root / "inputs/bearings" / bearing
        return FLOODED._replace(shoulders=inputs.shoulders(path))

    def has(self, product: str) -> bool:
        """Return True if all cases of a product have run."""
        return all(case in self.folders for case in self.plan.needed([product]))

    def all(self, name: str) -> list[Reading]:
        """Return the `Reading` objects of a set in the order of the file."""
        return [self._reading(case) for case in self.plan.cases[name]]

    def some(self, name: str, **given: Any) -> list[Reading]:
        """Return the `Reading` objects of a set that have the given settings."""
        return [
            one
            for one in self.all(name)
            if all(one.given[key] == value for key, value in given.items())
        ]

    def one(self, name: str, **given: Any) -> Reading:
        """Return the only `Reading` of a set that has these settings."""
        (found,) = self.some(name, **given)
        return found

    def endplays(self) -> list[tuple[dict[str, Any], float, float]]:
        """Return [(given, contact angle in degrees, endplay in m)] for the axial cases."""
        return [(case.given, *endplay(self.folders[case])) for case in self.plan.cases["endplay"]]

    def _reading(self, case):
        key = (case, tuple(case.given.items()))
        if key not in self._kept:
            filling = self.filling(str(case.given.get("bearing", "6208")))
            self._kept[key] = Reading(case, self.folders[case], filling)
        return self._kept[key]
