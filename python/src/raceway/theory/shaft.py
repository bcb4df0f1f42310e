# SPDX-License-Identifier: GPL-2.0-or-later
"""A shaft at rest on several ball bearings: its displacements, and the bearings' loads and tilts.

The shaft is a beam (`beam`), and each bearing is solved with the full statics in five degrees of
freedom (`static`). The equilibrium of all nodes

    K q + sum of bearing forces(q) = loads

is found by Newton iteration with the stiffness matrices of the bearings. A bearing with clearance
carries no load at first, so soft springs to the ground are added and then removed in steps.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from raceway.arrays import Floats, short
from raceway.errors import NoEquilibrium
from raceway.theory import beam, static
from raceway.theory.beam import FREEDOMS, Disc, Section, Steel
from raceway.theory.bearing import Bearing
from raceway.theory.steel import STEEL

HELP = (1e8, 1e6, 1e4, 1e2, 0.0)  # N/m, stiffnesses of the soft springs in successive steps
LEAST = 1.0  # N/m, added to the stiffness in a Newton step, for directions in which nothing holds
STEPS = 200  # largest number of Newton iterations per stiffness
EXACT = 1e-9  # largest residual of the force balance beyond rounding, relative to the loads


@dataclass(frozen=True)
class Seat:
    """A bearing on the shaft, with its outer ring in the housing."""

    at: float  # m, position of the plane of the balls along the shaft
    bearing: Bearing
    clearance: float = 0.0  # m, diametral clearance
    # (5,), m and rad: displacement x, y, z, rx, ry of the outer ring from its nominal position
    offset: tuple[float, ...] = (0.0,) * FREEDOMS
    # True if the outer ring slides along z; the spring is then the only axial load
    floating: bool = False
    # N, force along z of a soft spring on the outer ring; it slides unless this is 0
    spring: float = 0.0
    phase: float = 0.0  # rad, azimuth of the first ball
    ball_density: float = STEEL.density  # kg/m^3

    @property
    def slides(self) -> bool:
        """True if the outer ring slides along z."""
        return self.floating or self.spring != 0.0


@dataclass(frozen=True)
class Load:
    """Force and moment at one position on the shaft."""

    at: float  # m
    force: tuple[float, float, float] = (0.0, 0.0, 0.0)  # N
    moment: tuple[float, float] = (0.0, 0.0)  # N m, about x and y


@dataclass(frozen=True)
class Shaft:
    """Sections starting at z = 0, their material, gravity, and the discs on the shaft."""

    sections: Sequence[Section]
    steel: Steel = field(default_factory=Steel)
    gravity: tuple[float, float, float] = (0.0, 0.0, 0.0)  # m/s^2
    discs: Sequence[Disc] = ()


@dataclass(frozen=True)
class Carried:
    """State of a bearing on a shaft at rest."""

    seat: Seat
    place: Floats  # (5,), m and rad, position of the inner ring relative to the outer ring
    load: Floats  # (5,), N and N m, load exerted by the shaft on the inner ring
    state: static.Equilibrium
    stiffness: Floats  # (5, 5), stiffness of the bearing as it acts on the shaft

    __repr__ = short


@dataclass(frozen=True)
class Rest:
    """Equilibrium of a shaft."""

    z: Floats  # (N,), m, positions of the nodes
    place: Floats  # (N, 5), m and rad, displacements of the nodes
    bearings: list[Carried]
    residual: float  # residual of the force balance, relative to the loads

    __repr__ = short


def rest(
    shaft: Shaft,
    seats: Sequence[Seat],
    loads: Sequence[Load],
    *,
    speed: float = 0.0,
) -> Rest:
    """Find the equilibrium of `shaft` on `seats` under `loads`. If a shaft `speed` in rad/s is
    given, the centrifugal loads of the balls are included.

    Raises `ValueError` for a position off the shaft, and `NoEquilibrium` if the bearings cannot
    support the loads.

    >>> from raceway.theory.bearing import Bearing
    >>> b = Bearing(9, 12.6e-3, 24.0e-3, 36.6e-3, 6.552e-3, 6.552e-3)
    >>> stiff = Shaft([Section(0.4, 0.2)])
    >>> seats = [Seat(0.1, b), Seat(0.4, b, floating=True)]
    >>> found = rest(stiff, seats, [Load(0.2, (0.0, -3000.0, 0.0))])
    >>> [round(float(one.load[1])) for one in found.bearings]
    [-2000, -1000]
    """
    places = [one.at for kind in (seats, loads, shaft.discs) for one in kind]
    z, pieces = beam.divided(shaft.sections, places)
    node = {place: int(np.argmin(np.abs(z - place))) for place in places}
    stiffness = beam.stiffness(pieces, shaft.steel)
    given = beam.weight(pieces, np.array(shaft.gravity), shaft.steel)
    for disc in shaft.discs:
        at = FREEDOMS * node[disc.at]
        given[at : at + 3] += disc.mass * np.array(shaft.gravity)
    for load in loads:
        at = FREEDOMS * node[load.at]
        given[at : at + FREEDOMS] += [*load.force, *load.moment]
    if not seats or not (np.any(given) or any(one.spring for one in seats)):
        raise NoEquilibrium("a shaft at rest needs bearings and a load")
    holders = [_Holder(seat, FREEDOMS * node[seat.at], speed) for seat in seats]
    place = np.zeros(len(given))
    for soft in HELP:
        place, left, exact = _newton(stiffness, given, holders, place, soft)
    if not exact:
        raise NoEquilibrium(
            f"the bearings do not hold the shaft: a fraction {left:.1e} of the load remains"
        )
    return Rest(z, place.reshape(-1, FREEDOMS), [one.carried(place) for one in holders], left)


class _Holder:
    """Forces of a bearing on the shaft. If the bearing slides along z, they include the axial force
    of its spring."""

    def __init__(self, seat, first, speed):
        self.seat, self.at = seat, slice(first, first + FREEDOMS)
        gamma = seat.bearing.ball_radius / seat.bearing.pitch_radius
        self.ball = dict(orbital_speed=speed * (1 - gamma) / 2, ball_density=seat.ball_density)

    def state(self, place, checked=True):
        relative = place[self.at] - self.seat.offset
        held = dict(zip(static.FREEDOMS, relative))
        if self.seat.slides:
            del held["z"]
        return static.equilibrium(
            self.seat.bearing,
            axial_load=-self.seat.spring,
            held=held,
            clearance=self.seat.clearance,
            phase=self.seat.phase,
            # without a spring, an outer ring that no ball carries may be anywhere along z
            loose=not self.seat.spring,
            checked=checked,
            **self.ball,
        )

    def respond(self, place):
        """Return (force (5,), stiffness (5, 5)) acting on the shaft."""
        state = self.state(place, checked=False)
        force = np.array([*state.force, *state.moment[:2]])
        stiffness = state.stiffness
        if self.seat.slides:
            others = [0, 1, 3, 4]
            force[2] = self.seat.spring
            full, stiffness = stiffness, np.zeros_like(stiffness)
            inner = full[np.ix_(others, others)]
            if full[2, 2] > 0:
                inner = inner - np.outer(full[others, 2], full[2, others]) / full[2, 2]
            stiffness[np.ix_(others, others)] = inner
        return force, stiffness

    def carried(self, place):
        state, relative = self.state(place), place[self.at] - self.seat.offset
        if self.seat.slides:
            relative = np.array([*relative[:2], state.shift[2], *relative[3:]])
        force = -np.array([*state.force, *state.moment[:2]])
        if self.seat.slides:
            force[2] = -self.seat.spring
        return Carried(self.seat, relative, force, state, self.respond(place)[1])


def _newton(stiffness, given, holders, place, soft):
    """Return the position, the residual of the force balance relative to the loads, and whether it
    is `EXACT` but for rounding, for springs of stiffness `soft` (N/m) to the ground."""
    lengths = np.tile([1.0, 1.0, 1.0, 0.1, 0.1], len(given) // FREEDOMS)  # m per unit coordinate
    size = max(np.abs(given / lengths).max(), *(abs(one.seat.spring) for one in holders), 0.0)

    def balance(at):
        left, slope = given - stiffness @ at - soft * lengths**2 * at, stiffness.copy()
        slope[np.diag_indices_from(slope)] += soft * lengths**2
        for one in holders:
            force, own = one.respond(at)
            left[one.at] += force
            slope[one.at, one.at] += own
        return left, slope

    def over(left, at):
        """Residual (N,) beyond the rounding error of a beam, whose short pieces are very stiff."""
        rounding = 4 * np.finfo(float).eps * (np.abs(stiffness) @ np.abs(at))
        return np.abs(left / lengths) - rounding / lengths

    left, slope = balance(place)
    for _ in range(STEPS):
        if np.all(over(left, place) <= 0.1 * EXACT * size):
            break
        step = np.linalg.solve(slope + np.diag(LEAST * lengths**2), left)
        # for constant contact angles the energy is convex, so shorten the step until it decreases
        share, start = min(1.0, 50e-6 / np.abs(step * lengths).max()), left @ step
        while share > 1e-6:
            try:
                further, bend = balance(place + share * step)
            except NoEquilibrium:  # a ball finds no position between its raceways
                further = None
            if further is not None and abs(further @ step) <= abs(start):
                break
            share *= 0.5
        else:
            break
        place, left, slope = place + share * step, further, bend
    exact = np.all(over(left, place) <= EXACT * size)
    return place, float(np.abs(left / lengths).max() / size), exact
