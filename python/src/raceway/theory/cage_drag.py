# SPDX-License-Identifier: GPL-2.0-or-later
"""Power dissipated by a cage that is one rigid ring (fix bearing/cage/ring): shear of the oil in
the pockets, the film at the guiding land, churning, and friction of balls that press against their
pockets because they run ahead of the cage or lag behind it (`excursion`). Friction due to the small
forces with which balls drive the cage against its drag is not included."""

import math
from typing import NamedTuple

import numpy as np

from raceway.arrays import Numbers
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
    # losses to leave out: friction, shear, land, churning
    without: frozenset[str] = frozenset()
    friction: float = float(variable_table.default("cage_friction"))  # of balls in their pockets


class Resistance(NamedTuple):
    """Resistance of the oil to the motion of the cage of one row."""

    # N m s, couple of one pocket divided by the ball's rotation relative to the cage; twice this
    # for the rotation about the axis of the pocket
    shear: float
    land: float  # N m s, couple at the lands divided by the speed relative to the guiding ring
    churning: Numbers  # N m, couple that opposes the rotation of the cage


def resistance(
    bearing: Bearing, cage: CageRing, fluid: Fluid, share: float, orbit: Numbers
) -> Resistance:
    """Return the `Resistance` of a cage that turns at `orbit` rad/s; `share` is the volume fraction
    of oil around the balls. A cage that is guided by a land is assumed to be centred."""
    oil, radius = fluid.viscosity, bearing.ball_radius
    shear = land = churning = 0.0
    if "shear" not in cage.without:
        play = cage.play or float(laws.usual_play()) * bearing.ball_diameter
        shear = float(laws.pocket_shear(oil, radius, play, cage.filled))
    if cage.land is not None and "land" not in cage.without:
        land = float(laws.land_couple(oil, *cage.land, cage.filled, 0.0))
    if "churning" not in cage.without:
        about = share, fluid.density, oil, bearing.pitch_radius, radius
        churning = np.sign(orbit) * laws.cage_churning(*about, np.abs(orbit))
    return Resistance(shear, land, churning)


def power(
    bearing: Bearing,
    cage: CageRing,
    fluid: Fluid,
    share: float,
    ring: float,
    orbit: float,
    angle: float = 0.0,
    pressed: float = 0.0,
) -> float:
    """Return the power in W dissipated in all rows. The inner ring turns at `ring` rad/s and the
    cage at `orbit` rad/s; `share` is the volume fraction of oil around the balls, `angle` is the
    mean contact angle in rad, and `pressed` is the sum of the pocket forces in N.

    In its pocket, a ball turns about the bearing's axis, tilted by the contact angle. The oil
    resists rotation about the axis of the pocket twice as strongly.
    """
    found = resistance(bearing, cage, fluid, share, orbit)
    spin = kinematics.frequencies(bearing, angle, ring).spin
    lost = len(bearing.row) * found.shear * spin**2 * (1 + math.sin(angle) ** 2)
    if "friction" not in cage.without:
        lost += cage.friction * pressed * bearing.ball_radius * abs(spin)
    slide = orbit - guide(cage, ring)
    of_row = found.land * slide**2 + found.churning * orbit
    return float(lost + len(bearing.layout.rows) * of_row)


def guide(cage: CageRing, ring: float) -> float:
    """Return the speed in rad/s of the ring at whose lands the cage slides, if the inner ring turns
    at `ring` rad/s."""
    return ring if cage.inner else 0.0
