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

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from raceway.arrays import Floats, short
from raceway.core import laws
from raceway.theory import (
    asperity,
    attitude,
    ball_motion,
    cage_drag,
    drag,
    excursion,
    film_factors,
    hertz,
    oil_supply,
    rolling,
    skidding,
    sliding,
    spin,
    traction,
)
from raceway.theory.bearing import INNER, OUTER, Bearing, Layout
from raceway.theory.lubricant import Fluid
from raceway.theory.lubrication import Lubrication
from raceway.theory.makers import Size
from raceway.theory.static import Equilibrium

PARTS = ("rolling", "slip", "spin", "hysteresis", "drag", "cage")
SPIN_LAWS = ("closed", "slices")


@dataclass(frozen=True)
class Surfaces:
    """Parameters of the friction laws other than geometry, loads and oil."""

    boundary: float = 0.12  # boundary friction coefficient mu_b in running (SKF)
    film: float | None = 0.05  # traction coefficient of the film; None: from the Eyring stress
    loss: float = 0.016  # hysteresis loss factor alpha, typically 0.005 to 0.05
    oil_share: float = 0.05  # fraction of the space around the balls that is filled with oil
    inlet: float = 0.0  # inlet length of rolling contacts, in multiples of b; 0: fully flooded
    starvation: float = 1.0  # factor on the hydrodynamic couple


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


class _Pressed(NamedTuple):
    """Data of the contacts (C, Z), i.e. C grooves for each of Z balls."""

    load: Floats
    angle: Floats
    a: Floats
    b: Floats
    speed: Floats  # entrainment speed, m/s
    friction: Floats
    r_x: Floats
    r_d: Floats
    spin_moment: Floats  # N m, Coulomb's moment of pure spin
    h_c: Floats
    share: Floats  # L_a


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
    ball_density: float = 7800.0,
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
        _one(bearing, side, contact, film, fluid, clearance, surfaces, unloaded)
        for side, contact, film in zip(bearing.raceways, contacts, wet)
    ]
    rolled, slid, hysteresis, share, friction = (np.array(part) for part in zip(*rows))
    against = drag.force(
        bearing.ball_radius, speed, fluid.viscosity, fluid.density, surfaces.oil_share
    )
    turned = np.zeros(slid.shape)
    held = loaded[:inner].any(0) & loaded[inner:].any(0)
    two = held & (loaded.sum(0) == 2)
    tilted = np.any(held & (np.abs([one.angle for one in contacts]) > 1e-6))
    if tilted:
        pressed = _pressed(bearing, contacts, wet, friction, share, clearance)
        pair = np.array([np.argmax(loaded[:inner], 0), inner + np.argmax(loaded[inner:], 0)])
        balls = np.flatnonzero(two)
        pair = pair[:, two]
        both = _Pressed(*(value[pair, balls] for value in pressed))
        at, turn = rates = [one[1:] for one in attitude.rolling(bearing, both.angle, ring)]
        # spin of a ball that does not spin at the other raceway
        alone = at - turn * (at / turn)[::-1]
        both = _sheared(both, _free(both), alone, fluid, surfaces)
        if spin_law == "closed":
            limit, edge = both.friction * both.load, _edge(both)
            motion = attitude.balanced(
                bearing, both.angle, ring, limit, both.a, both.spin_moment, edge, ball_density
            )
            turned[pair, balls] = motion.moment * np.abs(motion.spin)
            if bearing.layout == Layout():
                back = contacts, ring, motion, balls, unloaded.frequency, ball_density
                turned[inner] += _turned_back(bearing, *back)
            slid[pair, balls] *= spin.closed_slip(motion.spin * both.a, edge)
            slid[pair, balls] += motion.force * motion.across
        else:
            for k, ball in enumerate(balls):
                place = pair[:, k], ball
                slid[place], turned[place] = _together(both, rates, k)
        for ball in np.flatnonzero(held & ~two):
            live = loaded[:, ball]
            one = _Pressed(*(value[live, ball] for value in pressed))
            sides = np.array(bearing.raceways)[live]
            found = _several(bearing, one, sides, ring, spin_law, fluid, surfaces)
            slid[live, ball], turned[live, ball] = found
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


def _turned_back(bearing, contacts, ring, motion, balls, frequency, density):
    """Return the power (Z,) in W of balls that regain their load at the rates `frequency` (Z,) in
    1/s, in a bearing with one row and one groove per ring. Without load they roll on the outer
    raceway about the bearing's axis. In the load zone, friction turns them to the rotation of the
    ball with the largest load, one of `balls` in the `motion` of `attitude`. It dissipates J/2
    (change of rotation)^2, as if a body at rest were set on a moving belt."""
    top = balls[np.argmax(contacts[0].load[balls])]
    radial, orbit = (one[balls == top] for one in (motion.radial, motion.orbit))
    inner, outer = (one.angle for one in contacts)
    sizes = ring, bearing.ball_radius, bearing.pitch_radius
    axial = laws.rolling_on_both(inner[top], outer[top], *sizes, radial).axial
    alone = -orbit * bearing.pitch_radius / (bearing.ball_radius * np.cos(outer))
    inertia = 8 / 15 * np.pi * bearing.ball_radius**5 * density
    return inertia / 2 * (radial**2 + (axial - alone) ** 2) * frequency


def _by_groove(side):
    """Return a list with one tuple of arrays (Z,) for each groove of `side`."""
    return [type(side)(*one) for one in zip(*map(np.atleast_2d, side))]


def _pressed(bearing, contacts, films, friction, share, clearance):
    rows = []
    each = zip(bearing.raceways, contacts, films, friction, share)
    for side, one, film, mu, asperities in each:
        r_x, r_y = bearing.effective_radii(side, one.angle, clearance)
        r_d = sliding.deformed_radius(bearing.groove(side), bearing.ball_radius)
        moment = spin.moment(one.load, mu, one.a, hertz.exact(r_x, r_y).second)
        ellipse = (one.load, one.angle, one.a, one.b, film.entrainment)
        rows.append((*ellipse, mu, r_x, r_d + 0 * r_x, moment, film.h_c, asperities))
    return _Pressed(*(np.array(part) for part in zip(*rows)))


def _edge(pressed):
    return sliding.edge_slip(pressed.speed, pressed.a, pressed.r_d, pressed.r_x)


def _free(pressed):
    return sliding.free_slip(pressed.speed, pressed.a, pressed.r_d, pressed.r_x)


def _sheared(pressed, along, rate, fluid, surfaces):
    """Return `_Pressed` with the film friction at a slip (m/s) and a spin (rad/s), because these
    shear the film more than differential slip alone."""
    if surfaces.film is not None:
        return pressed
    curve = pressed.speed / (2 * pressed.r_d * pressed.r_x)
    ellipse = pressed.load, pressed.a, pressed.b, pressed.h_c
    film = traction.combined(fluid, *ellipse, along, rate, curve)
    mu = traction.mixed(pressed.share, surfaces.boundary, film)
    return pressed._replace(friction=mu, spin_moment=pressed.spin_moment * mu / pressed.friction)


def surfaces(
    bearing: Bearing,
    size: Size | None,
    fluid: Fluid,
    ring: float,
    models: str = "full",
    supply: oil_supply.Supply = oil_supply.BATH,
) -> Surfaces:
    """Return the `Surfaces` for the `models` of a run, full or eyring. The inlet, the oil fraction
    and SKF's starvation factor are those of a `supply` for an inner ring that turns at `ring`
    rad/s. If the `size` of the bearing is not given, the starvation factor is 1."""
    found = oil_supply.numbers(supply, bearing, fluid.density)
    starved = 1.0
    if size is not None:
        mm, rpm = (1e3 * size.bore, 1e3 * size.outside), abs(ring) * 30 / np.pi
        starved = laws.skf_starvation(*mm, fluid.kinematic, rpm, found.replenishment, size.slender)
    return Surfaces(
        film=None if models == "eyring" else Surfaces.film,
        starvation=float(starved),
        oil_share=found.share,
        inlet=found.inlet,
    )


def coefficient(
    surfaces: Surfaces, fluid: Fluid, share: Floats, pressure: Floats, slid: Floats, h_c: Floats
) -> Floats:
    """Return the friction coefficient mu of contacts whose asperities carry the fraction `share` of
    the load. Films of thickness h_c (m) are sheared at the sliding speed `slid` in m/s, under the
    largest `pressure` in Pa."""
    smooth = surfaces.film
    if smooth is None:
        smooth = traction.coefficient(
            fluid.viscosity,
            fluid.pressure_viscosity,
            pressure,
            slid / h_c,
            fluid.eyring_stress,
            fluid.limiting_traction,
        )
    return traction.mixed(share, surfaces.boundary, smooth)


def rolling_force(
    bearing: Bearing,
    fluid: Fluid,
    surfaces: Surfaces,
    r_x: Floats,
    r_y: Floats,
    h_c: Floats,
    b: Floats,
    load: Floats,
    speed: Floats,
) -> Floats:
    """Return the force 2 f in N that resists rolling at the entrainment `speed` in m/s, which is
    reduced by inlet shear heating, starvation and a short inlet. The effective radii, the film h_c
    and the semi-axis b are in m, and the load is in N."""
    loading = film_factors.thermal_loading(
        fluid.temperature_viscosity, fluid.viscosity, speed, fluid.conductivity
    )
    inlet = rolling.inlet(surfaces.inlet, h_c, b, r_x) if len(b) else 1.0
    factor = rolling.inlet_shear(loading) * surfaces.starvation * inlet
    oil, modulus = fluid.viscosity, bearing.effective_modulus
    return 2 * factor * rolling.hydrodynamic(oil, modulus, r_x, r_y, speed, load)


def _one(bearing, side, contact, film, fluid, clearance, surfaces, alone):
    """Return (rolling, slip, hysteresis, L_a, mu) of the contacts in a groove, an array (5, Z)."""
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


def _together(both, rates, ball):
    """Return the (slip, spin) powers of one ball at both raceways, for the rotation with the
    smallest total loss, at which the moments balance. The slip along rolling is chosen such that no
    force remains."""
    at, turn = (one[:, ball] for one in rates)
    bounds = -at / turn  # rotations for which there is no spin at one of the raceways
    tried = np.linspace(*bounds, 17)
    one = _Pressed(*(value[:, ball] for value in both))
    curve = one.speed / (2 * one.r_d * one.r_x)

    def of(side, turned):
        rate = at[side] + turn[side] * turned
        found = spin.free_slip(
            one.load[side], one.friction[side], one.a[side], one.b[side], rate, curve[side]
        )
        return np.array([found.power - found.moment * rate, found.moment * rate])

    lost = sum(of(side, tried).sum(0) for side in (INNER, OUTER))
    best = min(max(int(np.argmin(lost)), 1), len(tried) - 2)
    before, middle, after = lost[best - 1 : best + 2]
    bend = before - 2 * middle + after
    off = 0.5 * (before - after) / bend if bend > 0 else 0.0
    step = tried[1] - tried[0]
    least = tried[best] + step * np.clip(off, -1.0, 1.0)
    return np.array([of(side, np.array([least]))[:, 0] for side in (INNER, OUTER)]).T


def _several(bearing, one, sides, ring, spin_law, fluid, surfaces):
    """Return the (slip, spin) powers (C,) of one ball with more than two contacts. The motion is
    that of `ball_motion` or, with slices, the motion at which the forces and moments of slip and
    spin balance."""
    lines, goal, _ = ball_motion.rates(bearing, sides, one.angle, ring)

    def least(one):
        weight = np.concatenate([one.friction * one.load, one.spin_moment])
        return ball_motion.least(lines, goal, weight, bearing.ball_radius)

    # direction in which the surface of the ball moves past the contact
    way = np.where(sides == INNER, 1.0, -1.0) * np.sign(ring)
    size = np.array([bearing.ball_radius, bearing.ball_radius, 1.0])

    def rates(motion):
        slide, rate = np.split(lines @ motion - goal, 2)
        return _free(one) + way * slide, rate

    one = _sheared(one, *rates(least(one)), fluid, surfaces)
    motion, limit = least(one), one.friction * one.load

    if spin_law == "closed":
        slide, rate = rates(motion)
        slid = sliding.heathcote(slide, one.load, one.friction, one.speed, one.a, one.r_d, one.r_x)
        return slid.power, np.abs(rate) * one.spin_moment
    curve = one.speed / (2 * one.r_d * one.r_x)

    from scipy.optimize import root  # loading it takes longer than a summary of a run

    def resist(motion):
        each = zip(one.load, one.friction, one.a, one.b, *rates(motion), curve)
        return [
            spin.with_slip(*four, slide, 0.0, rate, curve=bend) for *four, slide, rate, bend in each
        ]

    def pushed(scaled):
        found = resist(scaled / size)
        forces = [way * [one.along for one in found], [one.moment for one in found]]
        return np.concatenate(forces) @ lines / size / limit.max()

    balanced = root(pushed, motion * size).x / size
    turned = np.array([one.moment for one in resist(balanced)]) * rates(balanced)[1]
    return np.array([one.power for one in resist(balanced)]) - turned, turned
