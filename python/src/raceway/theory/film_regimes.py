# SPDX-License-Identifier: GPL-2.0-or-later
"""Central film thickness in all regimes, from a rigid isoviscous to an elastic piezoviscous contact
(Nijenbanning, Venner, Moes 1994).

Unlike the power laws of `film` it stays right as the load goes to zero.
"""

from typing import NamedTuple

import numpy as np

from raceway.arrays import Numbers


class Moes(NamedTuple):
    """Moes' dimensionless parameters, with u_s = 2u: U_s = eta u_s/(E' R_x)."""

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
    """`Moes` from eta (Pa s), xi (1/Pa), E' (Pa), R_x and R_y (m), u (m/s, not zero), Q (N)."""
    speed = 2 * viscosity * np.abs(speed) / (modulus * r_x)
    return Moes(
        load / (modulus * r_x**2) * speed**-0.75,
        pressure_viscosity * modulus * speed**0.25,
        r_x / r_y,
        np.sqrt(speed) * r_x,
    )


def h_c(g: Moes) -> Numbers:
    """Central thickness in m (the asymptotes read, the formula that joins them from memory,
    unchecked)."""
    wide = 1 + 0.006 * np.log(g.ratio) + 0.63 * g.ratio ** (4 / 7)
    ri = 145 * (1 + 0.796 * g.ratio ** (14 / 15)) ** (-15 / 7) / g.ratio * g.load**-2
    rp = 1.29 * (1 + 0.691 * g.ratio) ** (-2 / 3) * g.material ** (2 / 3)
    ei = 3.18 * wide ** (-14 / 25) * g.ratio ** (-1 / 15) * g.load ** (-2 / 15)
    ep = 1.48 * wide ** (-7 / 20) * g.ratio ** (-1 / 24) * g.load ** (-1 / 12) * g.material**0.75
    limit = 1.8 / g.ratio  # of the rigid isoviscous film at no load
    s = 1.5 * (1 + np.exp(-1.2 * ei / ep))
    iso = ri**1.5 + (ei**-4 + limit**-4) ** (-3 / 8)
    piezo = (rp**-8 + ep**-8) ** (-1 / 8)
    return g.scale * (iso ** (2 * s / 3) + piezo**s) ** (1 / s)
