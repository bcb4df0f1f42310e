# SPDX-License-Identifier: GPL-2.0-or-later
"""Drag of the balls in a mixture of oil and air."""

import numpy as np

from raceway.arrays import Numbers
from raceway.core import laws


def coefficient(reynolds: Numbers) -> Numbers:
    """C_D of a sphere, interpolated linearly in the logarithms of a table; proportional to 1/Re
    below Re 0.1 (Stokes) and constant above 1e5."""
    return laws.drag_coefficient(np.maximum(reynolds, 1e-300))


def force(
    ball_radius: float,
    speed: Numbers,
    viscosity: Numbers,
    density: Numbers,
    share: float = 0.1,
) -> Numbers:
    """Drag in N on a ball along its `speed` around the bearing in m/s: C_D rho_eff A v^2/2.

    A = pi R_b^2; rho_eff = X rho_oil, where X = `share` is the fraction of oil in the space, 0.01
    to 0.2 (from memory, unchecked); C_D is taken at Re = rho_oil v 2R_b/eta; `density` rho_oil in
    kg/m^3, `viscosity` eta in Pa s.
    """
    reynolds = density * np.abs(speed) * 2 * ball_radius / viscosity
    area = np.pi * ball_radius**2
    return 0.5 * share * density * coefficient(reynolds) * area * speed * np.abs(speed)
