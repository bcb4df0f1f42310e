# SPDX-License-Identifier: GPL-2.0-or-later
"""Stribeck-Harris distribution of a radial load over the balls at zero contact angle (eq A.1).

The load is treated as continuously distributed; in a real bearing it varies about these values as
the balls pass.
"""

import numpy as np
from scipy.integrate import quad
from scipy.optimize import brentq

from raceway.arrays import Numbers
from raceway.theory import hertz
from raceway.theory.bearing import INNER, OUTER, Bearing


def relative_load(azimuth: Numbers, parameter: float) -> Numbers:
    """Return Q(psi)/Q_max = [1 - (1 - cos psi)/(2 epsilon)]^1.5, or zero outside the load zone (eq
    A.1).

    `azimuth` is psi in rad, measured from the load line; `parameter` is epsilon > 0.
    """
    if not parameter > 0:
        raise ValueError(f"load parameter = {parameter} must be positive")
    return np.maximum(1 - (1 - np.cos(azimuth)) / (2 * parameter), 0) ** 1.5


def radial_integral(parameter: float) -> float:
    """Return J_r(epsilon), which is 1/(2 pi) times the integral of Q/Q_max cos psi over the load
    zone (Harris 7.24)."""
    if parameter >= 1:
        value, _ = quad(
            lambda psi: relative_load(psi, parameter) * np.cos(psi), 0, np.pi, epsrel=1e-11
        )
        return value / np.pi

    def smooth(t):  # sin(psi/2) = sqrt(epsilon) sin(t) removes the root at the edge of the zone
        part = parameter * np.sin(t) ** 2
        return np.cos(t) ** 4 * (1 - 2 * part) / np.sqrt(1 - part)

    value, _ = quad(smooth, 0, np.pi / 2, epsrel=1e-11)
    return 2 * np.sqrt(parameter) * value / np.pi


def largest_load(balls: int, radial_load: float, parameter: float) -> float:
    """Return Q_max = F_r/(Z J_r) in N (Stribeck).

    >>> print(f"{largest_load(9, 5000.0, 0.5):.1f}")  # no clearance
    2427.8
    """
    return radial_load / (balls * radial_integral(parameter))


def series_stiffness(bearing: Bearing) -> float:
    """Return the stiffness K in N/m^1.5 of the inner and the outer contact of one ball in series,
    at zero contact angle (Harris 7.5)."""
    inner, outer = (
        hertz.stiffness(hertz.exact(*bearing.effective_radii(side)), bearing.effective_modulus)
        for side in (INNER, OUTER)
    )
    return (inner ** (-2 / 3) + outer ** (-2 / 3)) ** -1.5


def shift(bearing: Bearing, radial_load: float, clearance: float = 0.0) -> float:
    """Return the radial shift delta_r in m under `radial_load` > 0 N, which is the solution of F_r
    = Z K (delta_r - P_d/2)^1.5 J_r(epsilon)."""
    if not radial_load > 0:
        raise ValueError(f"radial load = {radial_load} N must be positive")
    stiffness = bearing.balls * series_stiffness(bearing)

    def excess(delta):
        squeeze = delta - clearance / 2
        return stiffness * squeeze**1.5 * radial_integral(squeeze / (2 * delta)) - radial_load

    scale = (radial_load / stiffness) ** (2 / 3)
    low = max(clearance / 2, 0.0) + 1e-9 * scale
    return brentq(excess, low, max(clearance / 2, 0.0) + 20 * scale, xtol=1e-18, rtol=1e-13)
