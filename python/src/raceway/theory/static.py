# SPDX-License-Identifier: GPL-2.0-or-later
"""Quasi-static equilibrium of a whole bearing in five degrees of freedom (Jones 1960; Harris 2006,
ch. 7).

The module is based on theory alone and is independent of the simulation with which it is compared.

The outer ring is fixed. The inner ring carries a force and two moments; each of its three
displacements (x, y, z) and two tilts (rx, ry) is either free or held. Each ball stays at its
azimuth, where the cage holds it. It is free to move in the plane through the outer ring's axis,
between an outer and an inner groove, and the contact angles follow. Every contact is an elastic
spring whose length is a convex function of the position. The balls, and then the ring, therefore
minimise a convex energy, and Newton's method with a line search converges from any starting point.
The contact stiffness depends weakly on the contact angle and is updated outside that minimisation.

By default, as in the literature, each inner groove moves by the components of shift and tilt in the
plane of the ball (Harris, ch. 7), as if its circle were locally straight. With `finite_shift` the
circle is shifted and tilted but remains a circle, as in a simulation. In a 6208 at 5 kN, this
reduces the load of the ball at 80 degrees from the load line by 0.4 % and increases that of the
ball on the load line by 0.07 %. A ring that rests on one ball is then unstable and rolls sideways.

A bearing may have several rows of balls, and several grooves for each ball (`bearing.Layout`). A
ball then presses on each groove that it reaches, and moves from one to another without a jump.

Friction, gyroscopic moments and bending of the rings are neglected.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from raceway.arrays import Floats, short
from raceway.errors import NoEquilibrium
from raceway.theory import hertz, seat
from raceway.theory.balance import Balance
from raceway.theory.bearing import INNER, OUTER, Bearing
from raceway.theory.contact_law import FilmInGap
from raceway.theory.small_motion import Linear
from raceway.theory.steel import STEEL

FREEDOMS = ("x", "y", "z", "rx", "ry")
STRAIGHT = {"rx": 0.0, "ry": 0.0}
LIGHT = 0.01  # fraction of the largest load; the contact angles at smaller loads are ignored


class Contacts(NamedTuple):
    """Contacts of one raceway, in arrays with one value per ball (Z,), row after row. If the
    raceway has several grooves, the arrays are (grooves, Z) in the order of its `bearing.Layout`.
    The load is zero where there is no contact."""

    # m, overlap of the rigid bodies. It is negative if a film bridges a gap, minus the play for a
    # ball that its centrifugal load holds on the outer raceway, and zero for a ball that is not
    # held
    overlap: Floats
    load: Floats  # N, contact load
    angle: Floats  # rad, contact angle, positive if the inner ring is pushed towards +z
    a: Floats  # m, semi-axis across the groove
    b: Floats  # m, semi-axis along rolling
    pressure: Floats  # Pa, largest pressure in the contact ellipse

    __repr__ = short

    @property
    def heavy(self) -> Floats:
        """True for contacts whose load exceeds the fraction `LIGHT` of the largest load. The other
        contacts may belong to balls that are wedged between the outer groove and the edge of the
        inner groove by their centrifugal load, at any angle."""
        return self.load > LIGHT * self.load.max()


@dataclass(frozen=True)
class Equilibrium:
    """Equilibrium of a bearing."""

    shift: Floats  # (3,), m, displacement of the inner ring relative to the outer ring
    azimuth: Floats  # (Z,), rad, azimuths of the balls
    inner: Contacts
    outer: Contacts
    # N, residual force in the free degrees of freedom, with moments divided by the pitch radius
    residual: float
    # (2,), rad, tilts about x and y: arcsines of -e_y and e_x, where e is the ring's axis
    tilt: Floats
    force: Floats  # (3,), N, force of the balls on the inner ring
    moment: Floats  # (3,), N m, moment of this force about the ring's centre
    # (5, 5), N/m, N/rad, N m/rad, derivative of the load with respect to the position in x, y, z,
    # rx, ry for the current contact ellipses
    stiffness: Floats
    linear: Linear  # linearisation about the equilibrium of the balls, for `small_motion.response`

    __repr__ = short


def equilibrium(
    bearing: Bearing,
    radial_load: float = 0.0,
    axial_load: float = 0.0,
    *,
    moment: ArrayLike | None = None,
    held: Mapping[str, float] | None = None,
    clearance: float = 0.0,
    load_azimuth: float = 0.0,
    phase: float | Floats = 0.0,
    orbital_speed: float | Floats = 0.0,
    ball_density: float = STEEL.density,
    finite_shift: bool = False,
    film: FilmInGap | None = None,
    near: Equilibrium | None = None,
    loose: bool = False,
    checked: bool = True,
) -> Equilibrium:
    """Find the `Equilibrium` of `bearing` under a radial load in the direction `load_azimuth` (rad)
    and an axial load along +z, both in N on the inner ring.

    `moment` is (M_x, M_y) in N m on the inner ring. `held` maps degrees of freedom (x, y, z in m,
    rx, ry in rad) to the values at which they are held; the others are free. If `held` is not
    given, the ring is free to tilt if a `moment` (even zero) is given, and is otherwise held
    untilted (rx = ry = 0). `clearance` is diametral in m. `phase` is the azimuth in rad of the
    first ball of each row or, if the balls are not evenly spaced, the azimuths of all balls (Z,).
    `orbital_speed` in rad/s, one value for all balls or one for each (Z,), adds the centrifugal
    load m r omega^2, where m follows from `ball_density` in kg/m^3. `finite_shift` is explained
    above; `film` adds the film in the gap. If a nearby equilibrium `near` is given, the search
    starts from it. Raises `NoEquilibrium` if the ring is free to move, unless it may be `loose`, or
    if balls are forced out of their grooves, unless this is not `checked`, as on the way to an
    equilibrium of several bearings. Raises `ValueError` for an unknown degree of freedom.

    >>> from raceway.theory.bearing import Bearing
    >>> b = Bearing(9, 12.6e-3, 24.0e-3, 36.6e-3, 6.552e-3, 6.552e-3)
    >>> rest = equilibrium(b, 2000.0, 1000.0, moment=(10.0, 0.0), clearance=10e-6)
    >>> rest.inner.load.round(1).tolist()  # N
    [1156.1, 717.2, 527.7, 553.2, 400.8, 138.9, 142.2, 596.7, 1195.1]
    >>> (1e6 * rest.shift).round(2).tolist(), (1e3 * rest.tilt).round(4).tolist()  # um, mrad
    ([23.82, -11.44, 120.01], [1.6603, 2.2876])
    >>> rest = equilibrium(b.four_point(0.61), axial_load=1000.0)
    >>> (rest.inner.load[:, 0] / rest.inner.load.max()).round(6).tolist()  # by groove
    [0.0, 1.0]
    """
    if not isinstance(bearing, Bearing):
        raise TypeError(
            f"bearing is {bearing!r}; it must be a Bearing, such as raceway.inputs.bearing('6208')"
        )
    force = np.array(
        [radial_load * np.cos(load_azimuth), radial_load * np.sin(load_azimuth), axial_load], float
    )
    if held is None:
        held = STRAIGHT if moment is None else {}
    couple = np.zeros(2) if moment is None else np.asarray(moment, float)
    place, given = imposed(held), np.concatenate([force, couple])
    if not np.all(np.isfinite([*given, clearance, *np.ravel(orbital_speed)])):
        raise NoEquilibrium(
            f"loads {force} N, moments {couple} N m, clearance {clearance} m and orbital speed"
            f" {orbital_speed} rad/s must be finite"
        )
    even = 2 * np.pi * np.arange(bearing.balls) / bearing.balls
    azimuth = np.asarray(phase, float) if np.ndim(phase) else phase + even
    azimuth = np.tile(azimuth, len(bearing.row) // len(azimuth))
    mass = 4 / 3 * np.pi * bearing.ball_radius**3 * ball_density
    centrifugal = mass * bearing.pitch_radius * np.square(orbital_speed)

    def found(near):
        balance = Balance(
            bearing, force, couple, place, azimuth, clearance, centrifugal, finite_shift, film,
            loose,
        )  # fmt: skip
        return _state(balance, *balance.find(near and _place(near)), checked)

    try:
        return found(near)
    except NoEquilibrium:
        if near is None:
            raise
        return found(None)


def _place(state):
    angles = [np.atleast_2d(side.angle) for side in (state.inner, state.outer)]
    return np.concatenate([state.shift, state.tilt]), np.concatenate(angles)


def contacts(
    bearing: Bearing,
    raceway: int,
    distance: Floats,
    load: Floats,
    angle: Floats,
    clearance: float = 0.0,
    *,
    held: bool | Floats = False,
    checked: bool = True,
) -> Contacts:
    """Return the `Contacts` of balls at `distance` (m) from the centres of curvature, under `load`
    (N) at `angle` (rad), in arrays of equal shape; `held` marks unloaded balls that have a definite
    position. If `checked`, raises `NoEquilibrium` if the balls are forced out of their grooves."""
    if checked and np.any((load > 0) & (np.cos(angle) < -0.7)):
        raise NoEquilibrium(
            f"balls lie against the far side of the {('inner', 'outer')[raceway]} groove: the play"
            f" is more than 2 (r_c - R_b) = {2 * bearing.groove_gap(raceway):g} m"
        )
    ellipse = hertz.exact(*bearing.effective_radii(raceway, angle, clearance))
    modulus, groove = bearing.effective_modulus, bearing.groove(raceway)
    a, b = hertz.semi_axes(ellipse, modulus, load)
    out = np.any(a >= groove) or np.any((load > LIGHT * load.max()) & (np.cos(angle) <= 0))
    if checked and out:
        raise NoEquilibrium(
            f"the load forces balls out of the {('inner', 'outer')[raceway]} groove: contact "
            f"angle {np.degrees(np.abs(angle).max()):.0f} degrees, contact half-width "
            f"{a.max():.2g} m in a groove of radius {groove:g} m"
        )
    overlap = np.where((load > 0) | held, distance - bearing.groove_gap(raceway), 0.0)
    return Contacts(overlap, load, angle, a, b, hertz.pressure(ellipse, modulus, load))


def imposed(held: Mapping[str, float]) -> Floats:
    """Return the displacements (5,) in m and rad that `held` imposes, with NaN for free degrees of
    freedom. Raises `ValueError` for an unknown degree of freedom or a value that is not finite."""
    if unknown := sorted(set(held) - set(FREEDOMS)):
        raise ValueError(
            f"held: {', '.join(map(str, unknown))} is not a degree of freedom; choose from"
            f" {', '.join(FREEDOMS)}"
        )
    place = np.array([held.get(name, np.nan) for name in FREEDOMS], float)
    if not all(np.isfinite(value) for value in held.values()):
        raise ValueError(f"held = {held}: values must be finite")
    return place


def _state(balance, place, here, checked):
    bearing, touch = balance.bearing, here.touch
    angle, ring = balance.angles(touch), place / balance.metres
    sides = []
    for side in (INNER, OUTER):
        own = [k for k, raceway in enumerate(bearing.raceways) if raceway == side]
        own = own[0] if len(own) == 1 else own
        found = (one[own] for one in (touch.distance, touch.load, angle))
        held = balance.centrifugal > 0
        sides.append(contacts(bearing, side, *found, balance.clearance, held=held, checked=checked))
    each = touch.load[: len(touch.reach.line), :, None] * touch.reach.line
    return Equilibrium(
        ring[:3],
        balance.azimuth,
        *sides,
        float(np.linalg.norm(here.gradient[balance.free])),
        ring[3:],
        each.sum((0, 1)),
        np.cross(touch.reach.arm, each).sum((0, 1)),
        here.hessian(np.ones(5)),
        seat.linear(touch),
    )
