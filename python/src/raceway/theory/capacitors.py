# SPDX-License-Identifier: GPL-2.0-or-later
"""Both gaps of every ball as capacitors. At a loaded contact, the capacitor consists of the contact
patch and its surroundings; at an unloaded contact, it is a rigid gap. Arrays have one value per
ball, in SI units. The formulas are derived in docs/electric.

A ball between the rings always has both capacitors. An unloaded ball is pressed against the outer
raceway by its centrifugal load Q_u, and its play is the gap to the inner raceway.
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from raceway.arrays import Floats, Numbers
from raceway.inputs import Oil
from raceway.theory import (
    ball_motion,
    capacitance,
    capacitance_outside,
    film,
    groove_width,
    hertz,
    rough_film,
)
from raceway.theory.bearing import INNER, OUTER, Bearing
from raceway.theory.static import Contacts, Equilibrium
from raceway.theory.validity import Shoulders

LEAST = 0.1  # N, lower limit of Q_u for a ball that does not orbit
ROUGHNESS = ("none", "gamma")
# fraction of the gap outside the patch that is filled with oil
WET_SHARE = {"flooded": 1.0, "cavitated": 0.5, "dry": 0.0}


class Filling(NamedTuple):
    """Medium that fills the gaps, and the models of permittivity and roughness."""

    kind: str = "flooded"  # one of `capacitance_outside.FILLS`
    outlet: float = 1.0  # relative permittivity in the outlet of a "cavitated" gap
    permittivity_at: str = "maximum"  # one of `capacitance.PERMITTIVITY_AT`
    # one of `ROUGHNESS`: model of the effect of roughness on the capacitance of the patch
    roughness: str = "none"
    shoulders: Shoulders = Shoulders()


FLOODED = Filling()


class Capacitors(NamedTuple):
    """Capacitors at one raceway, in arrays (Z,) with one value per ball."""

    load: Floats  # N, load of the elastic contact; zero for a rigid gap
    separation: Floats  # m, h_c or, for an unloaded ball, its play
    area: Floats  # m^2, area of the Hertz ellipse
    plates: Floats  # F, capacitance of the Hertz ellipse; zero without load
    outside: Floats  # F, capacitance of the gap around the ellipse
    paths: Floats  # m, resistivity of the oil divided by the resistance of the gap

    @property
    def total(self) -> Floats:
        """Capacitance (Z,) in F of plates and outside in parallel."""
        return self.plates + self.outside

    @property
    def of_balls(self) -> "Capacitors":
        """The grooves (grooves, Z) of a raceway merged into one capacitor per ball (Z,). They are
        in parallel; the result has the largest load and the thinnest film."""
        if self.load.ndim == 1:
            return self
        together = (np.max, np.min, *(np.sum,) * 4)
        return Capacitors(*(join(one, axis=0) for join, one in zip(together, self)))


class BearingCapacitors(NamedTuple):
    """Capacitors at both raceways, and the capacitances of their combinations."""

    inner: Capacitors
    outer: Capacitors

    @property
    def ball(self) -> Floats:
        """Capacitance (Z,) in F of inner and outer capacitor in series."""
        return capacitance.ball(self.inner.total, self.outer.total)

    @property
    def total(self) -> float:
        """Capacitance in F of all balls in parallel."""
        return float(np.sum(self.ball))

    @property
    def plates(self) -> float:
        """Capacitance in F of the ellipses alone, excluding balls that are unloaded on the inner
        raceway (eq 12)."""
        loaded = self.inner.load > 0
        return float(np.sum(self.of_plates[loaded]))

    @property
    def of_plates(self) -> Floats:
        """Capacitance (Z,) in F of the two ellipses alone, in series."""
        return capacitance.ball(self.inner.plates, self.outer.plates)

    @property
    def unloaded(self) -> float:
        """Capacitance in F of the balls that are unloaded on the inner raceway."""
        return float(np.sum(self.ball[self.inner.load <= 0]))


def quiet_load(
    bearing: Bearing, orbit: Numbers, density: float = 7850.0, *, cut: float = 0.0
) -> Numbers:
    """Return the centrifugal load Q_u = m r omega^2 in N of a ball without other load, but at least
    0.1 N. `orbit` is the cage speed in rad/s, and `density` is the density of the ball in kg/m^3.

    A film in the gap has a constant thickness below the load `cut` in N (`film_gap.CUT`), so Q_u is
    at least this load."""
    mass = 4 / 3 * np.pi * bearing.ball_radius**3 * density
    return np.maximum(max(LEAST, cut), mass * bearing.pitch_radius * np.square(orbit))[()]


def of_raceway(
    bearing: Bearing,
    raceway: int,
    permittivity: float,
    load: ArrayLike,
    separation: ArrayLike,
    angle: ArrayLike = 0.0,
    *,
    film_thickness: ArrayLike | None = None,
    play: ArrayLike | None = None,
    filling: Filling = FLOODED,
    roughness: float = 0.0,
    clearance: float = 0.0,
) -> Capacitors:
    """Compute the `Capacitors` at one raceway from the loads (N), separations (m) and contact
    angles (rad) of the balls, which are arrays (Z,), in an oil whose relative `permittivity` at
    ambient pressure is given.

    The gap of an unloaded ball is rigid. Its `play` (m) is by default the separation; it is
    negative if a film separates overlapping bodies. `film_thickness` (m) is the distance between
    the plates, by default the separation. The roughness sigma (m) is used only if `filling`
    requests it; the diametral `clearance` is in m. Raises `ValueError` if a separation is not
    positive or if `filling` contains an unknown word.
    """
    load, separation, angle = np.broadcast_arrays(
        *(np.asarray(value, float) for value in (load, separation, angle))
    )
    _check(filling)
    depth = groove_width.depth(bearing, raceway, filling.shoulders[raceway], clearance)
    film_there = separation if film_thickness is None else np.asarray(film_thickness, float)
    loose = separation if play is None else np.broadcast_to(np.asarray(play, float), load.shape)
    live = load > 0
    ellipse_area, plates, around = (np.zeros(load.shape) for _ in range(3))
    outside = capacitance_outside.fill(permittivity, filling.kind, filling.outlet)

    def shape(which):
        lean = angle[which]
        if np.ptp(lean) == 0:  # all contacts have the same shape
            lean = lean[0]
        return lean, *bearing.effective_radii(raceway, lean, clearance)

    if live.any():
        lean, r_x, r_y = shape(live)
        ellipse, modulus = hertz.exact(r_x, r_y), bearing.effective_modulus
        a, b = hertz.semi_axes(ellipse, modulus, load[live])
        ellipse_area[live] = np.pi * a * b
        pressed = capacitance.film_permittivity(
            permittivity, 1.5 * load[live] / (np.pi * a * b), filling.permittivity_at
        )
        factor = 1.0
        if filling.roughness == "gamma" and roughness > 0:
            factor = rough_film.factor(film_there[live] / roughness)
        widths = groove_width.half_widths(bearing, raceway, depth, lean, clearance, a)
        plates[live] = capacitance.VACUUM * pressed * ellipse_area[live] / film_there[live] * factor
        around[live] = capacitance_outside.loaded(
            ellipse, modulus, r_x, load[live], separation[live], widths
        )
    if not live.all():
        lean, r_x, r_y = shape(~live)
        widths = groove_width.half_widths(bearing, raceway, depth, lean, clearance)
        around[~live] = capacitance_outside.rigid(
            hertz.exact(r_x, r_y),
            r_x,
            bearing.ball_radius,
            bearing.groove(raceway),
            separation[~live],
            widths,
            np.maximum(loose[~live], 0.0),
        )
    return Capacitors(
        load,
        separation,
        ellipse_area,
        plates,
        capacitance.VACUUM * outside * around,
        ellipse_area / film_there + WET_SHARE[filling.kind] * around,
    )


def separation(
    thickness: Callable[[Floats], Floats], load: ArrayLike, play: ArrayLike, quiet: float
) -> Floats:
    """Return the separation in m of a gap, which is continuous when contact is lost or regained. It
    is h_c at the larger of the load and Q_u = `quiet` (N), but at least the `play` (m; negative or
    zero under load).

    `thickness` computes h_c in m from the contact loads in N. All arrays have the same shape.
    """
    load = np.asarray(load, float)
    film_there = thickness(np.maximum(load, quiet))
    return np.where(load > 0, film_there, np.maximum(film_there, play))


def of_statics(
    bearing: Bearing,
    state: Equilibrium,
    oil: Oil,
    speed: float,
    quiet: Numbers,
    *,
    filling: Filling = FLOODED,
    clearance: float = 0.0,
    factor: Callable[[Floats], Floats] | None = None,
    scale: float = 1.0,
) -> BearingCapacitors:
    """Compute the `BearingCapacitors` of an `Equilibrium` with rotating balls, for an inner ring at
    `speed` rad/s.

    `quiet` is the `quiet_load` in N, which is the lower limit of the load on the outer film; if the
    outer ring has two grooves, they share it. `clearance` and `factor` are as in
    `lubrication.lubricate`; `scale` multiplies the thickness of every film. Raises `ValueError` if
    the speed is zero, because there is then no film.
    """
    if not speed:
        raise ValueError("speed = 0 rad/s: balls that do not turn have no film")
    sides = []
    speeds, _ = ball_motion.speeds(bearing, speed, state)
    inner = bearing.raceways.count(INNER)
    for side, contact, drawn in (
        (INNER, state.inner, speeds[:inner]),
        (OUTER, state.outer, speeds[inner:]),
    ):
        drawn = drawn.reshape(contact.load.shape)
        thickness = _thickness(bearing, side, contact, oil, drawn, clearance, factor)
        load = contact.load
        if side == OUTER and load.ndim == 1:
            load = np.maximum(load, quiet)
        own = scale * thickness(np.where(load > 0, load, quiet))
        apart = scale * separation(thickness, load, 0.0, quiet)
        apart = np.where(load > 0, apart, np.maximum(apart, -contact.overlap))
        sides.append(
            of_raceway(
                bearing,
                side,
                oil.permittivity,
                load,
                apart,
                contact.angle,
                film_thickness=own,
                play=-contact.overlap,
                filling=filling,
                roughness=oil.roughness,
                clearance=clearance,
            ).of_balls
        )
    return BearingCapacitors(*sides)


def _thickness(bearing, side, contact: Contacts, oil, speed, clearance, factor):
    r_x, r_y = bearing.effective_radii(side, contact.angle, clearance)
    kappa = hertz.exact(r_x, r_y).kappa
    thinned = 1.0 if factor is None else factor(speed)

    def thickness(load: Numbers) -> Numbers:
        of = bearing.effective_modulus, r_x, kappa, speed, load
        group = film.group(oil.viscosity, oil.pressure_viscosity, *of)
        return thinned * film.h_c(r_x, group)

    return thickness


def _check(filling):
    for name, value, words in (
        ("permittivity_at", filling.permittivity_at, capacitance.PERMITTIVITY_AT),
        ("roughness", filling.roughness, ROUGHNESS),
    ):
        if value not in words:
            raise ValueError(f"{name} '{value}' is not one of {', '.join(words)}")
