# SPDX-License-Identifier: GPL-2.0-or-later
"""Meshes of the raceways as parts of tori; each groove ends at shoulders with a height of one fifth
of the ball diameter."""

import numpy as np

from raceway.arrays import Floats, Integers
from raceway.theory.bearing import INNER, Bearing

SHOULDER = 0.2  # height of a shoulder divided by the ball diameter
AROUND, ACROSS = 96, 9  # number of cells around the ring, and of points across the groove


def mesh(bearing: Bearing, raceway: int, clearance: float = 0.0) -> tuple[Floats, Integers]:
    """Return the points, shape (n, 3), in m, and the quads, shape (k, 4), as point indices, of a
    groove that is centred at the origin with its axis along z. The normals point towards the balls.

    The points form `AROUND` rows of `ACROSS` points each; all points in a row have the same
    azimuth.
    """
    groove, sign = bearing.groove(raceway), 1 if raceway == INNER else -1
    bottom = bearing.inner_radius if raceway == INNER else bearing.outer_radius + clearance / 2
    half = np.arccos(max(1 - SHOULDER * bearing.ball_diameter / groove, 0.0))
    angle, azimuth = np.linspace(-half, half, ACROSS), np.arange(AROUND) * 2 * np.pi / AROUND
    radius, z = bottom + sign * groove * (1 - np.cos(angle)), groove * np.sin(angle)
    points = np.stack(
        [
            np.outer(np.cos(azimuth), radius),
            np.outer(np.sin(azimuth), radius),
            np.tile(z, (AROUND, 1)),
        ],
        axis=-1,
    )
    row, column = np.meshgrid(np.arange(AROUND), np.arange(ACROSS - 1), indexing="ij")
    here, there = row * ACROSS + column, (row + 1) % AROUND * ACROSS + column
    quads = np.stack([here, there, there + 1, here + 1], axis=-1).reshape(-1, 4)
    return points.reshape(-1, 3), quads if raceway == INNER else quads[:, ::-1]
