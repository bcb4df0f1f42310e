# SPDX-License-Identifier: GPL-2.0-or-later
"""Elliptical Hertz contact (eq 2).

The ellipse has the semi-axes a across the groove and b along rolling; kappa = a/b may be below one.
All functions accept and return numbers or arrays that broadcast, in SI units. The formulas are
implemented in src-package/core/laws/hertz.h.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from raceway.arrays import Numbers
from raceway.core import laws

EXACT, HAMROCK_BREWE, PRINTED = 0, 1, 2


class Ellipse(NamedTuple):
    """Quantities of a contact that depend only on the shape of the surfaces."""

    kappa: Numbers  # a/b
    first: Numbers  # complete elliptic integral F of the first kind, with modulus^2 = 1 - 1/kappa^2
    second: Numbers  # complete elliptic integral E of the second kind, with the same modulus
    radius: Numbers  # R in m, where 1/R = 1/R_x + 1/R_y


def ellipticity(ratio: ArrayLike) -> Numbers:
    """Return kappa = a/b for R_y/R_x = `ratio` (any positive number or array), accurate to rounding
    error.

    kappa is the root of R_y/R_x = (kappa^2 E - F)/(F - E). Raises `ValueError` if a ratio is not
    positive.
    """
    return exact(1.0, np.asarray(ratio, dtype=float)).kappa


def exact(r_x: Numbers, r_y: Numbers) -> Ellipse:
    """Return the `Ellipse` for effective radii `r_x`, `r_y` (m), with exact elliptic integrals.
    Raises `ValueError` if a ratio of radii is not positive.

    For the inner raceway of the 6208 in the paper:

    >>> one = exact(4.990e-3, 163.8e-3)
    >>> print(f"{one.kappa:.3f}, K = {stiffness(one, 210e9 / 0.91):.3e} N/m^1.5")
    9.374, K = 3.250e+10 N/m^1.5
    """
    ratio = np.asarray(r_y / r_x)
    if not np.all(np.isfinite(ratio) & (ratio > 0)):
        raise ValueError(f"R_y/R_x = {ratio} must be positive: the surfaces must not be conformal")
    return Ellipse(*laws.hertz_ellipse(r_x, r_y, EXACT))


def hamrock_brewe(r_x: Numbers, r_y: Numbers, printed: bool = False) -> Ellipse:
    """Return the `Ellipse` from the fit by Hamrock and Brewe for alpha = R_y/R_x >= 1: kappa =
    alpha^(2/pi), E = 1 + q/alpha, F = pi/2 + q ln(alpha), q = pi/2 - 1. If `printed` is true, F = 1
    + q ln(alpha) is used instead (eq 2 as printed in the paper).
    """
    if np.any(r_y < r_x):
        alpha = r_y / r_x
        raise ValueError(f"R_y/R_x = {alpha}: the Hamrock-Brewe fit needs a ratio of at least 1")
    return Ellipse(*laws.hertz_ellipse(r_x, r_y, PRINTED if printed else HAMROCK_BREWE))


def stiffness(ellipse: Ellipse, modulus: float) -> Numbers:
    """Return K of Q = K overlap^1.5 in N/m^1.5, for E' = `modulus` in Pa (eq 2)."""
    return laws.hertz_stiffness(*ellipse, modulus)


def load(stiffness: Numbers, overlap: Numbers) -> Numbers:
    """Return the load Q = K overlap^1.5 in N, which is zero if there is no overlap (eq 2)."""
    return laws.hertz_load(stiffness, overlap)


def semi_axes(ellipse: Ellipse, modulus: float, load: Numbers) -> tuple[Numbers, Numbers]:
    """Return the semi-axes (a across the groove, b along rolling) in m under `load` in N
    (Hertz)."""
    kappa, _, second, radius = ellipse
    return tuple(laws.hertz_semi_axes(kappa, second, radius, modulus, load))


def pressure(ellipse: Ellipse, modulus: float, load: Numbers) -> Numbers:
    """Return the largest pressure 1.5 Q/(pi a b) in Pa under `load` in N; zero without load."""
    kappa, _, second, radius = ellipse
    return laws.hertz_pressure(kappa, second, radius, modulus, load)
