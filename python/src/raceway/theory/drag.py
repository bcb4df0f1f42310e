# SPDX-License-Identifier: GPL-2.0-or-later
"""Drag on the balls in a mixture of oil and air."""

import numpy as np

from raceway.arrays import Numbers
from raceway.core import laws


def coefficient(reynolds: Numbers) -> Numbers:
    """Return the drag coefficient C_D of a sphere, interpolated linearly in log-log scale. It is
    proportional to 1/Re below Re = 0.1 (Stokes) and constant above 1e5."""
    return laws.drag_coefficient(np.maximum(reynolds, 1e-300))


def force(
    ball_radius: float, speed: Numbers, viscosity: Numbers, density: Numbers, share: float = 0.1
) -> Numbers:
    """Return the drag in N on a ball that moves around the bearing at `speed` in m/s, which is C_D
    rho_eff A v^2/2.

    A is pi R_b^2, and rho_eff is X rho_oil, where X = `share` is the volume fraction of oil in the
    free space, 0.01 to 0.2 (from memory, unchecked). C_D is evaluated at Re = rho_oil v 2R_b/eta.
    `density` is rho_oil in kg/m^3, and `viscosity` is eta in Pa s.
    """
    reynolds = density * np.abs(speed) * 2 * ball_radius / viscosity
    area = np.pi * ball_radius**2
    return 0.5 * share * density * coefficient(reynolds) * area * speed * np.abs(speed)
