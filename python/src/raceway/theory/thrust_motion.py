# SPDX-License-Identifier: GPL-2.0-or-later
"""Steady motion of the balls of a single-row bearing under pure thrust, including friction. A
radial load that hardly changes the loads of the balls is neglected.

Under pure thrust all balls move alike, and steadily in the frame that orbits with them. Their state
has seven unknowns: the radial and axial position of a ball, the axial displacement of the ring, the
orbital speed Omega, and the rotation (w_u, w_t, w_e) of a ball about the radial direction u, the
direction t of its path and the bearing's axis e. They follow from seven equations. The forces on a
ball balance along u, t and e, with its centrifugal load; the moments balance its gyroscopic moment,

    M_u = -J Omega w_t,  M_t = J Omega w_u,  M_e = 0;

and the inner contacts carry the thrust. The forces are those of a run in steady motion: contact and
film, sliding along and across the rolling direction, spin, rolling resistance, drag, and the oil at
a cage that is one ring. Nothing is assumed to roll, so the same equations hold for balls that are
held by friction and for balls that skid.

Arrays are (2, n) for the contacts of n states, inner contacts first.
"""

from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from raceway.arrays import Floats, short
from raceway.core import laws
from raceway.errors import NoEquilibrium
from raceway.inputs import Oil
from raceway.theory import (
    asperity,
    attitude,
    cage_drag,
    contact_friction,
    drag,
    film,
    film_gap,
    hertz,
    rolling,
    sliding,
    spin,
)
from raceway.theory.bearing import INNER, OUTER, Bearing, Layout
from raceway.theory.cage_drag import CageRing
from raceway.theory.contact_friction import Surfaces
from raceway.theory.contact_law import FilmInGap
from raceway.theory.friction_torque import Losses
from raceway.theory.lubricant import Fluid
from raceway.theory.lubrication import Lubrication, lubricate, turning
from raceway.theory.static import Equilibrium, contacts
from raceway.theory.steel import STEEL

SIDES = (INNER, OUTER)
OUT = np.array([[-1.0], [1.0]])  # radial direction from ball to raceway at zero contact angle
EXACT = 1e-9  # largest accepted residual, in units of `_Balance.units`
ALIKE = 2e-3  # differences between the loads of balls, relative to the largest, that are ignored
SLOWEST = 1e-3  # fraction of the speed at which the search in `find` gives up


class Motion(NamedTuple):
    """Steady motion of the balls, all of which move alike."""

    state: Equilibrium  # with the loads and angles of the moving balls
    films: Lubrication
    losses: Losses
    orbit: float  # rad/s, orbital speed
    rotation: Floats  # (3,), rad/s, rotation of a ball about u, t and e
    # (7,), left-hand sides of the seven equations: the forces on a ball along u, e and t and the
    # force on the ring divided by the number of balls, all in N, and the moments on a ball about
    # u, t and e in N m
    residual: Floats
    torque: float  # N m, friction torque of the balls on the inner ring
    place: Floats  # (7,), the unknowns in the order above, for a ring that turns at |speed|

    __repr__ = short


class _Touch(NamedTuple):
    """Contacts of balls: geometry, loads, motions relative to the raceway, and the forces and
    couples that resist these motions."""

    cosine: Floats  # components along u and e of the direction from ball to raceway
    sine: Floats
    angle: Floats  # rad
    distance: Floats  # m, from the ball's centre to the centre of curvature
    reach: Floats  # m, distance of the contact from the bearing's axis
    load: Floats  # N
    a: Floats
    b: Floats
    entrainment: Floats  # m/s
    rolling: Floats  # m/s
    friction: Floats
    share: Floats  # fraction of the load carried by asperities
    along: Floats  # N, friction along and across rolling
    across: Floats
    spin: Floats  # N m, couple about the normal
    slip: Floats  # N m, couples about the axis of rolling: differential slip, film, hysteresis
    film: Floats
    steel: Floats
    # sliding speeds in m/s, spin and rolling in rad/s
    slides_along: Floats
    slides_across: Floats
    spins: Floats
    rolls: Floats

    @property
    def couple(self):
        """N m, all couples about the axis of rolling."""
        return self.slip + self.film + self.steel


@dataclass(frozen=True)
class _Balance:
    """A bearing under thrust. The motions y (7, n) are rows (ball's radius, ball's axial position,
    ring's axial position, orbit, w_u, w_t, w_e)."""

    bearing: Bearing
    oil: Oil
    fluid: Fluid
    gap: FilmInGap
    surfaces: Surfaces
    clearance: float
    ring: float  # rad/s
    thrust: float  # N
    density: float
    cage: CageRing | None
    slices: bool

    @property
    def mass(self):
        return 4 / 3 * np.pi * self.bearing.ball_radius**3 * self.density

    @property
    def inertia(self):
        return 0.4 * self.mass * self.bearing.ball_radius**2

    @property
    def units(self):
        """Units (7, 1) of the residuals: the load of a ball and a twentieth of it for friction."""
        load, radius = abs(self.thrust) / self.bearing.balls, self.bearing.ball_radius
        rub = 0.05 * load
        return np.array([load, load, load, rub, *3 * [rub * radius]])[:, None]

    def touch(self, y):
        """Return the `_Touch` of balls in the motions y."""
        body, radius = self.bearing, self.bearing.ball_radius
        rho, place, ring_at, orbit, w_u, w_t, w_e = y
        circle = np.array([[body.groove_circle(side, self.clearance)] for side in SIDES])
        beside = np.array([place - ring_at, place])
        distance = np.hypot(rho - circle, beside)
        cosine, sine = (rho - circle) / distance, beside / distance
        angle = np.arctan2(OUT * sine, OUT * cosine)
        turning = np.array([[self.ring], [0.0]])
        reach = rho + radius * cosine
        roll = radius * (w_e * cosine - w_u * sine)
        slides, across = orbit * rho + roll - turning * reach, -radius * w_t + 0.0 * reach
        speed = np.abs((orbit * rho + roll + turning * reach) / 2 - orbit * reach)
        spins, rolls = w_u * cosine + (w_e - turning) * sine, (w_e - turning) * cosine - w_u * sine

        radii = np.array([body.effective_radii(k, angle[k], self.clearance) for k in SIDES])
        (r_x, r_y), modulus = radii.swapaxes(0, 1), body.effective_modulus
        ellipse = hertz.exact(r_x, r_y)
        law = replace(self.gap, entrainment=speed).law(
            body, angle, self.clearance, hertz.stiffness(ellipse, modulus)
        )
        gaps = np.array([[body.groove_gap(side)] for side in SIDES])
        load = np.maximum(law(distance - gaps).load, 1e-12)
        a, b = hertz.semi_axes(ellipse, modulus, load)
        group = film.group(
            self.oil.viscosity, self.oil.pressure_viscosity, modulus, r_x, ellipse.kappa, speed,
            np.maximum(load, film_gap.CUT),
        )  # fmt: skip
        thinned = self.gap.factor(speed)
        h_c = thinned * film.h_c(r_x, group)
        share = asperity.clarke(film.ratio(thinned * film.h_min(r_x, group), self.oil.roughness))

        r_d = np.array([[sliding.deformed_radius(body.groove(side), radius)] for side in SIDES])
        curve = a**2 / (2 * r_d)
        edge = np.abs(rolls) * curve
        width = np.maximum(edge, sliding.LEAST)
        past = slides - sliding.FREE**2 * rolls * curve  # relative to free rolling
        slid = np.sqrt((sliding.FREE_SPEED * edge) ** 2 + past**2 + across**2)
        friction = contact_friction.coefficient(
            self.surfaces, self.fluid, share, hertz.pressure(ellipse, modulus, load), slid, h_c
        )
        limit, forward = friction * load, np.where(rolls < 0, -1.0, 1.0)
        if self.slices:
            law = spin.with_slip(
                load, friction, a, b, forward * slides, forward * across, spins,
                curve=edge / a**2,
            )  # fmt: skip
            along, beside, couple = forward * law.along, forward * law.across, law.moment
            slip = (law.power - along * slides - beside * across - couple * spins) / rolls
        else:
            law = laws.slip_both_ways(forward * past / width, across / width)
            along, beside = limit * forward * law.along, limit * law.across
            shares = laws.spin_shares(np.abs(spins) * a, width, np.hypot(slides, across))
            couple = np.sign(spins) * shares.spin * spin.moment(load, friction, a, ellipse.second)
            # spin leaves the couple that balances the power of the force at free rolling's slip
            kept = -(sliding.FREE**2) * curve * along
            slip = -limit * law.couple * curve**2 / width * rolls
            slip = kept + shares.slip * (slip - kept)
        # couples are proportional to the speed below 1 mm/s, as in a run
        near = rolls * r_x / np.maximum(np.abs(rolls) * r_x, 1e-3)
        force = contact_friction.rolling_force(
            body, self.fluid, self.surfaces, r_x, r_y, h_c, b, load, speed
        )
        steel = rolling.hysteresis(load, b, self.surfaces.loss)
        return _Touch(
            cosine, sine, angle, distance, reach, load, a, b, speed, np.abs(rolls) * r_x, friction,
            share, along, beside, couple, slip, near * force * r_x, near * steel,
            slides, across, spins, rolls,
        )  # fmt: skip

    def drag(self, y):
        """Return the oil drag (n,) on a ball in N."""
        speed = y[3] * y[0]
        fluid, share = self.fluid, self.surfaces.oil_share
        radius = self.bearing.ball_radius
        return drag.force(radius, speed, fluid.viscosity, fluid.density, share)

    def residual(self, y):
        """Return the left-hand sides (7, n) of the equations, as in `Motion`."""
        one, radius = self.touch(y), self.bearing.ball_radius
        rho, _, _, orbit, w_u, w_t, w_e = y
        force_u = -one.load * one.cosine + one.across * one.sine
        force_e = -one.load * one.sine - one.across * one.cosine
        force_t = -one.along.sum(0) - self.drag(y)
        moment_u = radius * one.along * one.sine - one.spin * one.cosine + one.couple * one.sine
        moment_e = -radius * one.along * one.cosine - one.spin * one.sine - one.couple * one.cosine
        moments = np.array([moment_u.sum(0), radius * one.across.sum(0), moment_e.sum(0)])
        if self.cage is not None:
            found = self._cage(orbit)
            moments -= found.shear * np.array([2 * w_u, w_t, w_e - orbit])
            # the balls drive the cage against its losses and the shear of its pockets
            slide = orbit - cage_drag.guide(self.cage, self.ring)
            held = found.churning + found.land * slide
            force_t -= (held / self.bearing.balls - found.shear * (w_e - orbit)) / rho
        gyro = self.inertia * orbit
        return np.array([
            force_u.sum(0) + self.mass * orbit**2 * rho, force_e.sum(0),
            force_e[INNER] - self.thrust / self.bearing.balls, force_t,
            moments[0] + gyro * w_t, moments[1] - gyro * w_u, moments[2],
        ])  # fmt: skip

    def _cage(self, orbit):
        share = self.surfaces.oil_share
        return cage_drag.resistance(self.bearing, self.cage, self.fluid, share, orbit)

    def cage_power(self, y):
        """Return the power in W dissipated at the cage, or None."""
        if self.cage is None:
            return None
        _, _, _, orbit, w_u, w_t, w_e = y
        found = self._cage(orbit)
        turned = 2 * w_u**2 + w_t**2 + (w_e - orbit) ** 2
        slide = orbit - cage_drag.guide(self.cage, self.ring)
        lost = self.bearing.balls * found.shear * turned + found.land * slide**2
        return float(lost + found.churning * orbit)

    def newton(self, y):
        """Return (motion (7,), largest residual in `units`) near the motion y (7,)."""
        size = np.array([1e-6, 1e-6, 1e-6, 1e-2 * self.ring, *3 * [self.ring]])[:, None]
        y, steps = y[:, None], 1e-6 * size * np.eye(7)
        for _ in range(100):
            found = self.residual(np.hstack([y, y + steps, y - steps])) / self.units
            here, ahead, behind = found[:, :1], found[:, 1:8], found[:, 8:]
            length = np.linalg.norm(here)
            if not np.isfinite(length) or np.abs(here).max() < 1e-3 * EXACT:
                break
            slope = (ahead - behind) / 2e-6
            if not np.all(np.isfinite(slope)):
                break
            step = size * np.linalg.lstsq(slope, -here, rcond=None)[0]
            parts = 0.5 ** np.arange(14)
            tried = y + parts * step
            left = np.linalg.norm(self.residual(tried) / self.units, axis=0)
            better = np.flatnonzero(left < (1 - 1e-4 * parts) * length)
            if not len(better):
                break
            y = tried[:, better[:1]]
        return y[:, 0], float(np.abs(here).max())


def applies(bearing: Bearing, state: Equilibrium) -> bool:
    """Return whether all balls of a single-row bearing carry the same thrust within `ALIKE`, so
    that they move alike."""
    load, angle = state.inner.load, state.inner.angle
    if bearing.layout != Layout() or not np.all(load > 0):
        return False
    spread = max(np.ptp(one) for one in (load, state.outer.load))
    return bool(spread < ALIKE * load.max() and np.all(np.abs(angle) > 1e-6))


def find(
    bearing: Bearing,
    state: Equilibrium,
    oil: Oil,
    fluid: Fluid,
    film: FilmInGap,
    surfaces: Surfaces,
    *,
    near: Motion | None = None,
    clearance: float = 0.0,
    density: float = STEEL.density,
    spin_law: str = "closed",
    cage: CageRing | None = None,
) -> Motion:
    """Return the `Motion` of the balls of a bearing in an `Equilibrium` without friction to which
    this module `applies`. The other arguments are as in `friction_torque.losses` and
    `static.equilibrium`; `film` contains the speed of the inner ring.

    Newton's method starts from the motion `near`, or else from balls that roll. If it fails, the
    motion is followed from a lower speed, at which friction holds the balls, or from a lower
    thrust, at which they slide: in a narrow range of thrusts both motions exist, and either can
    end. Raises `NoEquilibrium` if there is no such motion.
    """
    ring, thrust = abs(film.speed), -float(state.force[2])
    slices = spin_law == "slices"

    def at(part, share=1.0):
        gap = replace(film, speed=part * ring)
        return _Balance(
            bearing, oil, fluid, gap, surfaces, clearance, part * ring, share * thrust, density,
            cage, slices,
        )  # fmt: skip

    def rolled(*parts):
        balance, rest = at(*parts), state
        if min(parts) < 1:
            rest, _ = turning(
                bearing, balance.ring, 0.0, balance.thrust, clearance=clearance,
                ball_density=density, finite_shift=True, film=balance.gap,
            )  # fmt: skip
        return balance.newton(_start(balance, rest))

    y, off = at(1.0).newton(near.place) if near else rolled(1.0)
    if near and off > EXACT:
        y, off = rolled(1.0)
    if off > EXACT:
        y = _followed(at, rolled, 0.5, SLOWEST, slice(3, None))
    if y is None:
        y = _followed(lambda part: at(1.0, part), lambda part: rolled(1.0, part), 0.9, 0.3)
    if y is None:
        raise NoEquilibrium("no steady motion found for balls that slide under a thrust")
    return _motion(at(1.0), y, state, film.speed)


def _followed(at, rolled, less, least, grows=slice(0)):
    """Return the motion (7,) of the balance `at(1)`, followed from the largest part less^n, at
    least `least`, at which Newton's method finds the motion `rolled(part)`. Its values `grows` are
    proportional to the part. It is None if the motion is not found or ends."""
    part, off = 1.0, np.inf
    while off > EXACT and part * less > least:
        part *= less
        y, off = rolled(part)
    step = 1 / less
    while off <= EXACT and part < 1 and step > 1.001:
        ahead = min(1.0, part * step)
        further = y.copy()
        further[grows] *= ahead / part
        there, left = at(ahead).newton(further)
        if left <= EXACT:
            part, y, step = ahead, there, min(1 / less, 1.5 * step)
        else:
            step **= 0.5
    return y if off <= EXACT and part == 1 else None


def _start(balance, state):
    """Return the motion (7,) of balls that roll in an equilibrium without friction and slide across
    their grooves under their gyroscopic moment."""
    body, radius, ring = balance.bearing, balance.bearing.ball_radius, balance.ring
    angle = np.array([state.inner.angle[:1], state.outer.angle[:1]])
    load, a = (
        np.array([getattr(side, name)[:1] for side in (state.inner, state.outer)])
        for name in ("load", "a")
    )
    reach = state.outer.overlap[0] + body.groove_gap(OUTER)
    rho = body.groove_circle(OUTER, balance.clearance) + reach * np.cos(angle[OUTER, 0])
    place = reach * np.sin(angle[OUTER, 0])
    none, turn = attitude.rolling(body, angle, ring)
    y = np.array([rho, place, state.shift[2], none[0, 0], 0.0, 0.0, -2 * ring])
    one = balance.touch(y[:, None])
    r_x, r_y = np.array(
        [body.effective_radii(side, angle[side], balance.clearance) for side in SIDES]
    ).swapaxes(0, 1)
    pure = spin.moment(load, one.friction, a, hertz.exact(r_x, r_y).second)
    r_d = np.array([[sliding.deformed_radius(body.groove(side), radius)] for side in SIDES])
    edge = sliding.edge_slip(one.entrainment, a, r_d, r_x)
    limit = one.friction * load
    held = attitude.balanced(body, angle, ring, limit, a, pure, edge, balance.density)
    x = float(((held.orbit - none[0]) / turn[0])[0])
    sizes = *angle[:, 0], ring, radius, body.pitch_radius
    rolling = laws.rolling_on_both(*sizes, x)
    across = float(np.sign(x) * held.across[0])
    y[3:] = rolling.orbit, x, -across / radius, rolling.axial
    return y


def _motion(balance, y, state, speed):
    """Return the `Motion` of balls in the motion y (7,) of a ring that turns at |`speed`|; the
    rotations are reversed if `speed` is negative."""
    body, one = balance.bearing, balance.touch(y[:, None])
    every = np.ones(len(state.azimuth))
    sides = [
        contacts(body, side, *(value[side] * every for value in (one.distance, one.load,
                 one.angle)), balance.clearance)
        for side in SIDES
    ]  # fmt: skip
    shift = np.array([*state.shift[:2], y[2]])
    moved = replace(state, shift=shift, inner=sides[INNER], outer=sides[OUTER])
    speeds = one.entrainment * every, one.rolling * every
    films = lubricate(
        body, moved, balance.oil, speed, balance.clearance, balance.gap.factor, speeds=speeds
    )
    slid = one.along * one.slides_along + one.across * one.slides_across + one.slip * one.rolls
    powers = one.film * one.rolls, slid, one.spin * one.spins, one.steel * one.rolls
    dragged = balance.drag(y[:, None]) * y[3] * y[0]
    losses = Losses(
        *(power * every for power in powers), dragged * every, balance.cage_power(y),
        one.share * every, one.friction * every,
    )  # fmt: skip
    taken = one.reach * one.along + one.spin * one.sine + one.couple * one.cosine
    way = 1.0 if speed >= 0 else -1.0
    # the mirror image of a motion has the opposite sign of rotations about u and e
    rotation = y[4:] * np.array([way, 1.0, way])
    residual = balance.residual(y[:, None])[:, 0]
    torque = float(-body.balls * taken[INNER, 0])
    return Motion(moved, films, losses, way * float(y[3]), rotation, residual, torque, y)
