# SPDX-License-Identifier: GPL-2.0-or-later
"""Total capacitance from statics with flooded gaps.

In contrast to `theory`, which includes only the plates, it also includes the gap around the plates
and the unloaded balls.
"""

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
    """Return the equilibrium and Q_u for a first ball that is `step`/`PHASES` of a ball spacing
    past the load line."""
    phase = 2 * np.pi / bearing.balls * step / PHASES
    state, orbit = lubrication.turning(bearing, spin, radial_load, phase=phase)
    return state, capacitors.quiet_load(bearing, orbit)


def _solved(bearing, oil, radial_load, speed, filling, step=0):
    spin = speed / float(kinematics.entrainment(bearing, 1.0))
    state, quiet = _state(bearing, radial_load, spin, step)
    return capacitors.of_statics(bearing, state, oil, spin, quiet, filling=filling)


def ball(bearing: Bearing, oil: Oil, radial_load: float, speed: float, filling: Filling) -> float:
    """Return the capacitance in F of the ball on the load line.

    The radial load is in N and the entrainment speed in m/s.
    """
    return float(_solved(bearing, oil, radial_load, speed, filling).ball[0])


def bearing_capacitance(
    bearing: Bearing, oil: Oil, radial_load: float, speed: float, filling: Filling
) -> float:
    """Return the capacitance in F of the bearing, averaged over a ball pass.

    The arguments are the same as in `ball`.
    """
    some = range(PHASES)
    return float(
        np.mean([_solved(bearing, oil, radial_load, speed, filling, k).total for k in some])
    )
