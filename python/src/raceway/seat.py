# SPDX-License-Identifier: GPL-2.0-or-later
"""Where a ball settles between an inner and an outer groove, in the plane through the bearing's axis (Jones 1960).

Coordinates are (radial, axial) in m; raceways are counted `INNER`, `OUTER`; Z balls at once. Each contact is a
spring Q = K overlap^1.5 whose energy is convex in the ball's place, and so is their sum with the centrifugal load.
"""

from typing import NamedTuple

import numpy as np

from raceway import hertz
from raceway.bearing import INNER, OUTER
from raceway.errors import NoEquilibrium


class Grooves(NamedTuple):
    """What surrounds the balls."""

    centres: np.ndarray  # (2, Z, 2), m: centres of curvature
    gap: np.ndarray  # (2,), m: r_c - R_b
    stiffness: np.ndarray  # (2, Z), N/m^1.5
    centrifugal: float  # N, outwards on every ball


class Touch(NamedTuple):
    """The contacts of balls somewhere."""

    distance: np.ndarray  # (2, Z), m, ball to centre of curvature
    direction: np.ndarray  # (2, Z, 2), from ball to raceway
    load: np.ndarray  # (2, Z), N


def touch(grooves, ball):
    """`Touch` of balls (Z, 2)."""
    arm = ball - grooves.centres
    distance = np.linalg.norm(arm, axis=-1)
    direction = arm / np.maximum(distance, 1e-300)[..., None]
    return Touch(distance, direction, hertz.load(grooves.stiffness, distance - grooves.gap[:, None]))


def energy(grooves, ball):
    """Energy (Z,) in J: 2/5 Q overlap of each spring, less the centrifugal load's work."""
    distance, _, load = touch(grooves, ball)
    squeeze = np.maximum(distance - grooves.gap[:, None], 0)
    return 0.4 * (load * squeeze).sum(0) - grooves.centrifugal * (ball[:, 0] - grooves.centres[OUTER, :, 0])


def gradient(grooves, ball):
    """Derivative (Z, 2) of the energy, N: minus the force on each ball."""
    _, direction, load = touch(grooves, ball)
    result = (load[..., None] * direction).sum(0)
    result[:, 0] -= grooves.centrifugal
    return result


def hessian(grooves, touch):
    """Second derivative (2, Z, 2, 2) of each contact's energy, N/m: the spring along its line of action, Q/s across."""
    squeeze = np.maximum(touch.distance - grooves.gap[:, None], 0)
    along = 1.5 * grooves.stiffness * np.sqrt(squeeze)
    across = touch.load / np.maximum(touch.distance, 1e-300)
    line = touch.direction[..., :, None] * touch.direction[..., None, :]
    return along[..., None, None] * line + across[..., None, None] * (np.eye(2) - line)


def settle(grooves):
    """Places (Z, 2) where every ball is in balance. Raises `NoEquilibrium` should Newton's method not find one."""
    centres, gap, stiffness, centrifugal = grooves
    line = centres[INNER] - centres[OUTER]
    length = np.linalg.norm(line, axis=-1)
    squeeze = np.maximum(length - gap.sum(), 0)
    share = squeeze / (1 + (stiffness[INNER] / stiffness[OUTER]) ** (2 / 3))  # of the inner contact
    between = centres[INNER] - line / np.maximum(length, 1e-300)[:, None] * (gap[INNER] + share)[:, None]
    if centrifugal == 0:
        return between  # equal and opposite forces on one line: exact
    thrown = centres[OUTER].copy()
    thrown[:, 0] += gap[OUTER] + (centrifugal / stiffness[OUTER]) ** (2 / 3)
    ball = np.where((squeeze > 0)[:, None], between, thrown)
    scale = centrifugal + hertz.load(stiffness[OUTER], squeeze)
    longest = 0.25 * gap.sum()  # of a step: small against the groove
    floor = 1e-9 * centrifugal / longest * np.eye(2)  # keeps a ball that has lost both grooves movable
    for _ in range(200):
        slope = gradient(grooves, ball)
        size = np.linalg.norm(slope, axis=-1)
        if np.all(size <= 1e-12 * scale):
            break
        curvature = hessian(grooves, touch(grooves, ball)).sum(0)
        step = -np.linalg.solve(curvature + floor, slope[..., None])[..., 0]
        step *= np.minimum(1, longest / np.maximum(np.linalg.norm(step, axis=-1), 1e-300))[:, None]
        moved = ball + _part(grooves, ball, step, slope)[:, None] * step
        if np.array_equal(moved, ball):
            break
        ball = moved
    if np.any(size > 1e-7 * scale):
        raise NoEquilibrium(f"ball {int(np.argmax(size / scale))} finds no balance between its raceways")
    return ball


def _part(grooves, ball, step, slope):
    """How much (Z,) of each ball's step to take: halved until the energy, or the force left, comes down."""
    here, descent, size = energy(grooves, ball), (slope * step).sum(-1), np.linalg.norm(slope, axis=-1)
    part = np.ones(len(ball))
    for _ in range(40):
        trial = ball + part[:, None] * step
        better = energy(grooves, trial) <= here + 1e-4 * part * descent
        better |= np.linalg.norm(gradient(grooves, trial), axis=-1) < 0.5 * size
        if np.all(better):
            break
        part = np.where(better, part, part / 2)
    return part
