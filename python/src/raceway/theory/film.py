# SPDX-License-Identifier: GPL-2.0-or-later
"""Thickness of the elastohydrodynamic film in m (eqs 6, 7, 9). Functions accept numbers or arrays
that broadcast, in SI units; the formulas are implemented in src-package/core/laws/film.h.

Every formula has the form R_x f(U, G, W, kappa) with U = eta U_r/(E' R_x), G = xi E' and W = Q/(E'
R_x^2), where U_r is the entrainment speed, i.e. half the sum of the speeds of both surfaces. The
thickness is zero at zero speed. It is an error if the load is zero, because the film of an unloaded
contact is not elastohydrodynamic.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from raceway.arrays import Integers, Numbers
from raceway.core import laws

MASJEDI_KHONSARI, PRINTED, HAMROCK_DOWSON = 0, 1, 2


class Group(NamedTuple):
    """The dimensionless parameters of a contact."""

    speed: Numbers  # U
    material: Numbers  # G
    load: Numbers  # W
    kappa: Numbers  # a/b


def group(
    viscosity: Numbers,
    pressure_viscosity: Numbers,
    modulus: float,
    r_x: Numbers,
    kappa: Numbers,
    speed: Numbers,
    load: Numbers,
) -> Group:
    """Compute the `Group` from the viscosity eta (Pa s), xi (1/Pa), E' (Pa), R_x (m), kappa, the
    speed |U_r| (m/s) and the load Q (N)."""
    if np.any(np.asarray(load) <= 0):
        raise ValueError(f"load = {load} N must be positive")
    return Group(
        viscosity * np.abs(speed) / (modulus * r_x),
        pressure_viscosity * modulus,
        load / (modulus * r_x**2),
        kappa,
    )


def h_min(r_x: Numbers, g: Group) -> Numbers:
    """Return the minimum film thickness by Masjedi and Khonsari in m (eq 6); R_x is in m."""
    return r_x * laws.film_thickness(MASJEDI_KHONSARI, *g).h_min


def h_c(r_x: Numbers, g: Group, printed: bool = False) -> Numbers:
    """Return the central film thickness by Masjedi and Khonsari in m (eq 9); R_x is in m.

    In equation 9 as printed in the paper, the exponents of kappa have a minus sign. With a plus
    sign, the film agrees with Hamrock-Dowson and tends to the film of a line contact as kappa
    grows. The minus sign is used if `printed` is true.
    """
    return r_x * laws.film_thickness(PRINTED if printed else MASJEDI_KHONSARI, *g).h_c


def load_exponent(kappa: Numbers, printed: bool = False) -> Numbers:
    """Return -d(ln h_c)/d(ln Q) of `h_c`."""
    return -laws.film_exponents(PRINTED if printed else MASJEDI_KHONSARI, kappa).load


def hamrock_dowson_min(r_x: Numbers, g: Group) -> Numbers:
    """Return the minimum film thickness by Hamrock and Dowson (1977) in m."""
    return r_x * laws.film_thickness(HAMROCK_DOWSON, *g).h_min


def hamrock_dowson_c(r_x: Numbers, g: Group) -> Numbers:
    """Return the central film thickness by Hamrock and Dowson (1977) in m."""
    return r_x * laws.film_thickness(HAMROCK_DOWSON, *g).h_c


def ratio(h_min: Numbers, roughness: float, ball_roughness: float = 0.0) -> Numbers:
    """Return the ratio Lambda = h_min/sqrt(sigma_1^2 + sigma_2^2), with lengths in m (eq 7)."""
    return h_min / laws.composite_roughness(roughness, ball_roughness)


def regime(ratio: ArrayLike, boundary: float = 1.0, full: float = 3.0) -> np.int64 | Integers:
    """Classify Lambda = `ratio`. The result is 0 (boundary) below `boundary`, 2 (full film) above
    `full`, and 1 (mixed) otherwise.

    >>> regime([0.5, 1.4, 3.2]).tolist()
    [0, 1, 2]
    """
    return laws.film_regime(boundary, full, ratio).astype(int)
