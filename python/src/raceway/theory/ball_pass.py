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
PIECES = 4  # number of pieces into which `refined` first divides a ball pass
TOLERANCE = 0.01  # largest error in a piece that `refined` does not halve, as a fraction of a value
NARROWEST = 2.0**-14  # width of a piece, as a fraction of a ball pass, that is never halved


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


def refined(
    solve: Callable[[float], Solution],
    balls: int,
    loads: Callable[[Solution], Floats],
    values: Callable[[Solution], Floats],
    *,
    symmetric: bool = True,
) -> list[tuple[float, Solution]]:
    """Return [(share of the ball pass, solution)] for positions that are close enough together for
    the mean and the extremes of the `values` (N,) of a solution. The other arguments are those of
    `over`.

    Where a ball touches or leaves the raceway, stiffness changes with the square root of the
    distance from that position, so evenly spaced positions miss its extreme. The ball pass is
    therefore halved until, in each piece, the value in the middle differs by at most `TOLERANCE`
    from the mean of those at its ends. If a ball touches or leaves the raceway in the piece, all
    three values must agree within it. The shares follow from Simpson's rule.

    >>> touch = lambda phase: np.sqrt(np.maximum(9 * phase / (2 * np.pi) - 0.123, 0.0))
    >>> one = lambda phase: np.array([touch(phase)])
    >>> found = refined(lambda phase: phase, 9, one, lambda phase: 1 - one(phase), symmetric=False)
    >>> mean = sum(share * touch(phase) for share, phase in found)
    >>> f"{len(found)} positions, error of the mean {mean / (2 / 3 * 0.877**1.5) - 1:.0e}"
    '33 positions, error of the mean -2e-05'
    """
    spacing = 2 * np.pi / balls
    kept: dict[float, tuple[Solution, Floats, Floats]] = {}  # {part of the ball pass: results}

    def at(part):
        if part not in kept:
            found = solve(part * spacing)
            kept[part] = found, np.asarray(loads(found)) > 0, np.asarray(values(found))
        return kept[part]

    whole = 0.5 if symmetric else 1.0
    first = np.linspace(0.0, whole, round(PIECES * whole) + 1).tolist()
    within = TOLERANCE * np.max([np.abs(at(part)[2]) for part in first], axis=0)
    shares: dict[float, float] = {}
    pieces = list(zip(first, first[1:]))
    while pieces:
        left, right = pieces.pop()
        parts = left, (left + right) / 2, right
        _, touching, each = zip(*map(at, parts))
        steady = all(np.array_equal(touching[0], other) for other in touching[1:])
        off = np.abs(each[1] - (each[0] + each[2]) / 2) if steady else np.ptp(each, axis=0)
        if right - left > NARROWEST and np.any(off > within):
            pieces += zip(parts, parts[1:])
            continue
        for part, weight in zip(parts, (1, 4, 1)):
            shares[part] = shares.get(part, 0.0) + weight / 6 * (right - left) / whole
    return [(shares[part], kept[part][0]) for part in sorted(shares)]
