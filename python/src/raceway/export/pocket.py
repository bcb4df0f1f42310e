# SPDX-License-Identifier: GPL-2.0-or-later
"""Mesh of the pockets of a one-piece cage; each pocket is a cylinder in the radial direction."""

import numpy as np

from raceway.arrays import Floats, Integers
from raceway.theory.bearing import Bearing

HEIGHT = 0.35  # radial height of a pocket divided by the ball diameter
AROUND = 24  # number of cells around a pocket


def mesh(bearing: Bearing, play: float) -> tuple[Floats, Integers]:
    """Return the points, shape (n, 3), in m, and the quads, shape (k, 4), as point indices, of the
    walls of all pockets with the given `play` (m). The cage is at the origin with its axis along z,
    and the normals point towards the balls.

    Each pocket has 2 `AROUND` points, of which those nearer to the axis come first. The first
    pocket is at azimuth 0.
    """
    hole, angle = bearing.ball_radius + play / 2, 2 * np.pi * np.arange(AROUND) / AROUND
    radius = bearing.pitch_radius + HEIGHT * bearing.ball_diameter * np.array([-0.5, 0.5])
    along, across = hole * np.cos(angle), hole * np.sin(angle)
    turn = 2 * np.pi * np.arange(bearing.balls) / bearing.balls
    c, s = np.cos(turn)[:, None, None], np.sin(turn)[:, None, None]
    r, t = radius[None, :, None], along[None, None, :]
    x, y = c * r - s * t, s * r + c * t
    points = np.stack([x, y, np.broadcast_to(across, x.shape)], -1)
    here = np.arange(AROUND)
    there = (here + 1) % AROUND
    one = np.stack([here, here + AROUND, there + AROUND, there], -1)
    quads = one + 2 * AROUND * np.arange(bearing.balls)[:, None, None]
    return points.reshape(-1, 3), quads.reshape(-1, 4)
