# SPDX-License-Identifier: GPL-2.0-or-later
"""Total capacitance from statics, with flooded gaps: like `theory`, which includes only the plates,
but with the gap around the plates and the unloaded balls."""

from functools import lru_cache

import numpy as np

from raceway.inputs import Oil
from raceway.theory import capacitors, kinematics, lubrication
from raceway.theory.bearing import Bearing
from raceway.theory.capacitors import Filling

# number of positions of the first ball within a ball spacing; the mean is accurate to 1e-3
PHASES = 6


@lru_cache(maxsize=256)
def _state(bearing, radial_load, spin, step):
    """Equilibrium and Q_u with the first ball `step`/`PHASES` of a ball spacing past the load
    line."""
    phase = 2 * np.pi / bearing.balls * step / PHASES
    state, orbit = lubrication.turning(bearing, spin, radial_load, phase=phase)
    return state, capacitors.quiet_load(bearing, orbit)


def _solved(bearing, oil, radial_load, speed, filling, step=0):
    spin = speed / float(kinematics.entrainment(bearing, 1.0))
    state, quiet = _state(bearing, radial_load, spin, step)
    return capacitors.of_statics(bearing, state, oil, spin, quiet, filling=filling)


def ball(bearing: Bearing, oil: Oil, radial_load: float, speed: float, filling: Filling) -> float:
    """Capacitance in F of the ball on the load line at an entrainment speed in m/s; load in N."""
    return float(_solved(bearing, oil, radial_load, speed, filling).ball[0])


def bearing_capacitance(
    bearing: Bearing, oil: Oil, radial_load: float, speed: float, filling: Filling
) -> float:
    """Mean capacitance in F of the bearing over a ball pass, arguments as in `ball`."""
    return float(
        np.mean(
            [
                _solved(bearing, oil, radial_load, speed, filling, step).total
                for step in range(PHASES)
            ]
        )
    )
