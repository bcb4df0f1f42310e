# SPDX-License-Identifier: GPL-2.0-or-later
"""Normal damping of a contact (eqs 4, 5), N s/m."""

import numpy as np

from raceway.arrays import Numbers
from raceway.core import laws


def hysteretic(load: Numbers, restitution: float = 0.08) -> Numbers:
    """1.5 alpha_e Q for an elastic load Q = `load` in N and alpha_e = `restitution` in s/m (eq 4,
    Hunt-Crossley)."""
    return laws.hysteretic_damping(restitution, load)


def film(viscosity: float, length: Numbers, radius: Numbers, h_min: Numbers) -> Numbers:
    """Squeeze film, 3 pi eta a/sqrt(2) (R/h)^1.5 (eq 5, Walford-Stone).

    `viscosity` in Pa s, `length` the semi-axis a across the groove (eq 5) or 2a, `radius` the
    ball's R_b (eq 5) or the effective R_x, `h_min` in m. Raises `ValueError` if there is no
    film.
    """
    if np.any(np.asarray(h_min) <= 0):
        raise ValueError(f"h_min = {h_min} m must be positive")
    return laws.film_damping(viscosity, length, radius, h_min, 0.0)
