# SPDX-License-Identifier: GPL-2.0-or-later
"""Slip and spin of a contact under Coulomb's law, integrated over the ellipse by Gauss points."""

from typing import NamedTuple

import numpy as np


class Spin(NamedTuple):
    """Forces (N), moment (N m) and power (W) returned by `with_slip`."""

    along: np.ndarray
    across: np.ndarray
    moment: np.ndarray
    power: np.ndarray


def with_slip(load, friction, a, b, along, across, spin, *, curve=0.0, width=0.0, points=24):
    """Return a `Spin` for a contact in which the point (x along, z across) slides with the velocity
    (along + spin z - curve z^2, across - spin x).

    The stress is mu p in the direction of the sliding velocity v, smoothed as v/sqrt(v^2 + width^2)
    with `width` in m/s. There are `points` Gauss-Legendre radii and four times as many equally
    spaced angles.
    """
    along, across, spin = np.broadcast_arrays(
        *(np.asarray(v, float) for v in (along, across, spin))
    )
    node, weight = np.polynomial.legendre.leggauss(points)
    # the substitution r = sin(t) removes the square root from the pressure
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


def free_slip(load, friction, a, b, spin, curve, *, points=16):
    """Return `with_slip` for `spin` (n,), at the slip along rolling for which the force is zero.
    Stresses are smoothed over 1e-3 of the slip at the edge."""
    edge = curve * a**2
    low, high = np.zeros_like(spin), np.full_like(spin, edge)
    options = dict(curve=curve, width=1e-3 * edge, points=points)
    for _ in range(20):
        middle = (low + high) / 2
        pushed = with_slip(load, friction, a, b, middle, 0.0, spin, **options).along > 0
        low, high = np.where(pushed, low, middle), np.where(pushed, middle, high)
    return with_slip(load, friction, a, b, (low + high) / 2, 0.0, spin, **options)
