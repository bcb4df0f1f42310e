# SPDX-License-Identifier: GPL-2.0-or-later
"""The pockets of a one-piece cage as a mesh: each is a cylinder along the radius."""

import numpy as np

from raceway.arrays import Floats, Integers
from raceway.theory.bearing import Bearing

HEIGHT = 0.35  # radial height of a pocket divided by the ball's diameter
AROUND = 24  # cells around a pocket


def mesh(bearing: Bearing, play: float) -> tuple[Floats, Integers]:
    """(points (n, 3) in m, quads (m, 4) of point numbers) of the walls of all pockets with this
    `play` (m) in a cage at the origin with axis z; normals point towards the balls.

    Each pocket has 2 `AROUND` points, those nearer to the axis first. The first pocket is at
    azimuth 0.
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
