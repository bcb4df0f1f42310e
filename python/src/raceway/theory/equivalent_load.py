# SPDX-License-Identifier: GPL-2.0-or-later
"""Dynamic equivalent load P = X F_r + Y F_a of single-row ball bearings (ISO 281, table 3).

The factors are quoted from memory, not checked against the standard. `life.of_loads` does not need
them, because it computes the equivalent load from the loads of the balls, including the effects of
clearance, tilt and rows.
"""

import math

import numpy as np

# deep groove bearings, X = 0.56: (F_a/(Z D^2) in MPa, i.e. f_0 F_a/C_0; e; Y), linear in between
RELATIVE = (0.172, 0.345, 0.689, 1.03, 1.38, 2.07, 3.45, 5.17, 6.89)
LIMIT = (0.19, 0.22, 0.26, 0.28, 0.30, 0.34, 0.38, 0.42, 0.44)
AXIAL = (2.30, 1.99, 1.71, 1.55, 1.45, 1.31, 1.15, 1.04, 1.00)
RADIAL = 0.56
# angular contact bearings: nominal angle in degrees, then (e, X, Y), interpolated linearly between
# the angles
ANGLES = (20.0, 25.0, 30.0, 35.0, 40.0, 45.0)
ANGULAR = (
    (0.57, 0.68, 0.80, 0.95, 1.14, 1.34),
    (0.43, 0.41, 0.39, 0.37, 0.35, 0.33),
    (1.00, 0.87, 0.76, 0.66, 0.57, 0.50),
)


def equivalent(
    radial: float, axial: float, *, angle: float, balls: int, ball_diameter: float
) -> float | None:
    """Return P in N for loads in N. `angle` is the nominal contact angle in rad and the diameter is
    in m. Without an axial load, P is the radial load at any angle. With an axial load, the result
    is None if the angle is outside the table, i.e. between 0 and 20 degrees or above 45 degrees.

    >>> point = dict(angle=0.0, balls=9, ball_diameter=12.6e-3)
    >>> equivalent(2000.0, 0.0, **point), round(equivalent(2000.0, 1000.0, **point))
    (2000.0, 2825)
    """
    radial, axial = abs(radial), abs(axial)
    if not axial:
        return radial
    if angle == 0:
        relative = axial / (balls * (1e3 * ball_diameter) ** 2)
        limit, factor = (np.interp(relative, RELATIVE, one) for one in (LIMIT, AXIAL))
        share = RADIAL
    else:
        degrees = math.degrees(angle)
        if not ANGLES[0] <= round(degrees, 9) <= ANGLES[-1]:
            return None
        limit, share, factor = (np.interp(degrees, ANGLES, one) for one in ANGULAR)
    if axial <= limit * radial:
        return radial
    return float(share * radial + factor * axial)
