# SPDX-License-Identifier: GPL-2.0-or-later
"""Electrical capacitance of lubricated contacts in F (eqs 8, 10, 11, 12)."""

import numpy as np
from numpy.typing import ArrayLike

from raceway.arrays import Numbers
from raceway.core import laws

VACUUM = float(laws.vacuum_permittivity())  # F/m
PERMITTIVITY_AT = ("maximum", "mean", "two_thirds")


def density_ratio(pressure: Numbers) -> Numbers:
    """Return the relative density rho/rho_0 of a lubricant under `pressure` in Pa (eq 11,
    Dowson-Higginson)."""
    return laws.density_ratio(pressure)


def permittivity(ambient: Numbers, pressure: Numbers) -> Numbers:
    """Return the relative permittivity of an oil under `pressure` in Pa, where `ambient` is its
    permittivity at ambient pressure (eqs 10, 11).

    According to Clausius-Mossotti, (e - 1)/(e + 2) is proportional to the density. Raises
    `ValueError` if `ambient` is below one, or so large that no finite permittivity results.

    >>> print(f"{permittivity(2.2, 0.0):.3f} at rest, {permittivity(2.2, 2.5e9):.3f} at 2.5 GPa")
    2.200 at rest, 2.719 at 2.5 GPa
    """
    if np.any(np.asarray(ambient) < 1):
        raise ValueError(f"permittivity = {ambient} must be one or more")
    return _finite(laws.permittivity(ambient, pressure), ambient, pressure)


def mean_permittivity(ambient: Numbers, pressure: Numbers) -> Numbers:
    """Return the mean of `permittivity` over the area of a Hertz ellipse in which the largest
    pressure is `pressure` in Pa. Raises `ValueError` like `permittivity`.

    >>> print(f"{mean_permittivity(2.2, 1.5e9):.3f}, at its largest {permittivity(2.2, 1.5e9):.3f}")
    2.578, at its largest 2.654
    """
    permittivity(ambient, pressure)  # called for the `ValueError` that it may raise
    return laws.mean_permittivity(ambient, pressure)


def film_permittivity(ambient: Numbers, pressure: Numbers, at: str = "maximum") -> Numbers:
    """Return the relative permittivity of a film, given the largest `pressure` in its ellipse (Pa).
    `at` selects the value at that pressure ("maximum", as in the paper), the value at two thirds of
    it ("two_thirds"), or the mean over the area ("mean"). Raises `ValueError` for an unknown
    `at`."""
    if at not in PERMITTIVITY_AT:
        raise ValueError(f"permittivity_at '{at}' is not one of {', '.join(PERMITTIVITY_AT)}")
    if at == "mean":
        return mean_permittivity(ambient, pressure)
    return permittivity(ambient, pressure * (2 / 3 if at == "two_thirds" else 1.0))


def contact(ambient: Numbers, pressure: Numbers, a: Numbers, b: Numbers, h_c: Numbers) -> Numbers:
    """Return the capacitance eps_0 eps_r(p) pi a b/h_c of one contact in F (eq 8). `pressure` is in
    Pa, and lengths are in m."""
    return laws.contact_capacitance(permittivity(ambient, pressure), a, b, h_c)


def ball(inner: ArrayLike, outer: ArrayLike) -> Numbers:
    """Return the capacitance in F of an inner and an outer contact in series, which is zero if
    either capacitance is zero (eq 12). The arrays must have the same shape.

    >>> ball([3e-10, 3e-10], [6e-10, 0.0]).tolist()
    [2e-10, 0.0]
    """
    return laws.series_capacitance(inner, outer)


def bearing(inner: ArrayLike, outer: ArrayLike, background: float = 0.0) -> Numbers:
    """Return the capacitance in F of all balls (the last axis) in parallel (eq 12), plus
    `background`."""
    return np.sum(ball(inner, outer), axis=-1) + background


def _finite(found, ambient, pressure):
    if np.any((found <= 0) | np.isinf(found)):
        raise ValueError(
            f"permittivity = {ambient} is too large for Clausius-Mossotti at {pressure} Pa"
        )
    return found
