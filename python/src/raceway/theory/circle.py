# SPDX-License-Identifier: GPL-2.0-or-later
"""Distances of balls from the circles of groove centres of an inner ring, with their derivatives.

The ring's position is (x, y, z, t_x, t_y), i.e. the displacement of its centre in m and the tilt
about the two transverse axes in rad. Tilt rotates the ring's axis to e = (sin t_y, -sin t_x, ...),
so that t_x and t_y are the values reported by `fix bearing/ring`. A ball's position is (radial,
axial) in m in the plane through the outer ring's axis at the ball's azimuth. Derivatives are taken
with respect to these seven coordinates, first those of the ball, then those of the ring. In shapes
of arrays, ... stands for the shape to which `azimuth` and `height`, the axial positions of the
circles, are broadcast.
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from raceway.arrays import Floats, Numbers


class Reach(NamedTuple):
    """Distances of balls from circles, along the lines of action of the contacts."""

    distance: Floats  # (...), m
    slope: Floats  # (..., 7), first derivatives of the distance
    # maps n to the second derivatives (..., n, n) with respect to the first n coordinates
    curve: Callable[[int], Floats]
    # (..., 2), unit vector from the circle to the ball, in the axial section of the inner ring
    section: Floats
    line: Floats  # (..., 3), the same vector in space, i.e. the direction of the force on the ring
    arm: Floats  # (..., 3), m, from the ring's centre to a point on the line of action


def straight(
    ball: Floats, place: Floats, azimuth: Floats, radius: float, height: Numbers = 0.0
) -> Reach:
    """Return the `Reach` according to Jones and Harris: the point of the circle at `azimuth` moves
    by the components of the ring's displacement and tilt in the plane of the ball (Harris, ch. 7),
    as if the circle were locally straight. `height` in m is the axial position of the circle
    relative to the ring's centre.
    """
    c, s, h = np.broadcast_arrays(np.cos(azimuth), np.sin(azimuth), height)
    both = np.zeros((*h.shape, 2, 7))
    both[..., 0, 0] = both[..., 1, 1] = 1.0
    both[..., 0, 2], both[..., 0, 3], both[..., 0, 5], both[..., 0, 6] = -c, -s, h * s, -h * c
    both[..., 1, 4], both[..., 1, 5], both[..., 1, 6] = -1.0, -radius * s, radius * c
    way = ball + both[..., 2:] @ place
    way[..., 0] -= radius
    way[..., 1] -= h
    distance = np.maximum(np.linalg.norm(way, axis=-1), 1e-300)
    unit = way / distance[..., None]

    def curve(n):
        across = (np.eye(2) - _outer(unit)) / distance[..., None, None]
        return across if n == 2 else both[..., :n].swapaxes(-1, -2) @ across @ both[..., :n]

    line = np.stack([unit[..., 0] * c, unit[..., 0] * s, unit[..., 1]], -1)
    return Reach(
        distance,
        (unit[..., None, :] @ both)[..., 0, :],
        curve,
        unit,
        line,
        np.stack([radius * c, radius * s, h], -1),
    )


def exact(
    ball: Floats, place: Floats, azimuth: Floats, radius: float, height: Numbers = 0.0
) -> Reach:
    """Return the `Reach` to the nearest point in space of a circle that is shifted and tilted but
    remains a circle; `height` is as in `straight`."""
    c, s, over = np.broadcast_arrays(np.cos(azimuth), np.sin(azimuth), height)
    axis, turn, bend = _axis(*place[3:])
    at = np.broadcast_to(ball, (*c.shape, 2))
    d = np.stack([at[..., 0] * c, at[..., 0] * s, at[..., 1]], -1) - place[:3]
    d1 = np.zeros((*c.shape, 3, 7))
    d1[..., 0, 0], d1[..., 1, 0], d1[..., 2, 1] = c, s, 1.0
    d1[..., 2:5] = -np.eye(3)
    e1 = np.zeros((3, 7))
    e1[:, 5:] = turn

    height0 = d @ axis
    height1 = np.einsum("...ia,i->...a", d1, axis) + d @ e1
    mixed = np.einsum("...ia,ib->...ab", d1, e1)
    height2 = mixed + mixed.swapaxes(-1, -2)
    height2[..., 5:, 5:] += np.einsum("...i,iab->...ab", d, bend)

    across = d - height0[..., None] * axis
    r = np.linalg.norm(across, axis=-1)
    r1 = (np.einsum("...i,...ia->...a", d, d1) - height0[..., None] * height1) / r[..., None]
    r2 = (
        d1.swapaxes(-1, -2) @ d1 - _outer(height1) - height0[..., None, None] * height2 - _outer(r1)
    ) / r[..., None, None]

    off = height0 - over
    distance = np.maximum(np.hypot(r - radius, off), 1e-300)
    unit = np.stack([r - radius, off], -1) / distance[..., None]
    slope = unit[..., :1] * r1 + unit[..., 1:] * height1
    curve = (
        (_outer(r1) + _outer(height1) - _outer(slope)) / distance[..., None, None]
        + unit[..., :1, None] * r2
        + unit[..., 1:, None] * height2
    )
    line = unit[..., :1] * across / r[..., None] + unit[..., 1:] * axis
    return Reach(distance, slope, lambda n: curve[..., :n, :n], unit, line, d)


def conjugate(moment: ArrayLike, tilt: Floats) -> Floats:
    """Return the components (2,) of a moment (2,) or (3,) in N m, fixed in space, that do work on
    the tilts (2,) in rad. The component along the ring's axis does no work, because the drive of
    the ring takes it up."""
    axis, turn, _ = _axis(*tilt)
    return np.append(moment, 0.0)[:3] @ np.cross(axis, turn.T).T


def _axis(t_x, t_y):
    """Return the ring's axis (3,) and its first (3, 2) and second (3, 2, 2) derivatives with
    respect to the tilts."""
    x, y, dx, dy = np.sin(t_y), -np.sin(t_x), np.cos(t_y), -np.cos(t_x)  # dx by t_y, dy by t_x
    z = np.sqrt(1 - x * x - y * y)
    first = np.array([[0.0, dx], [dy, 0.0], [-y * dy / z, -x * dx / z]])
    second = np.zeros((3, 2, 2))
    second[0, 1, 1], second[1, 0, 0] = -x, -y
    second[2, 0, 0] = -(dy * dy - y * y) / z - first[2, 0] ** 2 / z
    second[2, 1, 1] = -(dx * dx - x * x) / z - first[2, 1] ** 2 / z
    second[2, 0, 1] = second[2, 1, 0] = -first[2, 0] * first[2, 1] / z
    return np.array([x, y, z]), first, second


def _outer(a):
    return a[..., :, None] * a[..., None, :]
