# SPDX-License-Identifier: GPL-2.0-or-later
"""Losses of the contacts in a groove, each of which rolls freely or, after a part of its orbit
without load, slides until friction has turned the ball again."""

import numpy as np

from raceway.arrays import Floats
from raceway.theory import asperity, rolling, skidding, sliding
from raceway.theory.bearing import Bearing
from raceway.theory.contact_friction import Surfaces, coefficient, rolling_force
from raceway.theory.lubricant import Fluid
from raceway.theory.lubrication import Film
from raceway.theory.static import Contacts


def of_groove(
    bearing: Bearing,
    side: int,
    contact: Contacts,
    film: Film,
    fluid: Fluid,
    clearance: float,
    surfaces: Surfaces,
    alone: skidding.Unloaded,
) -> Floats:
    """Return (rolling, slip, hysteresis, L_a, mu) of the contacts in a groove of the raceway
    `side`, an array (5, Z): the powers in W, the fraction of the load on asperities and the
    friction coefficient. `alone` describes the balls that touch only the outer ring."""
    live = contact.load > 0
    values = np.zeros((5, len(live)))
    load, a, b = contact.load[live], contact.a[live], contact.b[live]
    speed, turns, h_c = film.entrainment[live], film.rolling[live], film.h_c[live]
    r_x, r_y = bearing.effective_radii(side, contact.angle[live], clearance)
    r_d = sliding.deformed_radius(bearing.groove(side), bearing.ball_radius)

    def resistance(speed):
        return rolling_force(bearing, fluid, surfaces, r_x, r_y, h_c, b, load, speed)

    share = asperity.clarke(film.ratio[live])
    slid = sliding.FREE_SPEED * sliding.edge_slip(speed, a, r_d, r_x)
    friction = coefficient(surfaces, fluid, share, 1.5 * load / (np.pi * a * b), slid, h_c)
    rolled = resistance(speed) * turns
    slid = sliding.free_power(load, friction, speed, a, r_d, r_x)
    part = np.ones(load.shape)  # rotation of the ball as a fraction of its rotation in pure rolling
    past, since, until, frequency = (one[live] for one in alone)
    if np.any((past > 0) & (rolled > friction * load * past)):
        flat = np.cos(contact.angle[live]) * bearing.pitch_radius

        def slowed(part):
            return resistance(speed - past * (1 - part) / 2)

        def slowing(part):
            return slowed(part) * r_x / (bearing.ball_radius * load) - friction

        rate = past / (0.4 * flat)
        part, at_last = (skidding.rotation(slowing, rate, time) for time in (since, until))
        rolled = slowed(part) * turns * part
        slid = np.where(part < 1, friction * load * past * (1 - part), slid)
        # acceleration of returning balls
        slid += 0.2 * load * flat * (1 - at_last) ** 2 * frequency
    values[:, live] = (
        rolled,
        slid,
        part * rolling.hysteresis(load, b, surfaces.loss) * turns / r_x,
        share,
        friction,
    )
    return values
