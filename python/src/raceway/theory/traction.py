# SPDX-License-Identifier: GPL-2.0-or-later
"""Shear stress in a sliding film. Functions accept numbers or arrays of equal shape in SI units."""

import numpy as np

from raceway.arrays import Floats, Numbers
from raceway.core import laws
from raceway.theory import lubricant
from raceway.theory.lubricant import Fluid


def eyring(
    viscosity: Numbers,
    sliding: Numbers,
    thickness: Numbers,
    stress: Numbers = 5e6,
    limit: Numbers = np.inf,
) -> Numbers:
    """Return the stress tau = min(tau_0 asinh(eta s/(h tau_0)), limit) in Pa, which is odd in s.

    eta in Pa s is the viscosity under pressure, s is in m/s, and h is in m. `stress` is tau_0 and
    `limit` is Lambda_L p, both in Pa. Lambda_L is 0.047 for mineral oil, 0.04 for paraffinic oil,
    0.035 for PAO and 0.03 for ester (Arana 2019 after Hoglund 1999).
    """
    rate = np.abs(sliding) / thickness
    return np.sign(sliding) * laws.eyring_shear(viscosity, rate, stress, limit)


def coefficient(
    viscosity: Numbers,
    pressure_viscosity: Numbers,
    pressure: Numbers,
    rate: Numbers,
    stress: Numbers = 5e6,
    limit: Numbers = np.inf,
) -> Numbers:
    """Return the friction coefficient of a film in a Hertz contact with the largest `pressure` in
    Pa and the uniform shear rate `rate` = s/h in 1/s.

    The stress is that of `eyring` with the viscosity of Roelands for eta (Pa s) and xi (1/Pa);
    `limit` is Lambda_L. With p = t p_max, the mean over the ellipse is 3/p_max times the integral
    of tau t over t from 0 to 1. It is computed with eight Gauss points, with an error below 0.9 %.
    """
    return laws.film_coefficient(viscosity, pressure_viscosity, stress, limit, pressure, rate)


def combined(
    fluid: Fluid,
    load: Floats,
    a: Floats,
    b: Floats,
    thickness: Floats,
    slip: Floats,
    spin: Floats,
    curve: Floats,
) -> Floats:
    """Return the friction coefficient for which Coulomb's law gives the same power loss as `eyring`
    with its limit. The contacts (...) have a `load` (N) and semi-axes (m) and slide at (slip + spin
    z - curve z^2, -spin x), as in `spin.with_slip`. The units are m/s for slip, rad/s for spin,
    1/(m s) for curve and m for thickness."""
    node, weight = np.polynomial.legendre.leggauss(12)
    # r = sin(t) removes the square root of the pressure
    t, turn = (node[:, None] + 1) * np.pi / 4, (np.arange(24) + 0.5) * np.pi / 12
    area = weight[:, None] * np.sin(t) * np.cos(t)
    load, a, b, thickness, slip, spin, curve = (
        np.asarray(one)[..., None, None] for one in (load, a, b, thickness, slip, spin, curve)
    )
    x, z = b * np.sin(t) * np.cos(turn), a * np.sin(t) * np.sin(turn)
    sliding = np.hypot(slip + spin * z - curve * z**2, spin * x)
    pressure = 1.5 * load / (np.pi * a * b) * np.cos(t)
    eta = lubricant.roelands(fluid.viscosity, fluid.pressure_viscosity, pressure)
    limit = fluid.limiting_traction * pressure
    stress = eyring(eta, sliding, thickness, fluid.eyring_stress, limit)
    power = (stress * sliding * area).sum((-2, -1))
    return power / (pressure * sliding * area).sum((-2, -1))


def mixed(share: Numbers, boundary: Numbers, film: Numbers) -> Numbers:
    """Return the coefficient mu = L_a mu_b + (1 - L_a) mu_film with L_a = `share` (see
    `asperity`)."""
    return laws.mixed_friction(boundary, film, share)
