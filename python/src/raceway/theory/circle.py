# SPDX-License-Identifier: GPL-2.0-or-later
"""How far balls are from the circle of an inner ring's groove centres, and how that changes.

The ring's place is (x, y, z, t_x, t_y): displacement of its centre in m and tilt about the two axes
across in rad. Tilt turns the ring's axis to e = (sin t_y, -sin t_x, ...), so t_x and t_y are what
`fix bearing/ring` reports. A ball's place is (radial, axial) in m in the plane through the outer
ring's axis at the ball's azimuth. Derivatives are taken in these seven: ball first, then ring.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from raceway.arrays import Floats


class Reach(NamedTuple):
    """Distances of Z balls from the circle, along the line of the contact."""

    distance: Floats  # (Z,), m
    slope: Floats  # (Z, 7), first derivatives
    curve: Floats  # (Z, 7, 7), second derivatives
    # (Z, 2), unit vector from circle to ball in the ring's own section (radial, axial)
    section: Floats
    line: Floats  # (Z, 3), the same in space: also the force's direction on the ring
    arm: Floats  # (Z, 3), m, from the ring's centre to a point on that line


def straight(ball: Floats, place: Floats, azimuth: Floats, radius: float) -> Reach:
    """`Reach` after Jones and Harris: the circle's point at `azimuth` moves by the components of
    the ring's displacement and tilt in the ball's plane (Harris, ch. 7), as if the circle were
    straight over the shift.
    """
    c, s, zero, one = (
        np.cos(azimuth),
        np.sin(azimuth),
        np.zeros_like(azimuth),
        np.ones_like(azimuth),
    )
    moves = -np.array(
        [[c, s, zero, zero, zero], [zero, zero, one, radius * s, -radius * c]]
    ).transpose(2, 0, 1)
    way = ball + moves @ place - [radius, 0.0]
    both = np.concatenate([np.broadcast_to(np.eye(2), (len(c), 2, 2)), moves], axis=2)
    distance = np.maximum(np.linalg.norm(way, axis=1), 1e-300)
    unit = way / distance[:, None]
    across = (np.eye(2) - unit[:, :, None] * unit[:, None, :]) / distance[:, None, None]
    line = np.stack([unit[:, 0] * c, unit[:, 0] * s, unit[:, 1]], 1)
    arm = radius * np.stack([c, s, zero], 1)
    return Reach(
        distance,
        np.einsum("zi,zia->za", unit, both),
        np.einsum("zia,zij,zjb->zab", both, across, both),
        unit,
        line,
        arm,
    )


def exact(ball: Floats, place: Floats, azimuth: Floats, radius: float) -> Reach:
    """`Reach` of a circle that stays a circle, shifted and tilted, to its nearest point in
    space."""
    c, s, zero = np.cos(azimuth), np.sin(azimuth), np.zeros_like(azimuth)
    axis, turn, bend = _axis(*place[3:])
    d = np.stack([ball[:, 0] * c, ball[:, 0] * s, ball[:, 1]], 1) - place[:3]
    d1 = np.zeros((len(c), 3, 7))
    d1[:, :, 0], d1[:, 2, 1] = np.stack([c, s, zero], 1), 1.0
    d1[:, :, 2:5] = -np.eye(3)
    e1 = np.zeros((3, 7))
    e1[:, 5:] = turn

    height = d @ axis
    height1 = np.einsum("zia,i->za", d1, axis) + d @ e1
    mixed = np.einsum("zia,ib->zab", d1, e1)
    height2 = mixed + mixed.transpose(0, 2, 1)
    height2[:, 5:, 5:] += np.einsum("zi,iab->zab", d, bend)

    r = np.linalg.norm(d - height[:, None] * axis, axis=1)
    r1 = (np.einsum("zi,zia->za", d, d1) - height[:, None] * height1) / r[:, None]
    r2 = (
        np.einsum("zia,zib->zab", d1, d1)
        - _outer(height1)
        - height[:, None, None] * height2
        - _outer(r1)
    ) / r[:, None, None]

    distance = np.maximum(np.hypot(r - radius, height), 1e-300)
    unit = np.stack([r - radius, height], 1) / distance[:, None]
    slope = unit[:, :1] * r1 + unit[:, 1:] * height1
    curve = (
        (_outer(r1) + _outer(height1) - _outer(slope)) / distance[:, None, None]
        + unit[:, :1, None] * r2
        + unit[:, 1:, None] * height2
    )
    line = unit[:, :1] * (d - height[:, None] * axis) / r[:, None] + unit[:, 1:] * axis
    return Reach(distance, slope, curve, unit, line, d)


def conjugate(moment: ArrayLike, tilt: Floats) -> Floats:
    """The part (2,) of a moment (2,) or (3,) in N m, fixed in space, that works on the tilts (2,),
    rad. Its component along the ring's axis works on none: the drive of the ring takes it."""
    axis, turn, _ = _axis(*tilt)
    return np.append(moment, 0.0)[:3] @ np.cross(axis, turn.T).T


def _axis(t_x, t_y):
    """The ring's axis (3,) and its first (3, 2) and second (3, 2, 2) derivatives in the tilts."""
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
    return a[:, :, None] * a[:, None, :]
