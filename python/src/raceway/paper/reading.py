# SPDX-License-Identifier: GPL-2.0-or-later
"""Numbers from finished runs; the paper's products read tables of runs only here.

Azimuths are degrees from the load line, -180 to 180. In one ball pass the nine balls of a 6208
sweep the whole ring, so the values of all balls together show one ball around the ring.
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
    """One run of a radially loaded, rotating bearing."""

    def __init__(self, case: Case, folder: FilePath, filling: Filling = FLOODED) -> None:
        self.case, self.given, self.tables = case, case.given, RunTables(folder)
        self.filling = filling

    @cached_property
    def figures(self) -> dict[str, Any]:
        """The run's `summary`."""
        return summary(self.tables)

    @cached_property
    def _azimuths(self):
        contacts = self.tables.contacts
        return contacts[["sample", "ball", "raceway"]].assign(
            psi=np.degrees(self.tables.angles(contacts))
        )

    def around(self, raceway: int, column: str) -> tuple[Floats, Floats]:
        """(psi in degrees, values), sorted, of a column of the contacts of one raceway, where there
        is contact."""
        rows = self.tables.contacts["raceway"].to_numpy() == raceway
        return _sorted(
            self._azimuths["psi"].to_numpy()[rows], self.tables.contacts[column].to_numpy()[rows]
        )

    def ball_capacitance(self) -> tuple[Floats, Floats]:
        """(psi in degrees, F), sorted: inner and outer contact in series, for each ball loaded on
        both raceways."""
        place = self._azimuths[self._azimuths["raceway"] == INNER]
        rows = self.tables.pairs.merge(place, on=["sample", "ball"])
        return _sorted(rows["psi"].to_numpy(), rows["capacitance"].to_numpy())

    def top(self, raceway: int, column: str) -> float:
        """A column of the contacts of one raceway on the load line, psi = 0."""
        return float(np.interp(0.0, *self.around(raceway, column)))

    def top_capacitance(self) -> float:
        """Capacitance in F of a ball on the load line."""
        return float(np.interp(0.0, *self.ball_capacitance()))

    @cached_property
    def _whole(self):
        run = Run(self.tables.folder)
        run.tables = self.tables  # its contacts have already been read
        found = whole_capacitance.over_time(run, self.filling)
        line = run.balls["from_load_line"].sel(time=found["time"])
        return _sorted(
            np.degrees(line.to_numpy().ravel()), found["one_ball"].to_numpy().ravel()
        ), float(found["bearing"].mean())

    def whole_ball_capacitance(self) -> tuple[Floats, Floats]:
        """(psi in degrees, F), sorted: every ball with its total capacitance."""
        return self._whole[0]

    def whole_top_capacitance(self) -> float:
        """Capacitance in F of a ball on the load line, including the surroundings of the plates."""
        return float(np.interp(0.0, *self.whole_ball_capacitance()))

    def whole_capacitance(self) -> float:
        """Mean capacitance in F of the bearing, including all surroundings of the plates."""
        return self._whole[1]

    def permittivity(self, raceway: int) -> tuple[Floats, Floats]:
        """(psi in degrees, relative permittivity) of contacts, from capacitance, film and area (eq
        8)."""
        psi, value = self.around(raceway, "capacitance")
        area = np.pi * self.around(raceway, "a")[1] * self.around(raceway, "b")[1]
        return psi, value * self.around(raceway, "h_c")[1] / (VACUUM * area)

    def loaded_balls(self) -> Integers:
        """Number of balls loaded on both raceways, one value per sample."""
        pairs = self.tables.pairs.groupby("sample").size()
        return pairs.reindex(range(self.tables.contacts.attrs["samples"]), fill_value=0).to_numpy()

    def cage_contact_share(self, ball_radius: float, cage_radius: float) -> float:
        """Fraction of the neighbouring pairs of ball and cage ball that are in contact, over all
        samples."""
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
        """Largest ratio of friction force to mu times normal force, over all contacts."""
        contacts = self.tables.contacts[self.tables.contacts["normal"] > 0]
        return float((contacts["friction"].abs() / (contacts["mu"] * contacts["normal"])).max())

    def spin(self) -> float:
        """Mean spin in rad/s of a ball about the bearing's axis; positive if opposite to the inner
        ring's rotation."""
        balls = self.tables.balls
        return -float(balls.loc[balls["type"] == BALL, "omegaz"].mean())


def gridded(psi: Floats, values: Floats) -> Floats:
    """Values at whole degrees; zero where no sample is near, for instance outside the load zone."""
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
    """(free contact angle in degrees, free endplay in m) that inputs/in.axial printed. Raises
    `RunError`."""
    path = folder / LOG
    text = path.read_text(errors="replace")
    found = [pattern.search(text) for pattern in ENDPLAY.values()]
    if not all(found):
        raise RunError(f"{path} has no free contact angle and endplay")
    return tuple(float(match[1]) for match in found)


class Readings:
    """The finished cases of a plan, by set."""

    def __init__(self, plan: Plan, folders: Mapping[Case, Path]) -> None:
        self.plan, self.folders, self._kept = plan, folders, {}

    def filling(self, bearing: str) -> Filling:
        """Flooded surroundings, and the shoulders of a bearing of inputs/."""
        path = self.plan.root / "inputs/bearings" / bearing
        return FLOODED._replace(shoulders=inputs.shoulders(path))

    def has(self, product: str) -> bool:
        """True if all cases of a product have run."""
        return all(case in self.folders for case in self.plan.needed([product]))

    def all(self, name: str) -> list[Reading]:
        """The `Reading`s of a set, in the order of the file."""
        return [self._reading(case) for case in self.plan.cases[name]]

    def some(self, name: str, **given: Any) -> list[Reading]:
        """The `Reading`s of a set with the given settings."""
        return [
            one
            for one in self.all(name)
            if all(one.given[key] == value for key, value in given.items())
        ]

    def one(self, name: str, **given: Any) -> Reading:
        """The only `Reading` of a set with these settings."""
        (found,) = self.some(name, **given)
        return found

    def endplays(self) -> list[tuple[dict[str, Any], float, float]]:
        """[(given, contact angle in degrees, endplay in m)] of the axial cases."""
        return [(case.given, *endplay(self.folders[case])) for case in self.plan.cases["endplay"]]

    def _reading(self, case):
        key = (case, tuple(case.given.items()))
        if key not in self._kept:
            filling = self.filling(str(case.given.get("bearing", "6208")))
            self._kept[key] = Reading(case, self.folders[case], filling)
        return self._kept[key]
