# SPDX-License-Identifier: GPL-2.0-or-later
"""Differential slip of a ball in its groove (Heathcote): force along rolling and couple about the
axis of rolling, with Coulomb's law in closed form.

Across the groove the sliding speed is s(z) = (u/R_x) (y0 - z^2/(2 R_d)). At z = 0 it is `slip` (s
bar); with t0 = sqrt(slip/s_e) in [0, 1], there is no sliding at z = a t0. s is the speed of the
ball minus the speed of the ring along the ball's surface motion past the contact. Numbers or arrays
of one shape, SI.
"""

from typing import NamedTuple

import numpy as np

from raceway.arrays import Numbers
from raceway.core import laws

_FREE = laws.slip_constants()
FREE = float(_FREE.free_root)  # t0 at zero force, the root of t^3 - 3 t + 1
FREE_SPEED = float(_FREE.free_speed)  # mean |s| over the load at zero force, divided by s_e
LEAN = float(_FREE.free_lean)  # s_e dF/ds/(mu Q) at zero force
# m/s, lower limit of s_e: towards u = 0 the law is Coulomb's, smoothed over this speed
LEAST = 1e-4


class Slip(NamedTuple):
    """Forces and power of a contact's slip, arrays of one shape."""

    force: Numbers  # F, N: -F on the ball, +F on the ring, along rolling
    couple: Numbers  # C, N m: +C on the ball, -C on the ring, about w
    power: Numbers  # W, lost


def deformed_radius(groove: Numbers, ball: Numbers) -> Numbers:
    """R_d = 2 r_c R_b/(r_c + R_b), m: the curvature across the groove of the surface of contact."""
    return laws.deformed_radius(groove, ball)


def edge_slip(speed: Numbers, a: Numbers, r_d: Numbers, r_x: Numbers) -> Numbers:
    """s_e = |u| a^2/(2 R_d R_x), m/s: difference of the sliding speed between z = a and z = 0."""
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
    """`Slip` with Coulomb's law.

    F/(mu Q) = 3 t0 - t0^3 - 1, C/(mu Q a^2/(2 R_d)) = t0^3 - 0.6 t0^5 - 0.2, power F s - C u/R_x.
    These hold for u > 0. Above t0 = 1, force and couple are 1 and 0.2; for a slip below 0, -1 and
    -0.2. s_e is at least `LEAST`.
    """
    law = laws.differential_slip(_off(slip, speed, a, r_d, r_x))
    limit = friction * load
    force, couple = limit * law.force, limit * a**2 / (2 * r_d) * law.couple
    return Slip(force, couple, force * slip - couple * speed / r_x)


def free_slip(speed: Numbers, a: Numbers, r_d: Numbers, r_x: Numbers) -> Numbers:
    """Slip at z = 0 of free rolling, F = 0: 0.120615 s_e, m/s."""
    return FREE**2 * np.maximum(edge_slip(speed, a, r_d, r_x), LEAST)


def free_power(
    load: Numbers, friction: Numbers, speed: Numbers, a: Numbers, r_d: Numbers, r_x: Numbers
) -> Numbers:
    """Power of free rolling, 0.161142 mu Q s_e, W."""
    return FREE_SPEED * friction * load * edge_slip(speed, a, r_d, r_x)


def free_slope(
    load: Numbers, friction: Numbers, speed: Numbers, a: Numbers, r_d: Numbers, r_x: Numbers
) -> Numbers:
    """dF/d(slip) at free rolling, 3.80 mu Q/s_e, N s/m."""
    return LEAN * friction * load / np.maximum(edge_slip(speed, a, r_d, r_x), LEAST)


def creep(a: Numbers, r_d: Numbers, r_x: Numbers) -> Numbers:
    """v0/u = a^2/(7.60 R_d R_x), where v0 is the width of the smoothed Coulomb law F = mu Q s/v0
    that has the slope of free rolling."""
    return edge_slip(1.0, a, r_d, r_x) / LEAN


def secant(
    slip: Numbers,
    load: Numbers,
    friction: Numbers,
    speed: Numbers,
    a: Numbers,
    r_d: Numbers,
    r_x: Numbers,
) -> Numbers:
    """F divided by the deviation of the slip from free rolling, N s/m; in free rolling, the
    slope."""
    law = laws.differential_slip(_off(slip, speed, a, r_d, r_x))
    return friction * load * law.secant / np.maximum(edge_slip(speed, a, r_d, r_x), LEAST)


def in_series(
    force: Numbers, distance: Numbers, secant: Numbers, spring: Numbers, step: Numbers
) -> tuple[Numbers, Numbers]:
    """(force in N after `step` in s, its slope k_t tau (1 - e^(-step/tau)) in N s/m).

    The slip law with the tangential spring k_t in N/m in series: tau = c/k_t, c = `secant` in N
    s/m; `distance` from free rolling in m/s, constant over the step. The result tends to the slip
    law for long steps and to a spring for short ones, and sticks at rest.
    """
    tau = secant / spring
    gone = -np.expm1(-step / tau)
    return force + (secant * distance - force) * gone, spring * tau * gone


def _off(slip, speed, a, r_d, r_x):
    """Difference of the slip from free rolling, relative to the slip at the edge."""
    return slip / np.maximum(edge_slip(speed, a, r_d, r_x), LEAST) - FREE**2
