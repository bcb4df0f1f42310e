# SPDX-License-Identifier: GPL-2.0-or-later
"""Central film thickness in all regimes, from a rigid and isoviscous to an elastic and piezoviscous
contact (Nijenbanning, Venner, Moes 1994).

Unlike the power laws in `film`, it remains valid as the load goes to zero.
"""

from typing import NamedTuple

import numpy as np

from raceway.arrays import Numbers
from raceway.core import laws


class Moes(NamedTuple):
    """Dimensionless parameters of Moes, with u_s = 2u and U_s = eta u_s/(E' R_x)."""

    load: Numbers  # M = W U_s^(-3/4)
    material: Numbers  # L = xi E' U_s^(1/4)
    ratio: Numbers  # lambda = R_x/R_y
    scale: Numbers  # sqrt(U_s) R_x, m


def group(
    viscosity: Numbers,
    pressure_viscosity: Numbers,
    modulus: float,
    r_x: Numbers,
    r_y: Numbers,
    speed: Numbers,
    load: Numbers,
) -> Moes:
    """Compute `Moes` from the viscosity eta (Pa s), xi (1/Pa), E' (Pa), R_x and R_y (m), the speed
    u (m/s, not zero) and the load Q (N)."""
    speed = 2 * viscosity * np.abs(speed) / (modulus * r_x)
    return Moes(
        load / (modulus * r_x**2) * speed**-0.75,
        pressure_viscosity * modulus * speed**0.25,
        r_x / r_y,
        np.sqrt(speed) * r_x,
    )


def h_c(g: Moes) -> Numbers:
    """Return the central thickness in m. The asymptotes were checked against the source. The
    formula that joins them is from memory and unchecked."""
    return g.scale * laws.film_all_regimes(g.load, g.material, g.ratio)
