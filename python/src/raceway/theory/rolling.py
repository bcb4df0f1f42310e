# SPDX-License-Identifier: GPL-2.0-or-later
"""Rolling resistance: hydrodynamic, in the inlet of the film, and from hysteresis of the steel.

Both act on ball and ring as equal and opposite couples about the axis of the relative rolling
velocity w, which they oppose. Numbers or arrays of one shape, SI units; fully flooded and
isothermal.
"""

from raceway.arrays import Numbers
from raceway.core import laws


def hydrodynamic(
    viscosity: Numbers,
    modulus: float,
    r_x: Numbers,
    r_y: Numbers,
    speed: Numbers,
    load: Numbers,
) -> Numbers:
    """f in N; the contact loses the power 2 f u. Biboulet and Houpert 2010, part 2, eq 32, written
    as powers of U = eta u/(E' R_x), W and R_y/R_x by Balan et al. 2015, which differs by less than
    0.6 % for a ball bearing.

    eta in Pa s, E' in Pa, R_x and R_y in m, u in m/s, Q in N. Valid for kappa up to 60 and p_max
    from 0.06 to 4 GPa. Zero at rest and without load.
    """
    return laws.rolling_force(viscosity, modulus, r_x, r_y, speed, load)


def inlet(length: float, h_c: Numbers, b: Numbers, r_x: Numbers) -> Numbers:
    """Share of `hydrodynamic` that remains with an inlet of `length` in semi-axes b, 1/2 to 1; 0 is
    flooded, 1 the shortest. h_c, b and R_x in m."""
    return laws.rolling_inlet(length, h_c, b, r_x)


def couple(force: Numbers, r_x: Numbers) -> Numbers:
    """2 f R_x in N m: the couple of a hydrodynamic force f; its power at Omega = u/R_x is 2 f u."""
    return 2 * force * r_x


def hysteresis(load: Numbers, b: Numbers, loss: float) -> Numbers:
    """Couple alpha Q 2b/(3 pi) in N m for a load Q in N and the semi-axis b along rolling in m;
    `loss` is alpha, 0.005 to 0.05 for steel (Schwarz et al. 2023; Johnson 1985, section 9.4).

    This is the couple of a line contact; see `hysteresis_strips`.
    """
    return laws.hysteresis_couple(loss, load, b)


def hysteresis_strips(load: Numbers, b: Numbers, loss: float) -> Numbers:
    """3/16 alpha Q b in N m: the line contact's couple integrated strip by strip over the ellipse,
    12 % less than `hysteresis`."""
    return 3 / 16 * loss * load * b
