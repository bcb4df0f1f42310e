# SPDX-License-Identifier: GPL-2.0-or-later
"""Losses of balls that spin about their contact normals, because they touch the rings at a contact
angle, and what spin changes in their slip."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from raceway.arrays import Floats
from raceway.core import laws
from raceway.theory import attitude, ball_motion, hertz, sliding, spin, traction
from raceway.theory.bearing import INNER, OUTER, Bearing, Layout
from raceway.theory.contact_friction import Surfaces
from raceway.theory.lubricant import Fluid
from raceway.theory.lubrication import Film
from raceway.theory.static import Contacts


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


def slip_and_spin(
    bearing: Bearing,
    contacts: Sequence[Contacts],
    films: Sequence[Film],
    ring: float,
    slid: Floats,
    share: Floats,
    friction: Floats,
    *,
    fluid: Fluid,
    surfaces: Surfaces,
    spin_law: str,
    density: float,
    clearance: float,
    returns: Floats,
) -> tuple[Floats, Floats]:
    """Return the powers (C, Z) in W of slip and spin. `contacts` and `films` have one entry (Z,)
    for each groove, and `slid` are the powers of slip without spin. `share` and `friction` are the
    fraction of the load on asperities and the friction coefficient (C, Z), and the balls regain
    their load at the rates `returns` (Z,) in 1/s. The other arguments are as in
    `friction_torque.losses`."""
    turned = np.zeros(slid.shape)
    loaded = np.array([one.load > 0 for one in contacts])
    inner = bearing.raceways.count(INNER)
    held = loaded[:inner].any(0) & loaded[inner:].any(0)
    if not np.any(held & (np.abs([one.angle for one in contacts]) > 1e-6)):
        return slid, turned
    slid, two = slid.copy(), held & (loaded.sum(0) == 2)
    pressed = _pressed(bearing, contacts, films, friction, share, clearance)
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
            bearing, both.angle, ring, limit, both.a, both.spin_moment, edge, density
        )
        turned[pair, balls] = motion.moment * np.abs(motion.spin)
        if bearing.layout == Layout():
            turned[inner] += _turned_back(bearing, contacts, ring, motion, balls, returns, density)
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
        slid[live, ball], turned[live, ball] = _several(
            bearing, one, sides, ring, spin_law, fluid, surfaces
        )
    return slid, turned


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
        return ball_motion.driven(bearing, sides, one.angle, ring, weight, _edge(one), one.a)

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
