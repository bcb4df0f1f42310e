# SPDX-License-Identifier: GPL-2.0-or-later
"""Normal damping of a contact in N s/m (eqs 4, 5)."""

import numpy as np

from raceway.arrays import Numbers
from raceway.core import laws


def hysteretic(load: Numbers, restitution: float = 0.08) -> Numbers:
    """Return 1.5 alpha_e Q, where Q = `load` is the elastic load in N and alpha_e = `restitution`
    is in s/m (eq 4, Hunt-Crossley)."""
    return laws.hysteretic_damping(restitution, load)


def film(viscosity: float, length: Numbers, radius: Numbers, h_min: Numbers) -> Numbers:
    """Return the damping 3 pi eta a/sqrt(2) (R/h)^1.5 by the squeeze film (eq 5, Walford-Stone).

    `viscosity` is in Pa s. `length` is the semi-axis a across the groove (eq 5) or 2a, and `radius`
    is the ball radius R_b (eq 5) or the effective radius R_x. `h_min` is in m. Raises `ValueError`
    if there is no film.
    """
    if np.any(np.asarray(h_min) <= 0):
        raise ValueError(f"h_min = {h_min} m must be positive")
    return laws.film_damping(viscosity, length, radius, h_min, 0.0)
