# SPDX-License-Identifier: GPL-2.0-or-later
"""A bearing that runs under load: its equilibrium, its films, and the motion and the friction of
its balls."""

from typing import Any, NamedTuple

from raceway.arrays import Floats, short
from raceway.inputs import Oil
from raceway.theory import friction_torque, thrust_motion
from raceway.theory.bearing import Bearing
from raceway.theory.cage_drag import CageRing
from raceway.theory.contact_friction import Surfaces
from raceway.theory.contact_law import FilmInGap
from raceway.theory.friction_torque import Losses
from raceway.theory.lubricant import Fluid
from raceway.theory.lubrication import Lubrication, lubricate, turning
from raceway.theory.static import Equilibrium
from raceway.theory.steel import STEEL
from raceway.theory.thrust_motion import Motion


class Friction(NamedTuple):
    """Surfaces, spin law and cage, which determine the friction (`friction_torque.losses`)."""

    surfaces: Surfaces
    spin_law: str = "closed"
    cage: CageRing | None = None


class Running(NamedTuple):
    """A bearing in equilibrium with its loads, and the films at its speed."""

    bearing: Bearing
    ring: float  # rad/s
    clearance: float  # m
    density: float  # kg/m^3, of the balls
    fluid: Fluid | None
    friction: Friction | None
    rolling: Equilibrium  # without friction, in which balls roll
    rolling_orbit: float | Floats  # rad/s, orbital speed of these balls
    films: Lubrication | None
    motion: Motion | None  # of the balls under pure thrust

    __repr__ = short

    @property
    def state(self) -> Equilibrium:
        """The equilibrium, with friction if balls move under pure thrust."""
        return self.motion.state if self.motion else self.rolling

    @property
    def orbit(self) -> float | Floats:
        """The orbital speed in rad/s of the balls, a single value or (Z,)."""
        return self.motion.orbit if self.motion else self.rolling_orbit

    def losses(self) -> Losses:
        """Return the `Losses` with the given friction."""
        if self.motion:
            return self.motion.losses
        return friction_torque.losses(
            self.bearing,
            self.rolling,
            self.films,
            self.fluid,
            self.ring,
            self.rolling_orbit,
            clearance=self.clearance,
            surfaces=self.friction.surfaces,
            spin_law=self.friction.spin_law,
            ball_density=self.density,
            cage=self.friction.cage,
        )


def find(
    bearing: Bearing,
    ring: float,
    *loads: float,
    oil: Oil | None = None,
    fluid: Fluid | None = None,
    film: FilmInGap | None = None,
    friction: Friction | None = None,
    clearance: float = 0.0,
    density: float = STEEL.density,
    near_motion: Motion | None = None,
    **options: Any,
) -> Running:
    """Find the `Running` bearing whose inner ring turns at `ring` rad/s. Loads, `clearance` and
    `options` are as in `static.equilibrium`. There are films if there is `oil`. With the `film` in
    the gap and `friction`, balls under pure thrust move as in `thrust_motion`, where the search
    starts from `near_motion`. Raises `NoEquilibrium`."""
    state, orbit = turning(
        bearing, ring, *loads, clearance=clearance, ball_density=density, film=film, **options
    )
    motion = None
    free = "z" not in options.get("held", {})
    if film and friction and free and thrust_motion.applies(bearing, state):
        motion = thrust_motion.find(
            bearing,
            state,
            oil,
            fluid,
            film,
            friction.surfaces,
            near=near_motion,
            clearance=clearance,
            density=density,
            spin_law=friction.spin_law,
            cage=friction.cage,
        )
    films = motion and motion.films
    if oil and not films:
        films = lubricate(bearing, state, oil, ring, clearance, film and film.factor)
    return Running(bearing, ring, clearance, density, fluid, friction, state, orbit, films, motion)
