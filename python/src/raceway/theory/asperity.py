# SPDX-License-Identifier: GPL-2.0-or-later
"""Fraction L_a of the contact load carried by asperities, as a function of the lambda ratio Lambda.

The predictions differ considerably between laws: L_a is 0.26 to 0.67 at Lambda = 0.30, and 0.05 to
0.17 at Lambda = 1.41.
"""

import numpy as np

from raceway.arrays import Numbers
from raceway.core import laws

# {composite roughness in m: (B, C)} by Zhou and Hoeprich, for roller bearings
ZHOU_HOEPRICH = {1.0e-7: (2.1, 0.85), 1.6e-7: (2.32, 0.97), 2.4e-7: (1.90, 0.99)}
CONDUCTS = 0.01  # if L_a is larger, a contact conducts instead of acting as a capacitor


def zhou_hoeprich(ratio: Numbers, b: float = 2.1, c: float = 0.85) -> Numbers:
    """Return L_a = exp(-B Lambda^C) (Zhou and Hoeprich 1991, in Schwarz et al., Lubricants 2023,
    11, 369); `ZHOU_HOEPRICH` lists B and C for several values of the roughness."""
    return laws.asperity_share(ratio, b, c)


def olver_spikes(ratio: Numbers) -> Numbers:
    """Return L_a = 1/(1 + Lambda)^2 (Olver and Spikes 1998; from memory, unchecked)."""
    return 1 / (1 + ratio) ** 2


def clarke(ratio: Numbers) -> Numbers:
    """Return L_a = 1 - erf(Lambda) (Clarke et al. 2016), accurate to 1.5e-7. It is used if
    `models` is full."""
    return laws.complementary_error(ratio)


def overlap_integral(ratio: Numbers, order: float = 2.5) -> Numbers:
    """Return F_n(Lambda) = Gamma(n + 1)/sqrt(2 pi) exp(-Lambda^2/4) D_(-n-1)(Lambda), n = `order`.

    This is the mean of (s - Lambda)^n, counted as zero for s below Lambda, where s is a standard
    normal variable (Greenwood, Tripp 1970).
    """
    from scipy.special import gamma as factorial  # loading it takes longer than a summary of a run
    from scipy.special import pbdv

    cylinder = pbdv(-order - 1, ratio)[0]
    return factorial(order + 1) / np.sqrt(2 * np.pi) * np.exp(-np.square(ratio) / 4) * cylinder


def five_halves(ratio: Numbers) -> Numbers:
    """Return F_5/2(Lambda) from a cubic fit of its logarithm, with an error of at most 0.42 % for
    Lambda from 0 to 4."""
    return np.exp(-0.48773 - ratio * (1.721407 + ratio * (0.294656 + ratio * 0.013684)))


def two(ratio: Numbers) -> Numbers:
    """Return F_2(Lambda) from a cubic fit of its logarithm, with an error of at most 0.48 % for
    Lambda from 0 to 4."""
    return np.exp(-0.697943 - ratio * (1.570737 + ratio * (0.301946 + ratio * 0.013743)))


def greenwood_tripp(
    ratio: Numbers, modulus: float, density: float = 0.04, slope: float = 3e-3
) -> Numbers:
    """Return the mean pressure carried by asperities in Pa, (16 sqrt(2) pi/15) (eta beta sigma)^2
    sqrt(sigma/beta) E* F_5/2(Lambda), with E* = E'/2 and E' = `modulus` in Pa. `density` is eta
    beta sigma (0.03 to 0.05) and `slope` is sigma/beta (1e-3 to 1e-2).

    This pressure is less than 5 % of the pressure in a Hertz contact, so only the shape of the
    curve is useful.
    """
    factor = 16 * np.sqrt(2) * np.pi / 15 * density**2 * np.sqrt(slope)
    return factor * modulus / 2 * overlap_integral(ratio)
