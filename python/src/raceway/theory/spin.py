# SPDX-License-Identifier: GPL-2.0-or-later
"""Spin of a contact about its normal: Coulomb's moment in closed form, spin with slip from Gauss
points over the contact ellipse."""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from raceway.arrays import Floats, Numbers
from raceway.core import laws
from raceway.theory import sliding


class Spin(NamedTuple):
    """Resisting force and moment, arrays of the shape of the given slip and spin."""

    along: Numbers  # N, opposing the slip along rolling
    across: Numbers  # N, opposing the slip across
    moment: Numbers  # N m, against the spin
    power: Numbers  # W, lost


def moment(load: Numbers, friction: Numbers, a: Numbers, second: Numbers) -> Numbers:
    """(3/8) mu Q a E in N m: pure spin under Coulomb's law. a the semi-axis across the groove in m,
    `second` the ellipse's complete integral E (`hertz.Ellipse`)."""
    return laws.pure_spin_couple(friction * load, a, second)


def closed_moment(pure: Numbers, speed: Numbers, edge: Numbers) -> Numbers:
    """Moment in N m against spin in the presence of differential slip, a fit: `pure` of pure spin
    (N m), reduced if the `speed` omega a is small compared with `edge` s_e, both in m/s
    (`sliding.edge_slip`)."""
    width = np.maximum(edge, sliding.LEAST)
    return pure * laws.spin_shares(np.abs(speed), width, 0.0).spin


def closed_slip(speed: Numbers, edge: Numbers) -> Numbers:
    """Factor by which spin reduces the couple of differential slip; arguments as in
    `closed_moment`."""
    return laws.spin_shares(np.abs(speed), np.maximum(edge, sliding.LEAST), 0.0).slip


def with_slip(
    load: float,
    friction: float,
    a: float,
    b: float,
    along: ArrayLike,
    across: ArrayLike,
    spin: ArrayLike,
    *,
    curve: float = 0.0,
    width: float = 0.0,
    points: int = 24,
) -> Spin:
    """`Spin` of a contact with sliding speeds at its centre in m/s and a spin in rad/s.

    At (x along, z across) the sliding is (along + spin z - curve z^2, across - spin x), with
    `curve` = u/(2 R_d R_x) of differential slip, 1/(m s). Stress mu p along the sliding v, smoothed
    as v/sqrt(v^2 + width^2) with `width` in m/s. Gauss-Legendre in the radius with `points` points,
    and four times as many equidistant angles.
    """
    along, across, spin = np.broadcast_arrays(
        *(np.asarray(v, float) for v in (along, across, spin))
    )
    node, weight = np.polynomial.legendre.leggauss(points)
    # r = sin(t) removes the square root of the pressure
    t = (node + 1) * np.pi / 4
    radius, angle = np.sin(t)[:, None], (np.arange(4 * points) + 0.5) * np.pi / (2 * points)
    share = weight * np.pi / 4 * np.cos(t) ** 2 * np.sin(t) * 1.5 / np.pi * np.pi / (2 * points)
    share = np.broadcast_to(share[:, None], (points, 4 * points))
    x, z = b * radius * np.cos(angle), a * radius * np.sin(angle)
    end = (..., None, None)
    v_x = along[end] + spin[end] * z - curve * z**2
    v_z = across[end] - spin[end] * x
    size = np.sqrt(v_x**2 + v_z**2 + width**2)
    size = np.where(size > 0, size, 1.0)
    force = friction * load * share / size
    parts = force * v_x, force * v_z, force * (z * v_x - x * v_z), force * (v_x**2 + v_z**2)
    return Spin(*(part.sum((-2, -1))[()] for part in parts))


def free_slip(
    load: float,
    friction: float,
    a: float,
    b: float,
    spin: Floats,
    curve: float,
    *,
    points: int = 16,
) -> Spin:
    """`with_slip` of contacts that spin at `spin` rad/s, (n,), and slide along rolling such that
    no force remains there, between the slip of differential slip alone and zero. 20 bisections;
    stresses smoothed over 1e-3 of the slip at the edge."""
    edge = curve * a**2
    low, high = np.zeros_like(spin), np.full_like(spin, edge)
    options = dict(curve=curve, width=1e-3 * edge, points=points)
    for _ in range(20):
        middle = (low + high) / 2
        pushed = with_slip(load, friction, a, b, middle, 0.0, spin, **options).along > 0
        low, high = np.where(pushed, low, middle), np.where(pushed, middle, high)
    return with_slip(load, friction, a, b, (low + high) / 2, 0.0, spin, **options)
