# SPDX-License-Identifier: GPL-2.0-or-later
"""Write raceway grooves as triangle meshes (ASCII STL) for the stock LIGGGHTS scene in peers.py."""

import numpy as np
from raceway.theory.bearing import INNER


def triangles(bearing, side, around, across, half_angle):
    """Return the corners, shape (T, 3, 3), in m, of the triangles that form a groove about the z
    axis.

    There are `around` facets along the ring and `across` facets across the groove, which extends
    `half_angle` rad to either side of its bottom. Each facet consists of two triangles.
    """
    turn = 2 * np.pi * np.arange(around) / around
    angle = np.linspace(-half_angle, half_angle, across + 1)
    groove, outward = bearing.groove(side), -1 if side == INNER else 1
    radius = bearing.groove_circle(side) + outward * groove * np.cos(angle)
    here = np.stack(
        [
            np.outer(np.cos(turn), radius),
            np.outer(np.sin(turn), radius),
            np.tile(groove * np.sin(angle), (around, 1)),
        ],
        2,
    )
    there = np.roll(here, -1, 0)
    a, b, c, d = here[:, :-1], there[:, :-1], there[:, 1:], here[:, 1:]
    return np.concatenate([np.stack(t, 2).reshape(-1, 3, 3) for t in ([a, b, c], [a, c, d])])


def write(path, corners):
    """Write triangles, given as corners of shape (T, 3, 3) in m, to a file."""
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normal /= np.linalg.norm(normal, axis=1)[:, None]
    with open(path, "w") as file:
        file.write("solid groove\n")
        for n, t in zip(normal, corners):
            vertices = "".join(f"vertex {x:.12g} {y:.12g} {z:.12g}\n" for x, y, z in t)
            file.write(
                f"facet normal {n[0]:.9g} {n[1]:.9g} {n[2]:.9g}\nouter"
                f" loop\n{vertices}endloop\nendfacet\n"
            )
        file.write("endsolid groove\n")
