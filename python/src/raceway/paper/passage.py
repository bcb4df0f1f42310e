# SPDX-License-Identifier: GPL-2.0-or-later
"""Operating points at which the lambda ratio passes a given value, computed from theory.

The functions return the speed, the capacitance, and the roughness for a given capacitance. The
contact considered is that of a ball on the load line with the inner raceway, where the film is
thinnest.
"""

import numpy as np
from scipy.optimize import brentq

from raceway.inputs import Oil
from raceway.paper import theory
from raceway.theory.bearing import INNER, Bearing


def speed(
    bearing: Bearing, oil: Oil, radial_load: float, h_min: float, printed: bool = False
) -> float:
    """Return the entrainment speed in m/s at which the smallest film thickness is `h_min` in m.

    The film thickness grows as a power of the speed.
    """
    q = theory.largest_load(bearing, radial_load)
    first, second = (
        theory.contact(bearing, oil, INNER, q, one, printed=printed).h_min for one in (0.5, 1.0)
    )
    power = np.log(second / first) / np.log(2.0)
    return float((h_min / second) ** (1 / power))


def capacitance(
    bearing: Bearing,
    oil: Oil,
    radial_load: float,
    h_min: float,
    whole: bool = True,
    printed: bool = False,
) -> float:
    """Return the capacitance in F at which the smallest film thickness is `h_min` in m.

    It is the capacitance of the bearing (`whole`) or of the ball on the load line.
    """
    at = speed(bearing, oil, radial_load, h_min, printed)
    if whole:
        return theory.bearing_capacitance(bearing, oil, radial_load, at, printed=printed)
    return float(
        theory.ball(bearing, oil, theory.largest_load(bearing, radial_load), at, printed=printed)
    )


def roughness(
    bearing: Bearing,
    oil: Oil,
    radial_load: float,
    value: float,
    whole: bool = True,
    printed: bool = False,
) -> float:
    """Return the composite roughness in m for which the capacitance at Lambda = 1 is `value` in
    F."""
    return float(
        np.exp(
            brentq(
                lambda log: (
                    capacitance(bearing, oil, radial_load, np.exp(log), whole, printed) - value
                ),
                np.log(1e-9),
                np.log(1e-4),
                xtol=1e-8,
            )
        )
    )
