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
    """Model of film failure. A film fails when its voltage exceeds `strength` (V/m) times its local
    thickness.

    The local thickness is the film thickness ("smooth") or the film thickness minus three times the
    composite roughness ("rough"), but at least `floor` (m). By default, the `roughness` (m) of the
    run is used. `arc` (ohm) is the resistance of a film while it fails; the current and the
    duration of a failure are computed from it.
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
        """Return the amount in m by which roughness reduces the thickness of the `films`."""
        roughness = films.roughness if self.roughness is None else self.roughness
        return PEAKS * roughness if self.surfaces == "rough" else 0.0

    def local_thickness(self, films: Films) -> Floats:
        """Return the local thickness (n, 2, Z) in m, which is NaN where there is no film."""
        return np.maximum(films.thickness - self.less(films), self.floor)

    def limit(self, films: Films) -> Floats:
        """Return the voltage (n, 2, Z) in V at which each film fails; infinite if there is no
        film."""
        local = self.local_thickness(films)
        none = np.isnan(local) | (films.capacitance == 0)
        return np.where(none, np.inf, self.strength * local)

    @property
    def bridged(self) -> float:
        """Voltage limit in V of a film whose local thickness is at the floor, i.e. where asperities
        bridge the film."""
        return self.strength * self.floor


def threshold(films: Films, limit: Floats, bridged: float = 0.0) -> Floats:
    """Return the smallest voltage (n,) in V between the rings at which a film fails if the balls
    are uncharged; `limit` (n, 2, Z) contains the voltage limit of each film in V. The result is
    infinite if no film can fail, and 0 if the limit of a film does not exceed `bridged` (V)."""
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
    """Failure of one film, which is identified by its raceway and the index of its ball."""

    time: float  # s, time of the failure
    discharge: int  # number of the discharge, starting at 1
    # position of this failure in the sequence of failures of the discharge, starting at 1
    order: int
    raceway: int
    ball: int  # index of the ball, from 0 to Z - 1
    film_voltage: float  # V, voltage across the film before the failure
    bearing_voltage: float  # V, voltage between the rings before the failure
    bearing_voltage_after: float  # V, voltage between the rings after the failure
    film_energy: float  # J, energy stored in the film before the failure
    energy: float  # J, energy converted into heat


class ArcCurrent(NamedTuple):
    """Current during a failure, limited by a resistance."""

    peak: float  # A, peak current
    duration: float  # s, time in which the current falls to 1/e of its peak

    @classmethod
    def of(cls, failure: Failure, arc: float) -> "ArcCurrent":
        """Compute the current during a `failure`, or arrays of failures, through `arc` (ohm). The
        source behind the film is treated as a capacitance C that stores the energy C V^2/2 at the
        voltage V of the film."""
        volts = np.abs(failure.film_voltage)
        return cls(volts / arc, arc * 2 * failure.energy / volts**2)


ROW = Failure._fields  # order of the numbers that the library returns for a failure


def failure_of(row: Floats) -> Failure:
    """Convert a row of numbers in the order of `ROW` to a `Failure`."""
    return Failure(float(row[0]), *map(int, row[1:5]), *map(float, row[5:]))
