# SPDX-License-Identifier: GPL-2.0-or-later
"""Friction torque of a bearing in static equilibrium. For freely rolling balls, the power
dissipated by all contacts is computed separately for each mechanism, and divided by the speed of
the ring.

rolling
    hydrodynamic rolling resistance: 2 f times the rolling speed, times the factors for inlet shear
    heating and starvation (`rolling`)
slip
    differential slip in free rolling under Coulomb's law (`sliding`), and slip across the grooves
    due to the gyroscopic moment. The coefficient of the film is constant or follows from the Eyring
    stress with its limit (`traction`); asperities carry their fraction of the load with the
    boundary coefficient
spin
    spin about the contact normals, for the ball rotation at which the moments on the ball balance
    (`attitude`). It is computed in closed form, as in a run, or, if `spin_law` is "slices",
    together with slip. A ball that returns to the load zone turns its axis back to that rotation
hysteresis
    hysteresis of the steel (`rolling`)
drag
    drag on the balls in oil and air (`drag`)
cage
    losses of a cage that is one ring: oil in its pockets and at its land, churning, and friction of
    balls that it restrains (`cage_drag`)

A ball that its pocket restrains also slips on both raceways (`excursion`).

A ball with more than two contacts cannot roll on all of them (`ball_motion`). A ball that touches
only the outer ring is slowed by rolling resistance and slides (`skidding`).
"""

from typing import NamedTuple

import numpy as np

from raceway.arrays import Floats, short
from raceway.theory import cage_drag, drag, excursion, skidding, spin_losses
from raceway.theory.bearing import INNER, Bearing, Layout
from raceway.theory.contact_friction import Surfaces
from raceway.theory.lubricant import Fluid
from raceway.theory.lubrication import Lubrication
from raceway.theory.rolling_losses import of_groove
from raceway.theory.static import Equilibrium
from raceway.theory.steel import STEEL

PARTS = ("rolling", "slip", "spin", "hysteresis", "drag", "cage")
SPIN_LAWS = ("closed", "slices")


class Losses(NamedTuple):
    """Losses in W of contacts (C, Z), inner contacts first, of balls (Z,) and of the cage; also
    fractions and coefficients for the contacts (C, Z)."""

    rolling: Floats
    slip: Floats
    spin: Floats
    hysteresis: Floats
    drag: Floats
    cage: float | None  # None if there is no cage or if the cage is a chain of balls
    asperity_share: Floats  # L_a
    friction: Floats  # mu
    advance: excursion.Excursion | None = None  # of the balls of one row, relative to their cage

    __repr__ = short

    @property
    def parts(self) -> dict[str, float]:
        """Power in W dissipated by each mechanism, by name."""
        found = {name: getattr(self, name) for name in PARTS}
        return {name: float(np.sum(of)) for name, of in found.items() if of is not None}

    @property
    def power(self) -> float:
        """Total power in W."""
        return sum(self.parts.values())


def losses(
    bearing: Bearing,
    state: Equilibrium,
    films: Lubrication,
    fluid: Fluid,
    ring: float,
    orbit: float | Floats,
    *,
    clearance: float = 0.0,
    surfaces: Surfaces | None = None,
    spin_law: str = "closed",
    ball_density: float = STEEL.density,
    cage: cage_drag.CageRing | None = None,
) -> Losses:
    """Compute the `Losses` of an `Equilibrium` with its `Lubrication` and `Fluid`. The inner ring
    turns at `ring` rad/s, and the balls orbit at `orbit` rad/s, a single value or (Z,). The
    clearance is in m and `ball_density` in kg/m^3; `cage` is a cage that is one ring, or None. If
    `spin_law` is "closed", the gyroscopic moment is included, and a fit describes how spin and
    differential slip reduce each other. If it is "slices", slip and spin are combined over the
    contact ellipse. Raises `ValueError` for an unknown law."""
    if spin_law not in SPIN_LAWS:
        raise ValueError(f"spin law '{spin_law}' is not one of {', '.join(SPIN_LAWS)}")
    surfaces = surfaces or Surfaces()
    contacts = _by_groove(state.inner) + _by_groove(state.outer)
    wet = _by_groove(films.inner) + _by_groove(films.outer)
    loaded = np.array([one.load > 0 for one in contacts])
    inner = bearing.raceways.count(INNER)
    speed = orbit * bearing.pitch_radius
    unloaded = skidding.unloaded(
        loaded[:inner].any(0),
        state.azimuth,
        bearing.row,
        float(np.mean(orbit)),
        bearing.pitch_radius,
    )
    rows = [
        of_groove(bearing, side, contact, film, fluid, clearance, surfaces, unloaded)
        for side, contact, film in zip(bearing.raceways, contacts, wet)
    ]
    rolled, slid, hysteresis, share, friction = (np.array(part) for part in zip(*rows))
    against = drag.force(
        bearing.ball_radius, speed, fluid.viscosity, fluid.density, surfaces.oil_share
    )
    slid, turned = spin_losses.slip_and_spin(
        bearing,
        contacts,
        wet,
        ring,
        slid,
        share,
        friction,
        fluid=fluid,
        surfaces=surfaces,
        spin_law=spin_law,
        density=ball_density,
        clearance=clearance,
        returns=unloaded.frequency,
    )
    balls = np.broadcast_to(against * speed, len(bearing.row)) + 0.0
    advance, lost = None, None
    if bearing.layout == Layout():
        advance = excursion.excursion(
            bearing,
            state,
            ring,
            friction,
            cage and cage.play or None,
            centred=cage is not None and cage.land is not None,
        )
    if cage is not None:
        pressed = 0.0
        if advance is not None:
            slid += advance.power
            pressed = float(np.abs(advance.forces.sum(0)).sum())
        angles = np.abs([one.angle for one in contacts])[loaded]
        angle = float(angles.mean()) if len(angles) else 0.0
        about = surfaces.oil_share, ring, float(np.mean(orbit)), angle
        lost = cage_drag.power(bearing, cage, fluid, *about, pressed)
    return Losses(rolled, slid, turned, hysteresis, balls, lost, share, friction, advance)


def _by_groove(side):
    """Return a list with one tuple of arrays (Z,) for each groove of `side`."""
    return [type(side)(*one) for one in zip(*map(np.atleast_2d, side))]
