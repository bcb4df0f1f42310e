# SPDX-License-Identifier: GPL-2.0-or-later
"""Rotation of balls that touch only the outer ring. Rolling resistance slows them down from the
moment they leave the load zone, with a traction of at most mu Q, and the ring accelerates them
again when they return to the load zone (docs/tribology, Friction torque)."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from raceway.arrays import Floats

STEPS = 100  # time steps of Heun's method
MEMORY = 100.0  # time after which the initial rotation has decayed, in multiples of 1/`rate`


class Unloaded(NamedTuple):
    """State of the unloaded balls in all rows, as arrays (Z,) that are zero for loaded balls."""

    speed: Floats  # m/s, speed of the ball centre
    since: Floats  # s, time since the ball lost its load
    until: Floats  # s, unloaded time of the ball that regains its load next; 0 for other balls
    frequency: Floats  # 1/s, rate at which balls regain their load at this position


def unloaded(
    loaded: np.ndarray, azimuth: Floats, row: np.ndarray, orbit: float, pitch: float
) -> Unloaded:
    """Return the state of the `Unloaded` balls. `loaded` (Z,) marks the loaded balls, `azimuth` is
    in rad, and `row` contains the row numbers; the balls orbit at `orbit` rad/s on a circle of
    radius `pitch` (m). The load zone is assumed to end midway between two balls. In a row without
    load, balls are never loaded."""
    found = Unloaded(*np.zeros((4, len(loaded))))
    found.speed[~loaded] = abs(orbit) * pitch
    for one in np.unique(row):
        (balls,) = np.nonzero(row == one)
        balls = balls[
            np.argsort(-np.sign(orbit) * azimuth[balls])
        ]  # each ball followed by the ball behind it
        step, held = 2 * np.pi / len(balls) / abs(orbit), loaded[balls]
        if not held.any():
            found.since[balls] = np.inf
            continue
        for place in np.flatnonzero(~held):
            behind = int(np.argmax(np.roll(held, -place)))
            found.since[balls[place]] = (behind - 0.5) * step
            if held[place - 1]:
                found.until[balls[place]] = behind * step
                found.frequency[balls[place]] = 1 / step
    return found


def rotation(slowing: Callable[[Floats], Floats], rate: Floats, time: Floats) -> Floats:
    """Return the rotation x (n,) of balls relative to pure rolling, at `time` (s) after x = 1. The
    equation dx/dt = -`rate` `slowing(x)`, with `rate` in 1/s, is integrated with Heun's method.
    `slowing` is the resistance minus the traction, both divided by the load. A ball rolls as long
    as the traction is sufficient. An infinite time gives the rotation in the steady state."""

    def change(x):
        excess = slowing(x)
        return -rate * np.where((x < 1) | (excess > 0), excess, 0.0)

    x, step = np.ones(np.shape(time)), np.minimum(time, MEMORY / np.maximum(rate, 1e-300)) / STEPS
    for _ in range(STEPS):
        first = change(x)
        ahead = np.clip(x + step * first, 0, 1)
        x = np.clip(x + step * (first + change(ahead)) / 2, 0, 1)
    return x
