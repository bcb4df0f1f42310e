# SPDX-License-Identifier: GPL-2.0-or-later
"""Spin of a contact about its normal: Coulomb's moment in closed form, and spin combined with slip
in slices of the contact ellipse."""

from typing import NamedTuple

import numpy as np

from raceway.arrays import Floats, Numbers
from raceway.core import laws
from raceway.theory import sliding


class Spin(NamedTuple):
    """Forces and moment that resist slip and spin, in arrays of the same shape as the slip and the
    spin."""

    along: Numbers  # N, opposes the slip along rolling
    across: Numbers  # N, opposes the slip across the groove
    moment: Numbers  # N m, opposes the spin
    power: Numbers  # W, power dissipated by slip and spin


def moment(load: Numbers, friction: Numbers, a: Numbers, second: Numbers) -> Numbers:
    """Return the moment of pure spin under Coulomb's law, (3/8) mu Q a E in N m. a is the semi-axis
    across the groove in m, and `second` is the complete elliptic integral E (`hertz.Ellipse`)."""
    return laws.pure_spin_couple(friction * load, a, second)


def closed_slip(speed: Numbers, edge: Numbers) -> Numbers:
    """Return the factor by which spin reduces the couple of differential slip, for `speed` = omega
    a and `edge` = s_e in m/s (`sliding.edge_slip`)."""
    return laws.spin_shares(np.abs(speed), np.maximum(edge, sliding.LEAST), 0.0).slip


def with_slip(
    load: Numbers,
    friction: Numbers,
    a: Numbers,
    b: Numbers,
    along: Numbers,
    across: Numbers,
    spin: Numbers,
    *,
    curve: Numbers = 0.0,
    least: float = sliding.LEAST,
) -> Spin:
    """Compute the `Spin` of contacts with the given sliding speeds at their centre in m/s and a
    spin in rad/s, using the same slices as a run with `spin_law` "slices" (docs/tribology, Slip and
    spin in slices).

    At (x along, z across) the sliding velocity is (along + spin z - curve z^2, across - spin x),
    where `curve` = u/(2 R_d R_x) in 1/(m s) represents differential slip. Below a sliding speed of
    `least` (m/s), friction is proportional to the speed.
    """
    speed, edge = spin * a, curve * np.square(a)
    found = laws.slip_slices(along, across, -speed, edge, b / a, least)
    moment = -found.moment
    lost = found.along * along + found.across * across + moment * speed + found.couple * edge
    limit = friction * load
    return Spin(limit * found.along, limit * found.across, limit * a * moment, limit * lost)


def free_slip(
    load: Numbers, friction: Numbers, a: Numbers, b: Numbers, spin: Floats, curve: Numbers
) -> Spin:
    """Apply `with_slip` to contacts that spin at `spin` rad/s, (n,), and slide along rolling such
    that no force remains in that direction. The slip, which is between 0 and its value for
    differential slip alone, is found by 20 bisections."""
    low, high = np.zeros_like(spin), np.full_like(spin, curve * a**2)
    for _ in range(20):
        middle = (low + high) / 2
        pushed = with_slip(load, friction, a, b, middle, 0.0, spin, curve=curve).along > 0
        low, high = np.where(pushed, low, middle), np.where(pushed, middle, high)
    return with_slip(load, friction, a, b, (low + high) / 2, 0.0, spin, curve=curve)
