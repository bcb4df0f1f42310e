# SPDX-License-Identifier: GPL-2.0-or-later
"""Breakdown of films and the subsequent discharge (docs/electric_circuit, Breakdown)."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from raceway import core
from raceway.arrays import Floats
from raceway.electric.films import Films
from raceway.theory.film_voltage import PEAKS

SURFACES = ("rough", "smooth")


@dataclass(frozen=True)
class Breakdown:
    """A film fails when its voltage exceeds `strength` (V/m) times its local thickness.

    The local thickness is the film thickness ("smooth"), or the film thickness minus three times
    the composite roughness ("rough"), and at least `floor` (m). `roughness` (m) is the roughness of
    the run unless given. `arc` (ohm) is the resistance of a film while it fails; it gives the
    current of a failure and its duration.
    """

    strength: float
    surfaces: str = "rough"
    floor: float = 1e-9
    roughness: float | None = None
    arc: float | None = None

    def __post_init__(self) -> None:
        for name, unit in (("strength", "V/m"), ("floor", "m")):
            value = getattr(self, name)
            if not 0 < value < np.inf:
                raise ValueError(f"{name} = {value:g} {unit} must be positive")
        if self.surfaces not in SURFACES:
            raise ValueError(f"surfaces = '{self.surfaces}' must be {' or '.join(SURFACES)}")
        if self.arc is not None and not 0 < self.arc < np.inf:
            raise ValueError(f"arc = {self.arc:g} ohm must be positive")
        if self.roughness is not None and not self.roughness >= 0:
            raise ValueError(f"roughness = {self.roughness:g} m must be 0 or more")

    def less(self, films: Films) -> float:
        """Reduction of the thickness of the `films` by roughness, m."""
        roughness = films.roughness if self.roughness is None else self.roughness
        return PEAKS * roughness if self.surfaces == "rough" else 0.0

    def local_thickness(self, films: Films) -> Floats:
        """(n, 2, Z) m; NaN where there is no film."""
        return np.maximum(films.thickness - self.less(films), self.floor)

    def limit(self, films: Films) -> Floats:
        """The voltage at which each film fails, (n, 2, Z) V; infinite where there is no film."""
        local = self.local_thickness(films)
        none = np.isnan(local) | (films.capacitance == 0)
        return np.where(none, np.inf, self.strength * local)

    @property
    def bridged(self) -> float:
        """Limit in V of a film at the floor of the thickness, where asperities bridge it."""
        return self.strength * self.floor


def threshold(films: Films, limit: Floats, bridged: float = 0.0) -> Floats:
    """The smallest voltage between the rings, (n,) in V, at which a film fails, for uncharged
    balls; `limit` (n, 2, Z) is the limit of each film in V. Infinite where no film can fail, 0
    where the limit of a film does not exceed `bridged` (V)."""
    n, _, z = films.capacitance.shape
    found = np.empty(n)
    core.library().call(
        "threshold_voltages",
        points=n,
        balls=z,
        capacitance=films.capacitance,
        limit=limit,
        bridged=bridged,
        out=found,
    )
    return found


class Failure(NamedTuple):
    """One failed film: raceway and index of the ball among Z."""

    time: float  # s
    discharge: int  # number of the discharge, from 1
    order: int  # of this failure in the discharge, from 1
    raceway: int
    ball: int
    film_voltage: float  # V, before the failure
    bearing_voltage: float  # V, before the failure
    bearing_voltage_after: float
    film_energy: float  # J, stored in the film before the failure
    energy: float  # J, converted into heat


class ArcCurrent(NamedTuple):
    """Current of a failure through a resistance."""

    peak: float  # A
    duration: float  # s, in which the current falls to 1/e

    @classmethod
    def of(cls, failure: Failure, arc: float) -> "ArcCurrent":
        """Current of a `failure`, or of arrays of them, through `arc` (ohm). The source behind
        the film is a capacitance C, with the energy C V^2/2 at the film's voltage."""
        volts = np.abs(failure.film_voltage)
        return cls(volts / arc, arc * 2 * failure.energy / volts**2)


ROW = Failure._fields  # numbers of a failure, as the library returns them


def failure_of(row: Floats) -> Failure:
    """`Failure` of one row of numbers in the order of `ROW`."""
    return Failure(float(row[0]), *map(int, row[1:5]), *map(float, row[5:]))
