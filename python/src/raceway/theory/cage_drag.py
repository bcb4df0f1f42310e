# SPDX-License-Identifier: GPL-2.0-or-later
"""Power lost by a cage that is one rigid ring (fix bearing/cage/ring). Only the parts of the loss
that have a closed form are included: oil sheared in its pockets, film at its guiding land,
churning. The friction of balls on their pockets follows from the forces of a run and is left
out."""

import math
from typing import NamedTuple

from raceway.core import laws
from raceway.sweeps import variable_table
from raceway.theory import kinematics
from raceway.theory.bearing import Bearing
from raceway.theory.lubricant import Fluid


class CageRing(NamedTuple):
    """Data of a cage that is one rigid ring, with the defaults of decks."""

    play: float = 0.0  # m, of the pockets along the pitch circle; 0: estimated
    filled: float = float(variable_table.default("cage_filled"))  # share of the gaps with oil
    # m, radius of the guiding land, radial clearance, width of both lands together; None: guided
    # by the balls
    land: tuple[float, float, float] | None = None
    inner: bool = False  # the land is on the inner ring
    without: frozenset[str] = frozenset()  # parts that are left out: shear, land, churning


def power(
    bearing: Bearing,
    cage: CageRing,
    fluid: Fluid,
    share: float,
    ring: float,
    orbit: float,
    angle: float = 0.0,
) -> float:
    """Power lost in all rows, W. The inner ring turns at `ring` rad/s and the cage at `orbit`
    rad/s; `share` is the fraction of oil around the balls, `angle` the mean contact angle in rad.

    In its pocket a ball turns about the bearing's axis, tilted by the contact angle; about the
    pocket's own axis the oil resists twice as much. A cage on a land is taken as centred.
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
