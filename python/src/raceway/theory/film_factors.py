# SPDX-License-Identifier: GPL-2.0-or-later
"""Factors that correct the thickness of a smooth, isothermal and fully flooded film for inlet shear
heating, starvation and roughness. Functions accept numbers or arrays of equal shape in SI units. A
factor of 1 means that the effect is absent.
"""

import numpy as np

from raceway.arrays import Numbers
from raceway.core import laws

MURCH_WILSON, WILSON = 1, 2

GUPTA_MOST = 0.9  # upper limit of 13.2 P L^0.42; larger values are reduced to it in a run


def thermal_loading(
    temperature_viscosity: Numbers, viscosity: Numbers, speed: Numbers, conductivity: Numbers
) -> Numbers:
    """Return L = beta eta u^2/k_f, for beta in 1/K, eta in Pa s, k_f in W/(m K) and the entrainment
    speed u in m/s. If u were the sum of the speeds of both surfaces, L would be four times as
    large."""
    return laws.thermal_loading(temperature_viscosity, viscosity, speed, conductivity)


def murch_wilson(loading: Numbers) -> Numbers:
    """Return the film factor 3.94/(3.94 + L^0.62) for pure rolling (Murch and Wilson 1975; from
    memory, unchecked). It is the default and is within 0.5 % of SKF's factor on a 6208."""
    return laws.inlet_shear(MURCH_WILSON, loading)


def gupta_parts(
    loading: Numbers, pressure: Numbers, slide_roll: Numbers = 0.0
) -> tuple[Numbers, Numbers]:
    """Return (1/(1 + 0.213 (1 + 2.23 S^0.83) L^0.64), 13.2 P L^0.42) of `gupta`, i.e. the factor
    without the effect of pressure, and the fraction by which pressure reduces it."""
    return tuple(laws.gupta_parts(loading, pressure, slide_roll))


def gupta(loading: Numbers, pressure: Numbers, slide_roll: Numbers = 0.0) -> Numbers:
    """Return the film factor (1 - 13.2 P L^0.42)/(1 + 0.213 (1 + 2.23 S^0.83) L^0.64), with P =
    `pressure` = p_max/E' (Gupta et al. 1992; Zhu and Cheng).

    `slide_roll` is S = s/u. The formula is valid for L below about 10. Raises `ValueError` if
    pressure reduces the factor by more than `GUPTA_MOST`.
    """
    unpressed, lost = gupta_parts(loading, pressure, slide_roll)
    if np.any(lost > GUPTA_MOST):
        raise ValueError(f"L = {loading} is beyond the range of Gupta's factor, about 10")
    return unpressed * (1 - lost)


def wilson(loading: Numbers) -> Numbers:
    """Return the film factor 1/(1 + 0.1 L^0.64) (Wilson 1979)."""
    return laws.inlet_shear(WILSON, loading)
