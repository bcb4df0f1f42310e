# SPDX-License-Identifier: GPL-2.0-or-later
"""Rolling resistance due to the hydrodynamic force in the film inlet and to hysteresis of the
steel.

Both act on ball and ring as equal and opposite couples about the axis of the relative rolling
velocity w, and oppose it. Functions accept numbers or arrays of equal shape in SI units, for fully
flooded and isothermal contacts.
"""

from raceway.arrays import Numbers
from raceway.core import laws


def hydrodynamic(
    viscosity: Numbers, modulus: float, r_x: Numbers, r_y: Numbers, speed: Numbers, load: Numbers
) -> Numbers:
    """Return the force f in N, for which the power dissipated in the contact is 2 f u. The formula
    is eq 32 of Biboulet and Houpert 2010, part 2. It is used in the form by Balan et al. 2015 with
    powers of U = eta u/(E' R_x), W and R_y/R_x, which differs by less than 0.6 % for a ball
    bearing.

    eta is in Pa s, E' in Pa, R_x and R_y in m, u in m/s and Q in N. The formula is valid for kappa
    up to 60 and p_max from 0.06 to 4 GPa. The force is zero at zero speed and at zero load.
    """
    return laws.rolling_force(viscosity, modulus, r_x, r_y, speed, load)


def inlet_shear(loading: Numbers) -> Numbers:
    """Return the fraction 1/(1 + 0.29 L^0.78) of `hydrodynamic` that remains where shear heats the
    oil in the inlet (Aihara 1987, for the rolling torque). L is `film_factors.thermal_loading`."""
    return laws.rolling_inlet_shear(loading)


def inlet(length: float, h_c: Numbers, b: Numbers, r_x: Numbers) -> Numbers:
    """Return the fraction of `hydrodynamic`, between 1/2 and 1, that remains if the inlet has the
    given `length` in multiples of b. A length of 0 means a fully flooded inlet, and 1 is the
    shortest possible inlet. h_c, b and R_x are in m."""
    return laws.rolling_inlet(length, h_c, b, r_x)


def hysteresis(load: Numbers, b: Numbers, loss: float) -> Numbers:
    """Return the couple alpha Q 2b/(3 pi) in N m for a load Q in N and a semi-axis b along rolling
    in m. `loss` is alpha, which is 0.005 to 0.05 for steel (Schwarz et al. 2023; Johnson 1985,
    section 9.4).

    This is the couple of a line contact.
    """
    return laws.hysteresis_couple(loss, load, b)
