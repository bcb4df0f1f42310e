# SPDX-License-Identifier: GPL-2.0-or-later
"""Passage of a ball over a spall that spans the groove: time of impact, and length of the spall.

A ball that keeps its load hits half-way across, where the falling flank of its path meets the
rising flank (`kinematics.spall_length`). A ball that loses its load flies farther and hits the
rising flank later. The model consists of two masses along the load line: the ball between two Hertz
contacts, and the ring on a spring that represents the other balls. The path over the spall is the
path of a rigid ball over two edges (docs/theory, Flaws of a raceway). The spall lies on the load
line, and the ball does not reach its bottom. Film, friction and the compliance of the outer ring's
support are neglected.
"""

from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike

from raceway.arrays import Floats
from raceway.theory import hertz, kinematics, static
from raceway.theory.bearing import INNER, OUTER, Bearing
from raceway.theory.steel import STEEL

STEP = 0.2  # time step times the ball's angular frequency between its raceways
LONGEST = 0.4  # longest spall, as a fraction of the ball spacing
LENGTHS = 80  # number of points in the table that `length` uses


def seconds_to_blow(
    bearing: Bearing,
    raceway: int,
    lengths: ArrayLike,
    speed: float,
    load: float,
    ring_mass: float,
    *,
    heard: int | None = None,
    edge: float = 0.0,
    clearance: float = 0.0,
    ball_density: float = STEEL.density,
) -> Floats:
    """Return the times (N,) in s from entry to impact for spalls of `lengths` (N,) in m on a
    `raceway` (`INNER` or `OUTER`).

    `speed` is the inner ring speed in rad/s, and `load` is the radial load in N. `ring_mass` is the
    mass in kg of the inner ring and the parts that move with it, which the load accelerates towards
    the ball. `clearance` is diametral in m, and `ball_density` is in kg/m^3. `heard` is the raceway
    of the ring that carries the sensor, by default the raceway with the spall; for the other
    raceway, the impact occurs only when the ball has flown back to it. `edge` is the radius of the
    spall's edges in m: a ball that keeps its load begins to rise at this distance before the
    middle. Raises `ValueError` if a length or the mass is not positive, if the edge exceeds half of
    a length, or if a length exceeds 0.4 of the spacing of two balls, and `NoEquilibrium` if the
    bearing cannot carry the load without that ball.

    In a 6208 at 1500 rpm and 2 kN, a ball keeps its load over 1 mm, but not over 2 mm:

    >>> paper = Bearing(9, 12.6e-3, 24.0e-3, 36.6e-3, 6.552e-3, 6.552e-3)
    >>> speed = 1500 * np.pi / 30
    >>> late = seconds_to_blow(paper, OUTER, [1e-3, 2e-3], speed, 2000.0, 0.2)
    >>> print((late / ([0.5e-3, 1e-3] / kinematics.entrainment(paper, speed))).round(1))
    [1.  1.1]
    """
    w = np.atleast_1d(np.asarray(lengths, float))
    if not (np.all(w > 0) and ring_mass > 0):
        raise ValueError(f"lengths {lengths} m and ring_mass {ring_mass} kg must be positive")
    if not 0 <= edge <= 0.5 * w.min():
        raise ValueError(
            f"edge {edge:g} m must be from 0 to half the shortest length, {0.5 * w.min():g} m"
        )
    if w.max() > longest(bearing, raceway):
        raise ValueError(
            f"length {w.max():g} m must be at most {longest(bearing, raceway):g} m, {LONGEST} of"
            " the spacing of two balls"
        )
    entrained = float(kinematics.entrainment(bearing, speed))
    orbit = speed * float(kinematics.frequencies(bearing).cage)
    full = static.equilibrium(bearing, load, clearance=clearance, orbital_speed=orbit)
    without = static.equilibrium(
        replace(bearing, balls=int(bearing.balls) - 1),
        load,
        clearance=clearance,
        orbital_speed=orbit,
        phase=full.azimuth[1:],
    )
    carried = full.inner.load[0]
    # stiffness of the other balls, from the difference between the bearing with this ball and
    # without it
    ring_spring = carried / (without.shift[0] - full.shift[0])
    mass = 4 / 3 * np.pi * bearing.ball_radius**3 * ball_density
    centrifugal = mass * bearing.pitch_radius * orbit**2
    rest = (full.inner.overlap[0], full.outer.overlap[0])
    radii = [bearing.effective_radii(side, 0.0, clearance) for side in (INNER, OUTER)]
    modulus = bearing.effective_modulus
    K = [hertz.stiffness(hertz.exact(*radii[side]), modulus) for side in (INNER, OUTER)]
    rolling = radii[raceway][0]
    stiff = 1.5 * sum(K[side] * np.sqrt(rest[side]) for side in (INNER, OUTER))
    step = STEP / np.sqrt(stiff / mass)
    heard = raceway if heard is None else heard

    ring, ring_v, ball, ball_v = (np.zeros(len(w)) for _ in range(4))  # m outwards, m/s
    lost, struck = np.zeros(len(w), bool), np.zeros(len(w), bool)
    turns = 0.5 * w - edge  # m from the entry to the point where the path begins to rise
    blow = turns / entrained  # s, time of impact of a ball that keeps its load
    found = np.zeros(len(w), bool)

    def loads(time):
        drop = _drop(entrained * time, w, edge, rolling)
        overlap = [rest[INNER] + ring - ball, rest[OUTER] + ball]
        overlap[raceway] = overlap[raceway] - drop
        return [hertz.load(K[side], overlap[side]) for side in (INNER, OUTER)]

    inner, outer = loads(0.0)
    for n in range(1, int(np.ceil(w.max() / entrained / step)) + 1):
        ring_v += 0.5 * step / ring_mass * (carried - inner - ring_spring * ring)
        ball_v += 0.5 * step / mass * (inner - outer + centrifugal)
        ring += step * ring_v
        ball += step * ball_v
        inner, outer = both = loads(n * step)
        ring_v += 0.5 * step / ring_mass * (carried - inner - ring_spring * ring)
        ball_v += 0.5 * step / mass * (inner - outer + centrifugal)
        struck |= lost & (both[raceway] > 0)
        new = struck & ~found & (both[heard] > 0)
        blow[new] = n * step
        found |= new
        lost |= (both[raceway] == 0) & (entrained * n * step < turns)
    return blow


def length(
    bearing: Bearing,
    raceway: int,
    seconds: ArrayLike,
    speed: float,
    load: float,
    ring_mass: float,
    *,
    heard: int | None = None,
    edge: float = 0.0,
    clearance: float = 0.0,
    ball_density: float = STEEL.density,
) -> Floats:
    """Return the lengths in m along rolling of spalls for which the times from entry to impact are
    `seconds` (any shape), for a ball that may lose its load. This is the inverse of
    `seconds_to_blow`, with the same arguments.

    The result is NaN for times that match no spall up to `longest`. If the ball reaches the bottom
    of a shallow spall, it hits there, and the length cannot be determined.

    >>> paper = Bearing(9, 12.6e-3, 24.0e-3, 36.6e-3, 6.552e-3, 6.552e-3)
    >>> case = dict(speed=1500 * np.pi / 30, load=2000.0, ring_mass=0.2)
    >>> time = seconds_to_blow(paper, INNER, [1e-3, 2e-3], **case)
    >>> print((1e3 * length(paper, INNER, time, **case)).round(2))
    [1. 2.]
    """
    table = np.linspace(2 * edge, longest(bearing, raceway), LENGTHS + 1)
    more = {"heard": heard, "edge": edge, "clearance": clearance, "ball_density": ball_density}
    times = seconds_to_blow(bearing, raceway, table[1:], speed, load, ring_mass, **more)
    times = np.maximum.accumulate(np.concatenate([[0.0], times]))
    wanted = np.asarray(seconds, float)
    return np.where(wanted > 0, np.interp(wanted, times, table, right=np.nan), np.nan)


def _drop(on, w, edge, rolling):
    """Return the drop (m) of a rigid ball at `on` m after the entry."""
    half, curve = 0.5 * w, rolling + edge
    off = np.minimum(np.abs(on - half), half)  # m, distance from the middle
    flank = (half - off) ** 2 / (2 * curve)
    if edge == 0:
        return flank
    steepest = (half - edge) / curve
    return np.where(off > edge, flank, 0.5 * steepest * (half - off**2 / edge))


def longest(bearing: Bearing, raceway: int) -> float:
    """Return the length (m) of the longest spall on a `raceway` that is supported, which is 0.4 of
    the spacing of two balls."""
    radius = bearing.inner_radius if raceway == INNER else bearing.outer_radius
    return LONGEST * 2 * np.pi * radius / bearing.balls
