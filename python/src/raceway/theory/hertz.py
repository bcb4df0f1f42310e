# SPDX-License-Identifier: GPL-2.0-or-later
"""Elliptical Hertz contact (eq 2).

The ellipse has semi-axis a across the groove and b along rolling; kappa = a/b may be below one.
Everything takes and returns numbers or arrays of one shape, SI units.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike
from scipy.special import ellipe, ellipkm1, elliprd

from raceway.arrays import Numbers


class Ellipse(NamedTuple):
    """What the shape of two surfaces alone decides."""

    kappa: Numbers  # a/b
    first: Numbers  # complete elliptic integral F of modulus^2 1 - 1/kappa^2
    second: Numbers  # complete elliptic integral E of the same
    radius: Numbers  # R in m, 1/R = 1/R_x + 1/R_y


def ellipticity(ratio: ArrayLike) -> Numbers:
    """kappa = a/b for R_y/R_x = `ratio` (any positive number or array). Exact to rounding.

    Hertz gives R_y/R_x = (kappa^2 E - F)/(F - E). Both differences vanish for a circle, so they are
    taken in Carlson's form (DLMF 19.25.1), where the quotient is R_D(0,1,q)/R_D(0,q,1) with q =
    1/kappa^2. Raises `ValueError` if a ratio is not positive.
    """
    ratio = np.asarray(ratio, dtype=float)
    if not np.all(np.isfinite(ratio) & (ratio > 0)):
        raise ValueError(f"R_y/R_x = {ratio} must be positive: the surfaces must not be conformal")

    def miss(log_kappa):
        q = np.exp(-2 * log_kappa)
        return np.log(elliprd(0, 1, q) / elliprd(0, q, 1)) - np.log(ratio)

    log_kappa = 2 / np.pi * np.log(ratio)  # Hamrock-Brewe: a few per cent off
    for _ in range(20):
        value = miss(log_kappa)
        slope = (miss(log_kappa + 1e-5) - miss(log_kappa - 1e-5)) / 2e-5
        step = value / slope
        log_kappa = log_kappa - step
        if np.all(np.abs(step) < 1e-13 * (1 + np.abs(log_kappa))):
            break
    return np.exp(log_kappa)[()]


def exact(r_x: Numbers, r_y: Numbers) -> Ellipse:
    """`Ellipse` of effective radii `r_x`, `r_y` (m), by the exact elliptic integrals.

    The inner raceway of the paper's 6208:

    >>> one = exact(4.990e-3, 163.8e-3)
    >>> print(f"{one.kappa:.3f}, K = {stiffness(one, 210e9 / 0.91):.3e} N/m^1.5")
    9.374, K = 3.250e+10 N/m^1.5
    """
    kappa = ellipticity(r_y / r_x)
    m = 1 - kappa**-2
    return Ellipse(kappa, ellipkm1(kappa**-2), ellipe(m), 1 / (1 / r_x + 1 / r_y))


def hamrock_brewe(r_x: Numbers, r_y: Numbers, printed: bool = False) -> Ellipse:
    """`Ellipse` by Hamrock and Brewe's fit for alpha = R_y/R_x >= 1: kappa = alpha^(2/pi), E = 1 +
    q/alpha, F = pi/2 + q ln(alpha), q = pi/2 - 1. `printed` takes the paper's F = 1 + q ln(alpha)
    (eq 2 as printed).
    """
    alpha, q = r_y / r_x, np.pi / 2 - 1
    if np.any(alpha < 1):
        raise ValueError(f"R_y/R_x = {alpha}: the Hamrock-Brewe fit is for values of one and more")
    first = (1 if printed else np.pi / 2) + q * np.log(alpha)
    return Ellipse(alpha ** (2 / np.pi), first, 1 + q / alpha, 1 / (1 / r_x + 1 / r_y))


def stiffness(ellipse: Ellipse, modulus: float) -> Numbers:
    """K in N/m^1.5 of Q = K overlap^1.5, for E' = `modulus` in Pa (eq 2)."""
    return (
        np.pi
        * ellipse.kappa
        * modulus
        * np.sqrt(ellipse.second * ellipse.radius / (4.5 * ellipse.first**3))
    )


def load(stiffness: Numbers, overlap: Numbers) -> Numbers:
    """Q = K overlap^1.5 in N, zero without overlap (eq 2)."""
    return stiffness * np.maximum(overlap, 0) ** 1.5


def semi_axes(ellipse: Ellipse, modulus: float, load: Numbers) -> tuple[Numbers, Numbers]:
    """(a across the groove, b along rolling) in m under `load` in N (Hertz)."""
    a = np.cbrt(6 * ellipse.kappa**2 * ellipse.second * load * ellipse.radius / (np.pi * modulus))
    return a, a / ellipse.kappa


def pressure(ellipse: Ellipse, modulus: float, load: Numbers) -> Numbers:
    """Largest pressure 1.5 Q/(pi a b) in Pa under `load` in N; zero without load."""
    a, b = semi_axes(ellipse, modulus, 1.0)
    return 1.5 * np.cbrt(load) / (np.pi * a * b)  # a b grows as Q^(2/3)


def sphere_stiffness(modulus: float, radius: float) -> float:
    """K = 4/3 E* sqrt(R*) of two spheres, N/m^1.5; E* in Pa with 1/E* = sum((1 - nu^2)/E), R* in m.

    Equation 3 prints a further 1/(1 - nu); Hertz has none."""
    return 4 / 3 * modulus * np.sqrt(radius)
