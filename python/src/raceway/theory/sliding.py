# SPDX-License-Identifier: GPL-2.0-or-later
"""Differential slip of a ball in its groove (Heathcote): force along rolling and couple about the
axis of rolling, in closed form for Coulomb's law.

The sliding speed varies across the groove as s(z) = (u/R_x) (y0 - z^2/(2 R_d)). At z = 0 it is
`slip` (s bar). With t0 = sqrt(slip/s_e) in [0, 1], there is no sliding at z = a t0. s is the speed
of the ball minus the speed of the ring, in the direction in which the ball's surface moves past the
contact. Functions accept numbers or arrays of equal shape in SI units.
"""

from typing import NamedTuple

import numpy as np

from raceway.arrays import Numbers
from raceway.core import laws

_FREE = laws.slip_constants()
FREE = float(_FREE.free_root)  # t0 at zero force, the root of t^3 - 3 t + 1
FREE_SPEED = float(_FREE.free_speed)  # load-weighted mean of |s| at zero force, divided by s_e
LEAN = float(_FREE.free_lean)  # s_e dF/ds/(mu Q) at zero force
# m/s, lower limit of s_e; as u tends to 0, Coulomb's law is smoothed over this speed
LEAST = 1e-4


class Slip(NamedTuple):
    """Forces and power due to the slip in a contact, in arrays of equal shape."""

    force: Numbers  # F along rolling in N; -F acts on the ball and +F on the ring
    couple: Numbers  # C about w in N m; +C acts on the ball and -C on the ring
    power: Numbers  # W, power dissipated by slip


def deformed_radius(groove: Numbers, ball: Numbers) -> Numbers:
    """Return R_d = 2 r_c R_b/(r_c + R_b) in m, the radius of the contact surface across the
    groove."""
    return laws.deformed_radius(groove, ball)


def edge_slip(speed: Numbers, a: Numbers, r_d: Numbers, r_x: Numbers) -> Numbers:
    """Return s_e = |u| a^2/(2 R_d R_x) in m/s, the difference in sliding speed between z = a and z
    = 0."""
    return laws.edge_slip(speed, a, r_d, r_x)


def heathcote(
    slip: Numbers,
    load: Numbers,
    friction: Numbers,
    speed: Numbers,
    a: Numbers,
    r_d: Numbers,
    r_x: Numbers,
) -> Slip:
    """Compute the `Slip` with Coulomb's law.

    F/(mu Q) = 3 t0 - t0^3 - 1, C/(mu Q a^2/(2 R_d)) = t0^3 - 0.6 t0^5 - 0.2, and the power is F s -
    C u/R_x. These formulas are valid for u > 0. For t0 above 1, the two ratios are 1 and 0.2; for a
    slip below 0, they are -1 and -0.2. s_e is at least `LEAST`.
    """
    law = laws.differential_slip(_off(slip, speed, a, r_d, r_x))
    limit = friction * load
    force, couple = limit * law.force, limit * a**2 / (2 * r_d) * law.couple
    return Slip(force, couple, force * slip - couple * speed / r_x)


def free_slip(speed: Numbers, a: Numbers, r_d: Numbers, r_x: Numbers) -> Numbers:
    """Return the slip 0.120615 s_e in m/s at z = 0 in free rolling, i.e. at F = 0."""
    return FREE**2 * np.maximum(edge_slip(speed, a, r_d, r_x), LEAST)


def free_power(
    load: Numbers, friction: Numbers, speed: Numbers, a: Numbers, r_d: Numbers, r_x: Numbers
) -> Numbers:
    """Return the power dissipated in free rolling, 0.161142 mu Q s_e, in W."""
    return FREE_SPEED * friction * load * edge_slip(speed, a, r_d, r_x)


def secant(
    slip: Numbers,
    load: Numbers,
    friction: Numbers,
    speed: Numbers,
    a: Numbers,
    r_d: Numbers,
    r_x: Numbers,
) -> Numbers:
    """Return F divided by the deviation of the slip from free rolling in N s/m; in free rolling,
    this is the slope."""
    law = laws.differential_slip(_off(slip, speed, a, r_d, r_x))
    return friction * load * law.secant / np.maximum(edge_slip(speed, a, r_d, r_x), LEAST)


def _off(slip, speed, a, r_d, r_x):
    """Return the deviation of the slip from free rolling, divided by s_e."""
    return slip / np.maximum(edge_slip(speed, a, r_d, r_x), LEAST) - FREE**2
