# SPDX-License-Identifier: GPL-2.0-or-later
"""The voltages of a bearing's floating balls and of its inner ring over time
(docs/electric_circuit, Network).

Unknowns are charges: that of every ball and that of the inner ring. Resistances move them from
point to point, by the two-stage SDIRK method of second order that is L-stable. Without resistances
charges stay, and voltages follow from them at every point alone. The balls are eliminated in closed
form, so a point costs O(Z).
"""

from typing import NamedTuple

import numpy as np

from raceway.arrays import Floats
from raceway.electric.breakdown import Discharge, Node, discharge
from raceway.electric.films import Films
from raceway.electric.outer import Terms
from raceway.errors import RunError

STAGE = 1 - np.sqrt(0.5)  # both the diagonal of the method and the time of its first stage
ROUNDING = 1e-12  # of the charge of a film: less on a ball is what additions leave
FEW, MANY = 16, 4096  # points solved ahead without resistances: after a discharge, and at most


class Solution(NamedTuple):
    """n points; `before` is without what a discharge at the same point changes."""

    ball_voltage: Floats  # (n, Z) V
    bearing_voltage: Floats  # (n,) V
    ball_voltage_before: Floats
    bearing_voltage_before: Floats
    ball_charge: Floats  # (n, Z) C, carried from point to point
    ring_charge: Floats  # (n,) C
    leaked: Floats  # (n, 2, Z) C through the conductance of each film in the step that ends here
    supplied: Floats  # (n,) C from the driving voltage through its conductance, likewise
    discharges: dict[int, Discharge]  # by point


def solve(films: Films, terms: Terms, limit: Floats | None) -> Solution:
    """The network of `films` and the outer circuit `terms`; a film fails at `limit` (n, 2, Z) V,
    None: never.

    Balls start without charge. Raises `ValueError` for breakdown on a source without resistance,
    `RunError` where a ball with charge loses both films.
    """
    if limit is not None and terms.stiff:
        raise ValueError("breakdown would short a source without resistance: give it a resistance")
    network = _Network(films, terms, limit)
    if films.conductance.any() or 0 < terms.conductance < np.inf:
        network.with_resistances()
    else:
        network.without_resistances()
    solution = network.solution
    _refuse_lost_charge(films, solution)
    if terms.stiff:
        return _Stiff(films, terms).charged(solution)
    return solution


class _Star(NamedTuple):
    """Films and outer circuit as the charges of some points see them: capacitances, and
    conductances times `length` (s) beside them."""

    share: Floats  # (n, Z) of a ball's charge that counts for the inner ring
    inverse: Floats  # (n, Z) 1/F, volts of a ball by its own charge
    inverse_ring: Floats  # (n,) 1/F, volts of the inner ring by its charge
    push: Floats  # (n,) C that the driving voltage puts on the inner ring
    driving: Floats  # (n,) V

    def at(self, k, ball_charge, ring_charge, stiff):
        """(voltages of the balls, of the inner ring) at point or slice `k`."""
        share = self.share[k]
        if stiff:
            ring = self.driving[k]
        else:
            charge = ring_charge + self.push[k] + (share * ball_charge).sum(axis=-1)
            ring = charge * self.inverse_ring[k]
        return self.inverse[k] * ball_charge + share * np.expand_dims(ring, -1), ring


def _star(terms, capacitance, conductance, driving, beside, length):
    inner, outer = np.moveaxis(capacitance + conductance * length[:, None, None], 1, 0)
    inverse = _inverse(inner + outer)
    share = inner * inverse
    source = 0.0 if terms.stiff else terms.coupling + terms.conductance * length
    ring = (share * outer).sum(axis=1) + beside + source
    return _Star(share, inverse, _inverse(ring), source * driving, driving)


class _Network:
    """The solution as it grows."""

    def __init__(self, films, terms, limit):
        self.films, self.terms, self.limit = films, terms, limit
        n, z = len(films.time), len(films.balls)
        self.length = np.diff(films.time)
        self.values = films.capacitance, films.conductance, terms.driving, terms.capacitance
        start = _star(terms, *self.values, np.zeros(n))
        self.ends = start  # of charges alone
        self.ball = np.zeros(z)
        ring = start.inverse_ring[0]
        self.ring = terms.start / ring if ring else 0.0
        self.solution = Solution(
            *(np.zeros((n, z)), np.zeros(n), np.zeros((n, z)), np.zeros(n)),
            *(np.zeros((n, z)), np.zeros(n), np.zeros((n, 2, z)), np.zeros(n)),
            {},
        )

    def without_resistances(self):
        n, first, ahead = len(self.films.time), 0, FEW
        while first < n:
            part = slice(first, min(first + ahead, n))
            ball, ring = self.ends.at(part, self.ball, self.ring, self.terms.stiff)
            failed = self._failing(part, ball, ring)
            count = part.stop - first if failed is None else failed + 1
            self._keep(slice(first, first + count), ball[:count], ring[:count])
            if failed is None:
                ahead = min(2 * ahead, MANY)
            else:
                self._discharge(first + failed, ball[failed], ring[failed])
                ahead = FEW
            first += count

    def with_resistances(self):
        terms, by = self.terms, STAGE * self.length
        middles = [x[:-1] + STAGE * (x[1:] - x[:-1]) for x in self.values]
        ends = [x[1:] for x in self.values]
        stars = _star(terms, *middles, by), _star(terms, *ends, by)
        conductances = middles[1], ends[1]
        source = 0.0 if terms.stiff else terms.conductance
        ball, ring = self.ends.at(0, self.ball, self.ring, terms.stiff)
        self._point(0, ball, ring)
        for k, length in enumerate(self.length):
            ball_charge, ring_charge = self.ball, self.ring
            leaked, supplied = 0.0, 0.0
            for star, conductance, weight in zip(stars, conductances, (1 - STAGE, STAGE)):
                ball, ring = star.at(k, ball_charge, ring_charge, terms.stiff)
                flow = conductance[k] * (weight * length)
                through = np.stack([flow[0] * (ring - ball), flow[1] * ball])
                given = source * (weight * length) * (star.driving[k] - ring)
                leaked, supplied = leaked + through, supplied + given
                ball_charge = ball_charge + (through[0] - through[1])
                ring_charge = ring_charge + (given - through[0].sum())
            self.ball, self.ring = ball_charge, ring_charge
            self.solution.leaked[k + 1], self.solution.supplied[k + 1] = leaked, supplied
            self._point(k + 1, ball, ring)

    def _point(self, k, ball, ring):
        self._keep(k, ball, ring)
        if self._failing(slice(k, k + 1), ball[None], np.array([ring])) is not None:
            self._discharge(k, ball, ring)

    def _failing(self, part, ball, ring):
        """The first point of `part` at which a film fails, counted from its start; or None."""
        if self.limit is None:
            return None
        film = np.abs(np.stack([ring[:, None] - ball, ball], axis=1))
        failed = (film / self.limit[part] > 1).any(axis=(1, 2))
        return int(np.argmax(failed)) if failed.any() else None

    def _keep(self, part, ball, ring):
        s = self.solution
        s.ball_voltage[part] = s.ball_voltage_before[part] = ball
        s.bearing_voltage[part] = s.bearing_voltage_before[part] = ring
        s.ball_charge[part], s.ring_charge[part] = self.ball, self.ring

    def _discharge(self, k, ball, ring):
        terms, s = self.terms, self.solution
        node = Node(terms.capacitance[k], terms.coupling, terms.driving[k])
        found = discharge(
            self.films.capacitance[k], self.limit[k], node, self.ball, self.ring, (ball, ring)
        )
        s.discharges[k] = found
        self.ball, self.ring = found.ball_charge, found.ring_charge
        s.ball_voltage[k], s.bearing_voltage[k] = found.ball_voltage, found.bearing_voltage
        s.ball_charge[k], s.ring_charge[k] = self.ball, self.ring


class _Stiff:
    """The charges of an inner ring whose voltage is given: they follow from the voltages."""

    def __init__(self, films, terms):
        self.films, self.terms = films, terms

    def charged(self, solution):
        ring = solution.bearing_voltage
        inner = self.films.capacitance[:, 0] * (ring[:, None] - solution.ball_voltage)
        charge = inner.sum(axis=1) + self.terms.capacitance * ring
        supplied = np.diff(charge, prepend=0.0) + solution.leaked[:, 0].sum(axis=1)
        supplied[0] = 0.0
        return solution._replace(ring_charge=charge, supplied=supplied)


def _refuse_lost_charge(films, solution):
    charge = np.abs(solution.ball_charge)
    film = np.abs(films.capacitance * solution.bearing_voltage_before[:, None, None]).max()
    lost = ~films.capacitance.any(axis=1) & (charge > ROUNDING * film)
    if lost.any():
        point, ball = np.argwhere(lost)[0]
        raise RunError(
            f"ball {films.balls[ball]} has a charge of {solution.ball_charge[point, ball]:g} C and"
            f" no film at {films.time[point]:g} s: record capacitance_total, or give a stray"
            " capacitance"
        )


def _inverse(values):
    """1/values, 0 where they are 0."""
    return np.divide(1.0, values, out=np.zeros_like(values), where=values != 0)
