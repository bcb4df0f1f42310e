# SPDX-License-Identifier: GPL-2.0-or-later
"""Rotation of balls that touch only the outer ring. Rolling resistance slows them from the moment
they leave the load zone, traction is at most mu Q, and the ring accelerates them again when they
return (docs/tribology, Friction torque)."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from raceway.arrays import Floats

STEPS = 100
MEMORY = 100.0  # time after which the initial rotation has decayed, in units of 1/`rate`


class Unloaded(NamedTuple):
    """Unloaded balls of all rows, arrays (Z,); zero for loaded balls."""

    speed: Floats  # m/s, of the ball's centre
    since: Floats  # s, since the ball lost its load
    until: Floats  # s, unloaded time of the ball that regains its load next; 0 for other balls
    frequency: Floats  # 1/s, how often balls regain their load at this place


def unloaded(
    loaded: np.ndarray, azimuth: Floats, row: np.ndarray, orbit: float, pitch: float
) -> Unloaded:
    """`Unloaded` balls, `loaded` (Z,) or not, at `azimuth` (rad) in the rows with the numbers
    `row`, which move at `orbit` rad/s on the `pitch` radius (m). The load zone ends midway between
    balls. In a row without load, balls are never loaded."""
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
    """Rotation x (n,) of balls relative to pure rolling, `time` (s) after x = 1, by Heun's
    method: dx/dt = -`rate` `slowing(x)`, with `rate` in 1/s. `slowing` is the resistance minus the
    traction, both divided by the load. A ball rolls as long as traction suffices. An infinite time
    gives the steady-state rotation."""

    def change(x):
        excess = slowing(x)
        return -rate * np.where((x < 1) | (excess > 0), excess, 0.0)

    x, step = np.ones(np.shape(time)), np.minimum(time, MEMORY / np.maximum(rate, 1e-300)) / STEPS
    for _ in range(STEPS):
        first = change(x)
        ahead = np.clip(x + step * first, 0, 1)
        x = np.clip(x + step * (first + change(ahead)) / 2, 0, 1)
    return x
