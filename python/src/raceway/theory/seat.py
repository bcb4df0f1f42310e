# SPDX-License-Identifier: GPL-2.0-or-later
"""Where a ball settles between an inner and an outer groove, in the plane through the bearing's
axis (Jones 1960).

Coordinates are (radial, axial) in m; raceways are counted `INNER`, `OUTER`; Z balls at once. Each
contact is a spring by its `contact_law` whose energy is convex in the ball's place, and so is their
sum with the centrifugal load.
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from raceway.arrays import Floats
from raceway.errors import NoEquilibrium
from raceway.theory import circle, hertz
from raceway.theory.bearing import INNER, OUTER
from raceway.theory.contact_law import Law
from raceway.theory.small_motion import Linear


class Grooves(NamedTuple):
    """What surrounds the balls."""

    inner: Callable[[Floats], circle.Reach]  # balls (Z, 2) -> circle of the inner groove's centres
    outer: Floats  # (Z, 2), m: centres of curvature of the outer groove
    gap: Floats  # (2,), m: r_c - R_b
    stiffness: Floats  # (2, Z), N/m^1.5
    centrifugal: float  # N, outwards on every ball
    law: Law  # of overlaps (2, Z)


class Touch(NamedTuple):
    """The contacts of balls somewhere."""

    distance: Floats  # (2, Z), m, ball to centre of curvature
    direction: Floats  # (2, Z, 2), from ball to raceway
    load: Floats  # (2, Z), N
    along: Floats  # (2, Z), N/m: stiffness of each contact along its line
    energy: Floats  # (2, Z), J
    elastic: Floats  # (2, Z), m: compression of the steel
    reach: circle.Reach  # of the inner groove


def touch(grooves: Grooves, ball: Floats) -> Touch:
    """`Touch` of balls (Z, 2)."""
    reach, arm = grooves.inner(ball), ball - grooves.outer
    length = np.linalg.norm(arm, axis=-1)
    distance = np.stack([reach.distance, length])
    direction = np.stack([reach.slope[:, :2], arm / np.maximum(length, 1e-300)[:, None]])
    found = grooves.law(distance - grooves.gap[:, None])
    return Touch(distance, direction, *found, reach)


def energy(grooves: Grooves, ball: Floats) -> Floats:
    """Energy (Z,) in J of both springs, less the centrifugal load's work."""
    return _stored(grooves, touch(grooves, ball), ball)


def _stored(grooves, touch, ball):
    work = grooves.centrifugal * (ball[:, 0] - grooves.outer[:, 0])
    return touch.energy.sum(0) - work


def gradient(grooves: Grooves, touch: Touch) -> Floats:
    """Derivative (Z, 2) of the energy, N: minus the force on each ball."""
    result = (touch.load[..., None] * touch.direction).sum(0)
    result[:, 0] -= grooves.centrifugal
    return result


def inner_hessian(grooves: Grooves, touch: Touch) -> Floats:
    """Second derivative (Z, 7, 7) of the inner contacts' energy, N/m, in ball and ring: see
    `circle`."""
    slope, curve = touch.reach.slope, touch.reach.curve
    line = slope[:, :, None] * slope[:, None, :]
    return touch.along[INNER, :, None, None] * line + touch.load[INNER, :, None, None] * curve


def outer_hessian(grooves: Grooves, touch: Touch) -> Floats:
    """Second derivative (Z, 2, 2) of the outer contacts' energy, N/m: the spring along its line of
    action, Q/s across."""
    direction = touch.direction[OUTER]
    line = direction[:, :, None] * direction[:, None, :]
    across = touch.load[OUTER] / np.maximum(touch.distance[OUTER], 1e-300)
    return touch.along[OUTER, :, None, None] * line + across[:, None, None] * (np.eye(2) - line)


def linear(grooves: Grooves, touch: Touch) -> Linear:
    """`Linear` of all balls."""
    whole = inner_hessian(grooves, touch)
    whole[:, :2, :2] += outer_hessian(grooves, touch)
    approach = np.zeros((2, *whole.shape[:2]))
    approach[INNER], approach[OUTER, :, :2] = touch.reach.slope, touch.direction[OUTER]
    return Linear(whole, approach, touch.along, touch.load[INNER] > 0)


def settle(grooves: Grooves) -> Floats:
    """Places (Z, 2) where every ball is in balance. Raises `NoEquilibrium` should Newton's method
    not find one."""
    outer, gap, stiffness, centrifugal = (
        grooves.outer,
        grooves.gap,
        grooves.stiffness,
        grooves.centrifugal,
    )
    seen = grooves.inner(outer)
    # to the inner centre, exact where the circle lies in the plane
    line = -seen.distance[:, None] * seen.slope[:, :2]
    squeeze, play = (
        np.maximum(seen.distance - gap.sum(), 0),
        np.minimum(seen.distance - gap.sum(), 0),
    )
    # of the inner contact: equal and opposite loads on one line; a ball with play is in the middle
    share = squeeze / (1 + (stiffness[INNER] / stiffness[OUTER]) ** (2 / 3)) + play / 2
    between = outer + line * (1 - (gap[INNER] + share) / seen.distance)[:, None]
    thrown = outer.copy()
    thrown[:, 0] += gap[OUTER] + (centrifugal / stiffness[OUTER]) ** (2 / 3)
    ball = np.where((squeeze > 0)[:, None] | (centrifugal == 0), between, thrown)
    scale = centrifugal + hertz.load(stiffness[OUTER], squeeze)
    longest = 0.25 * gap.sum()  # of a step: small against the groove
    # keeps a ball that has lost a groove, or both, movable
    floor = (1e-9 * scale.max() + 1e-30) / longest * np.eye(2)
    digits = 8 * np.spacing(outer[:, 0])
    for _ in range(200):
        now = touch(grooves, ball)
        slope = gradient(grooves, now)
        size = np.linalg.norm(slope, axis=-1)
        # distances are known to some last digits of the circle's radius; also where a contact has
        # just closed
        rounding = 1.5 * (stiffness * np.sqrt(now.elastic + digits)).sum(0) * digits
        left = size > 1e-12 * scale + rounding
        if not left.any():
            break
        curvature = inner_hessian(grooves, now)[:, :2, :2] + outer_hessian(grooves, now)
        step = -np.linalg.solve(curvature + floor, slope[..., None])[..., 0]
        step *= np.minimum(1, longest / np.maximum(np.linalg.norm(step, axis=-1), 1e-300))[:, None]
        step[~left] = 0.0  # rounding would hold up the others
        moved = ball + _part(grooves, ball, step, slope, now)[:, None] * step
        if np.array_equal(moved, ball):
            break
        ball = moved
    excess = size - 1e-7 * np.maximum(scale, 1e-6 * scale.max()) - rounding
    if np.any(excess > 0):
        raise NoEquilibrium(f"ball {int(np.argmax(excess))} finds no balance between its raceways")
    return ball


def _part(grooves, ball, step, slope, now):
    """How much (Z,) of each ball's step to take from the `Touch` now: halved until the energy, or
    the force left, comes down."""
    here, descent, size = (
        _stored(grooves, now, ball),
        (slope * step).sum(-1),
        np.linalg.norm(slope, axis=-1),
    )
    part = np.ones(len(ball))
    for _ in range(40):
        trial = ball + part[:, None] * step
        there = touch(grooves, trial)
        better = _stored(grooves, there, trial) <= here + 1e-4 * part * descent
        better |= np.linalg.norm(gradient(grooves, there), axis=-1) < 0.5 * size
        if np.all(better):
            break
        part = np.where(better, part, part / 2)
    return part
