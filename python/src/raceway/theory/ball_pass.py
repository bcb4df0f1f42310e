# SPDX-License-Identifier: GPL-2.0-or-later
"""Positions of the balls over which results of statics are averaged. A ball pass brings the next
ball to the place of the one before it; the results at one position within it depend on where the
balls happen to be."""

from collections.abc import Callable
from typing import TypeVar

import numpy as np

from raceway.arrays import Floats

Solution = TypeVar("Solution")
ALIKE = 1e-3  # differences between the loads of balls, relative to the largest, that are ignored
FEW = 3  # loaded balls with one of them on the load line


def _number(loaded, balls):
    """Return the number of positions. If one or two balls carry the load, the results change
    sharply with their positions: the mean power loss then has an error of 4 % with four positions
    and of 1 % with twelve. If more balls are loaded, four positions have an error below 0.5 %, and
    two have it if all are."""
    if loaded == balls:
        return 2
    return 4 if loaded > FEW else 12


def places(balls: int, number: int) -> Floats:
    """Return `number` azimuths of the first ball in rad, evenly spaced over a ball pass."""
    return 2 * np.pi / balls * np.arange(number) / number


def over(
    solve: Callable[[float], Solution],
    balls: int,
    loads: Callable[[Solution], Floats],
    *,
    symmetric: bool = True,
) -> list[tuple[float, Solution]]:
    """Return [(share of the ball pass, solution)] for the positions that represent a ball pass, the
    first of which has a ball on the load line. `solve` returns the solution for an azimuth of the
    first ball in rad, and `loads` the loads of its inner contacts (Z,) or (grooves, Z).

    If the loads are `symmetric` to a plane through the load line and the axis, positions on both
    sides of it are alike and only one of them is solved. If all balls carry the same load, all
    positions are alike.

    >>> found = over(lambda phase: phase, 9, lambda _: np.array([5.0, 3.0, 1.0, 0.5, 0.1, 0.0]))
    >>> [(share, round(9 * phase / (2 * np.pi), 6)) for share, phase in found]
    [(0.25, 0.0), (0.5, 0.25), (0.25, 0.5)]
    """
    first = solve(0.0)
    each = np.atleast_2d(loads(first)).sum(0)
    if symmetric and np.ptp(each) <= ALIKE * each.max():
        return [(1.0, first)]
    number = _number(np.count_nonzero(each), each.size)
    phases = places(balls, number)[1:].tolist()
    if not symmetric:
        return [(1 / number, first), *((1 / number, solve(phase)) for phase in phases)]
    half = phases[: number // 2]
    shares = [*(2 / number for _ in half[:-1]), 1 / number]
    return [(1 / number, first), *((share, solve(phase)) for share, phase in zip(shares, half))]
