# SPDX-License-Identifier: GPL-2.0-or-later
"""Breakdown of films and the discharge that follows (docs/electric_circuit, Breakdown)."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from raceway.arrays import Floats
from raceway.electric.films import Films
from raceway.theory.bearing import INNER, OUTER
from raceway.theory.film_voltage import local_gap, ring_voltages

SURFACES = ("rough", "smooth")


@dataclass(frozen=True)
class Breakdown:
    """A film fails where its voltage exceeds `strength` (V/m) times its local thickness.

    The local thickness is that of the film less three times the composite roughness ("rough") or
    the film's own ("smooth"), and at least `floor` (m). `roughness` (m) is the run's unless given.
    `arc` (ohm) is the resistance of a film while it fails; it gives the current of a failure and
    its duration.
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

    def local_thickness(self, films: Films) -> Floats:
        """(n, 2, Z) m; NaN where there is no film."""
        roughness = films.roughness if self.roughness is None else self.roughness
        return local_gap(
            films.thickness, roughness if self.surfaces == "rough" else 0.0, self.floor
        )

    def limit(self, films: Films) -> Floats:
        """The voltage at which each film fails, (n, 2, Z) V; infinite where there is no film."""
        local = self.local_thickness(films)
        none = np.isnan(local) | (films.capacitance == 0)
        return np.where(none, np.inf, self.strength * local)


def threshold(films: Films, limit: Floats) -> Floats:
    """The smallest voltage between the rings at which a film fails, (n,) V, with no charge on the
    balls; `limit` (n, 2, Z) V of each film. Infinite where no film can fail."""
    inner, outer = films.capacitance[:, INNER], films.capacitance[:, OUTER]
    return ring_voltages((limit[:, INNER], limit[:, OUTER]), inner, outer).min(axis=(0, 2))


class Node(NamedTuple):
    """The inner ring at one point, but for the films: `beside` (F) to the frame, `coupling` (F) to
    the `driving` voltage (V)."""

    beside: float
    coupling: float
    driving: float


class Failure(NamedTuple):
    """One film that failed, raceway and place of the ball among Z."""

    raceway: int
    ball: int
    film_voltage: float  # V, before
    bearing_voltage: float  # V, before
    bearing_voltage_after: float
    film_energy: float  # J, stored in the film before
    energy: float  # J, turned into heat


class ArcCurrent(NamedTuple):
    """Current of a failure through a resistance."""

    peak: float  # A
    duration: float  # s, in which it falls to 1/e

    @classmethod
    def of(cls, failure: Failure, arc: float) -> "ArcCurrent":
        """Of a `failure` through `arc` (ohm): what stands behind the film is a capacitance C, and
        the energy is C V^2/2 of the film's voltage."""
        volts = abs(failure.film_voltage)
        return cls(volts / arc, arc * 2 * failure.energy / volts**2)


class Discharge(NamedTuple):
    """Failures one after the other at one time, and the state they leave."""

    failures: list[Failure]
    ball_charge: Floats  # (Z,) C
    ring_charge: float  # C
    ball_voltage: Floats  # (Z,) V
    bearing_voltage: float  # V
    source_work: float  # J, of the driving voltage while the charges move


def discharge(
    capacitance: Floats,
    limit: Floats,
    node: Node,
    ball_charge: Floats,
    ring_charge: float,
    voltages: tuple[Floats, float],
) -> Discharge | None:
    """What breakdown makes of one point; None where no film fails.

    `capacitance` (F) and `limit` (V) are (2, Z), `voltages` those of balls (Z,) and inner ring
    before. A film that failed conducts until all are quiet; then it is whole again. The film that
    is loaded most, voltage over limit, fails first.
    """
    broken = np.zeros(capacitance.shape, dtype=bool)
    ball, ring = voltages
    failures, work = [], 0.0
    while True:
        film = np.stack([ring - ball, ball])
        load = np.where(broken, 0.0, np.abs(film) / limit)
        place = np.unravel_index(np.argmax(load), load.shape)
        if not load[place] > 1:
            break
        broken[place] = True
        before = stored(capacitance, node, ball, ring)
        ball, after = redistribute(capacitance, node, ball_charge, ring_charge, broken)
        moved = node.coupling * node.driving * (ring - after)
        work += moved
        lost = before - stored(capacitance, node, ball, after) + moved
        own = 0.5 * capacitance[place] * film[place] ** 2
        failures.append(Failure(int(place[0]), int(place[1]), film[place], ring, after, own, lost))
        ring = after
    if not failures:
        return None
    return Discharge(
        failures, *_charges(capacitance, node, ball_charge, ring_charge, broken, ball, ring), work
    )


def redistribute(
    capacitance: Floats, node: Node, ball_charge: Floats, ring_charge: float, broken: Floats
) -> tuple[Floats, float]:
    """(voltages of the balls, of the inner ring) with the `broken` films (2, Z) as conductors.

    A ball whose inner film is broken is one conductor with the inner ring: their charges add up. A
    ball whose outer film is broken is at 0 V. With both broken the inner ring is at 0 V.
    """
    inner, outer = capacitance
    to_ring, to_frame = broken
    if (to_ring & to_frame).any():
        ring = 0.0
        free = ~to_frame & ~to_ring
        return np.where(free, ball_charge * _inverse(inner + outer), 0.0), ring
    share = inner * _inverse(inner + outer)
    free = ~(to_ring | to_frame)
    between = np.where(free, share * outer, np.where(to_ring, outer, inner)).sum()
    charge = ring_charge + node.coupling * node.driving
    charge += np.where(free, share * ball_charge, np.where(to_ring, ball_charge, 0.0)).sum()
    ring = charge / (between + node.beside + node.coupling)
    alone = ball_charge * _inverse(inner + outer) + share * ring
    return np.where(free, alone, np.where(to_ring, ring, 0.0)), ring


def stored(capacitance: Floats, node: Node, ball: Floats, ring: float) -> float:
    """Energy in films, beside them and in the coupling, J."""
    inner, outer = capacitance
    films = (inner * (ring - ball) ** 2 + outer * ball**2).sum()
    return 0.5 * (films + node.beside * ring**2 + node.coupling * (ring - node.driving) ** 2)


def _charges(capacitance, node, ball_charge, ring_charge, broken, ball, ring):
    """Charges after the event; those of nodes that nothing touched stay as they are."""
    to_ring, to_frame = broken
    hit = to_ring | to_frame
    charge = np.where(hit, capacitance[1] * ball - capacitance[0] * (ring - ball), ball_charge)
    if (to_ring & to_frame).any():
        on_ring = (capacitance[0] * (ring - ball)).sum()
        on_ring += node.beside * ring + node.coupling * (ring - node.driving)
    else:
        on_ring = ring_charge + (ball_charge - charge)[to_ring].sum()
    return charge, on_ring, ball, ring


def _inverse(values):
    """1/values, 0 where they are 0."""
    return np.divide(1.0, values, out=np.zeros_like(values), where=values != 0)
