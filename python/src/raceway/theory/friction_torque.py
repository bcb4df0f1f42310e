# SPDX-License-Identifier: GPL-2.0-or-later
"""Friction torque of a bearing at rest in its loads: the power each contact loses while its balls
roll freely, by part, over the speed of the ring.

rolling     hydrodynamic, 2 f u times the factors of inlet shear and starvation (`rolling`)
slip        differential slip in free rolling: Eyring's stress with its limit in the film's share of
            the load, Coulomb's with the boundary coefficient in the asperities' (`sliding`)
spin        about the contact normals, at the raceway that holds the ball less (`spin`); or, with
            `spin_law` "slices", shared by both, together with slip
hysteresis  of the steel (`rolling`)
drag        of the balls in oil and air (`drag`)
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from scipy.optimize import brentq

from raceway.arrays import Floats
from raceway.theory import (
    asperity,
    drag,
    film_factors,
    hertz,
    lubricant,
    makers,
    rolling,
    sliding,
    spin,
    traction,
)
from raceway.theory.bearing import INNER, OUTER, Bearing
from raceway.theory.lubricant import Fluid
from raceway.theory.lubrication import Lubrication
from raceway.theory.static import Equilibrium

PARTS = ("rolling", "slip", "spin", "hysteresis", "drag")
SPIN_LAWS = ("closed", "slices")


@dataclass(frozen=True)
class Surfaces:
    """What the laws take beside geometry, loads and oil."""

    boundary: float = 0.12  # mu_b, running (SKF)
    loss: float = 0.01  # alpha of hysteresis, 0.005 to 0.05
    oil_share: float = 0.1  # of the space the balls move in
    starvation: float = 1.0  # factor on the hydrodynamic couple


class Losses(NamedTuple):
    """W, of contacts (2, Z) and of balls (Z,); shares and coefficients of the contacts (2, Z)."""

    rolling: Floats
    slip: Floats
    spin: Floats
    hysteresis: Floats
    drag: Floats
    asperity_share: Floats  # L_a
    friction: Floats  # mu that Coulomb's law would need for this slip

    @property
    def parts(self) -> dict[str, float]:
        """Power of each part in W."""
        return {name: float(np.sum(getattr(self, name))) for name in PARTS}

    @property
    def power(self) -> float:
        """W."""
        return sum(self.parts.values())


def losses(
    bearing: Bearing,
    state: Equilibrium,
    films: Lubrication,
    fluid: Fluid,
    ring: float,
    orbit: float,
    *,
    clearance: float = 0.0,
    surfaces: Surfaces | None = None,
    spin_law: str = "closed",
) -> Losses:
    """`Losses` of an `Equilibrium` with its `Lubrication` and the `Fluid` of it; inner ring at
    `ring` and balls around it at `orbit` rad/s, clearance in m. `spin_law` "closed" adds Coulomb's
    moment of pure spin to differential slip, "slices" takes both together over the contact ellipse.
    ValueError for another law."""
    if spin_law not in SPIN_LAWS:
        raise ValueError(f"spin law '{spin_law}' is none of {', '.join(SPIN_LAWS)}")
    surfaces = surfaces or Surfaces()
    sides = [
        _side(bearing, side, contact, film, fluid, clearance, surfaces)
        for side, contact, film in ((INNER, state.inner, films.inner), (OUTER, state.outer,
                                                                        films.outer))
    ]  # fmt: skip
    rolled, slid, hysteresis, share, friction = (np.array(part) for part in zip(*sides))
    speed = orbit * bearing.pitch_radius
    against = drag.force(
        bearing.ball_radius, speed, fluid.viscosity, fluid.density, surfaces.oil_share
    )
    both = (state.inner.load > 0) & (state.outer.load > 0)
    turned = np.zeros((2, bearing.balls))
    if np.any(both & (np.abs(state.inner.angle) > 1e-6)):
        rates = _spin_rates(bearing, state, ring, orbit)
        if spin_law == "closed":
            turned = np.where(both, _spin(bearing, state, friction, rates, clearance), 0.0)
        else:
            for ball in np.flatnonzero(both):
                slid[:, ball], turned[:, ball] = _together(
                    bearing, state, films, friction, rates, clearance, ball
                )
    balls = np.full(bearing.balls, against * speed)
    return Losses(rolled, slid, turned, hysteresis, balls, share, friction)


def starvation(boundary: makers.Boundary, fluid: Fluid, ring: float) -> float:
    """SKF's phi_rs of a bearing with an oil bath or jet, the inner ring at `ring` rad/s."""
    rpm = abs(ring) * 30 / np.pi
    return float(makers.skf(boundary, 1.0, 0.0, rpm, fluid.kinematic).starvation)


def _side(bearing, side, contact, film, fluid, clearance, surfaces):
    live = contact.load > 0
    values = np.zeros((5, len(live)))
    load, a, b = contact.load[live], contact.a[live], contact.b[live]
    speed, h_c = film.entrainment[live], film.h_c[live]
    r_x, r_y = bearing.effective_radii(side, contact.angle[live], clearance)
    r_d = sliding.deformed_radius(bearing.groove(side), bearing.ball_radius)
    force = rolling.hydrodynamic(fluid.viscosity, bearing.effective_modulus, r_x, r_y, speed, load)
    loading = film_factors.thermal_loading(
        fluid.temperature_viscosity, fluid.viscosity, speed, fluid.conductivity
    )
    factor = film_factors.murch_wilson(loading) * surfaces.starvation
    share = asperity.zhou_hoeprich(film.ratio[live])
    unit = sliding.free_power(load, 1.0, speed, a, r_d, r_x)
    smooth = [
        _film_slip(fluid, *one, r_d) for one in zip(load, speed, h_c, a, b, np.broadcast_to(r_x,
                                                                                  load.shape))
    ]  # fmt: skip
    slid = traction.mixed(share, surfaces.boundary * unit, np.array(smooth))
    values[:, live] = (
        2 * force * speed * factor,
        slid,
        rolling.hysteresis(load, b, surfaces.loss) * speed / r_x,
        share,
        slid / unit,
    )
    return values


def _film_slip(fluid, load, speed, h_c, a, b, r_x, r_d):
    """Power in W of differential slip under Eyring's stress with its limit, without a force."""

    def law(pressure, slid):
        eta = lubricant.roelands(fluid.viscosity, fluid.pressure_viscosity, pressure)
        limit = fluid.limiting_traction * pressure
        return traction.eyring(eta, slid, h_c, fluid.eyring_stress, limit)

    def of(slip):
        return sliding.quadrature(law, slip, load, speed, a, b, r_d, r_x, 60)

    edge = sliding.edge_slip(speed, a, r_d, r_x)
    return of(brentq(lambda slip: of(slip).force, 0.0, edge, xtol=1e-4 * edge)).power


def _spin_rates(bearing, state, ring, orbit):
    """Spin of ball less ring in rad/s at both raceways, (2, Z), for one rotation of the ball that
    rolls at both; and its change with 1 rad/s of the one rotation that keeps it rolling."""
    inner, outer = state.inner.angle, state.outer.angle
    radius, pitch = bearing.ball_radius, bearing.pitch_radius
    # in the cage's frame, (radial, axial)
    relative = ring - orbit
    rates = []
    for radial in (0.0, 1.0):
        axial = (radial * np.sin(inner) * radius - relative * (pitch - radius * np.cos(inner))) / (
            radius * np.cos(inner)
        )
        rates.append(
            (
                -radial * np.cos(inner) - (axial - relative) * np.sin(inner),
                radial * np.cos(outer) + (axial + orbit) * np.sin(outer),
            )
        )
    at = np.array(rates[0])
    return at, np.array(rates[1]) - at


def _spin(bearing, state, friction, rates, clearance):
    """Spin power (2, Z): of all rotations of the ball that roll at both raceways, the one that
    loses least holds it at one raceway and spins at the other."""
    moments = []
    for side, contact in ((INNER, state.inner), (OUTER, state.outer)):
        ellipse = hertz.exact(*bearing.effective_radii(side, contact.angle, clearance))
        moments.append(spin.moment(contact.load, friction[side], contact.a, ellipse.second))
    at, turn = rates
    tried = []
    for holds in (INNER, OUTER):
        spins = at - turn * at[holds] / turn[holds]
        tried.append(np.abs(spins) * np.array(moments))
    return np.where(tried[0].sum(0) < tried[1].sum(0), tried[0], tried[1])


def _together(bearing, state, films, friction, rates, clearance, ball):
    """(slip, spin) of one ball, powers at both raceways: the rotation at which both together lose
    least is that at which their moments balance. Slip along rolling leaves no force."""
    at, turn = (one[:, ball] for one in rates)
    bounds = -at / turn  # without spin at one raceway
    tried = np.linspace(*bounds, 17)
    sides = (
        (INNER, state.inner, films.inner),
        (OUTER, state.outer, films.outer),
    )

    def of(side, contact, film, turned):
        r_x, _ = bearing.effective_radii(side, contact.angle, clearance)
        r_d = sliding.deformed_radius(bearing.groove(side), bearing.ball_radius)
        a, speed = contact.a[ball], film.entrainment[ball]
        curve = speed / (2 * r_d * np.broadcast_to(r_x, contact.load.shape)[ball])
        rate = at[side] + turn[side] * turned
        found = spin.free_slip(
            contact.load[ball], friction[side][ball], a, contact.b[ball], rate, curve
        )
        return np.array([found.power - found.moment * rate, found.moment * rate])

    lost = sum(of(*side, tried).sum(0) for side in sides)
    best = min(max(int(np.argmin(lost)), 1), len(tried) - 2)
    before, middle, after = lost[best - 1 : best + 2]
    bend = before - 2 * middle + after
    off = 0.5 * (before - after) / bend if bend > 0 else 0.0
    step = tried[1] - tried[0]
    least = tried[best] + step * np.clip(off, -1.0, 1.0)
    return np.array([of(*side, np.array([least]))[:, 0] for side in sides]).T
