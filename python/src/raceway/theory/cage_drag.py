# SPDX-License-Identifier: GPL-2.0-or-later
"""Power dissipated by a cage that is one rigid ring (fix bearing/cage/ring). Only losses with a
closed-form solution are included, i.e. shear of the oil in the pockets, the film at the guiding
land, and churning. Friction between balls and pockets depends on the forces in a run and is not
included."""

import math
from typing import NamedTuple

from raceway.core import laws
from raceway.sweeps import variable_table
from raceway.theory import kinematics
from raceway.theory.bearing import Bearing
from raceway.theory.lubricant import Fluid


class CageRing(NamedTuple):
    """Data of a cage that is one rigid ring, with the defaults used in decks."""

    play: float = 0.0  # m, play of the pockets along the pitch circle; 0: estimated
    # fraction of the gaps that is filled with oil
    filled: float = float(variable_table.default("cage_filled"))
    # radius of the guiding land, radial clearance and total width of both lands, all in m; None if
    # the cage is guided by the balls
    land: tuple[float, float, float] | None = None
    inner: bool = False  # True if the land is on the inner ring
    without: frozenset[str] = frozenset()  # losses to leave out: shear, land, churning


def power(
    bearing: Bearing,
    cage: CageRing,
    fluid: Fluid,
    share: float,
    ring: float,
    orbit: float,
    angle: float = 0.0,
) -> float:
    """Return the power in W dissipated in all rows. The inner ring turns at `ring` rad/s and the
    cage at `orbit` rad/s; `share` is the volume fraction of oil around the balls, and `angle` is
    the mean contact angle in rad.

    In its pocket, a ball turns about the bearing's axis, tilted by the contact angle. The oil
    resists rotation about the axis of the pocket twice as strongly. A cage that is guided by a land
    is assumed to be centred.
    """
    oil, radius = fluid.viscosity, bearing.ball_radius
    lost = 0.0
    if "shear" not in cage.without:
        play = cage.play or float(laws.usual_play()) * bearing.ball_diameter
        couple = laws.pocket_shear(oil, radius, play, cage.filled)
        spin = kinematics.frequencies(bearing, angle, ring).spin
        lost += len(bearing.row) * couple * spin**2 * (1 + math.sin(angle) ** 2)
    rows = len(bearing.layout.rows)
    if cage.land is not None and "land" not in cage.without:
        slide = orbit - ring if cage.inner else orbit
        lost += rows * laws.land_couple(oil, *cage.land, cage.filled) * slide**2
    if "churning" not in cage.without:
        about = share, fluid.density, oil, bearing.pitch_radius, radius
        lost += rows * laws.cage_churning(*about, abs(orbit)) * abs(orbit)
    return float(lost)
