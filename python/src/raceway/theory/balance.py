# SPDX-License-Identifier: GPL-2.0-or-later
"""Equilibrium of the inner ring, found by minimising the energy of the bearing as a function of the
ring's five degrees of freedom; for each position of the ring, the balls are in equilibrium.


Internally, tilts are multiplied by a length and moments are divided by it, so that all five
coordinates are in metres and all five loads in newtons.
"""

from functools import partial
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from raceway.arrays import Floats
from raceway.errors import NoEquilibrium
from raceway.theory import circle, contact_law, hertz, seat
from raceway.theory import clearance as play
from raceway.theory.bearing import INNER, OUTER, Bearing, Layout
from raceway.theory.contact_law import FilmInGap
from raceway.theory.small_motion import condensed


class Here(NamedTuple):
    """State of the bearing at a given position of the ring, with the balls in equilibrium."""

    energy: float  # J, energy up to an additive constant
    gradient: Floats  # (5,), derivative of the energy with respect to the ring's position
    touch: seat.Touch

    def hessian(self, metres: Floats) -> Floats:
        """Return the second derivatives (5, 5) of the energy with respect to the ring's position,
        with tilts multiplied by `metres`."""
        linear = seat.linear(self.touch)
        return condensed(linear.stiffness[linear.loaded]) / np.outer(metres, metres)


class Balance:
    """The equilibrium problem of one bearing under one load, with the stiffness of each contact."""

    def __init__(
        self,
        bearing: Bearing,
        force: Floats,
        moment: ArrayLike,
        held: Floats,
        azimuth: Floats,
        clearance: float,
        centrifugal: Floats,
        finite_shift: bool,
        film: FilmInGap | None = None,
        loose: bool = False,
    ) -> None:
        """Set up the problem. `force` (3,) is in N and `moment` (2,) in N m; `held` (5,) contains
        the imposed displacements in m and rad, and NaN for free directions; `azimuth` (Z,) in rad
        and `centrifugal` (Z,) in N list all balls, row by row. If `loose`, the ring need not be
        carried by a ball."""
        self.bearing, self.clearance, self.azimuth = bearing, clearance, azimuth
        self.centrifugal = np.broadcast_to(np.asarray(centrifugal, float), azimuth.shape)
        self.moment, self.finite_shift = np.asarray(moment, float), finite_shift
        # m per unit of each coordinate
        self.metres = np.array([1.0, 1.0, 1.0, bearing.pitch_radius, bearing.pitch_radius])
        self.free, self.held = np.isnan(held), np.nan_to_num(held) * self.metres
        self.loads = np.concatenate([force, self.moment]) / self.metres
        inner, outer = (bearing.layout.centres(side, bearing.balls) for side in (INNER, OUTER))
        self.reach = partial(
            circle.exact if finite_shift else circle.straight,
            azimuth=azimuth,
            radius=bearing.groove_circle(INNER),
            height=inner,
        )
        self.outer = np.stack(
            [np.full(outer.shape, bearing.groove_circle(OUTER, clearance)), outer], -1
        )
        self.gap = np.array([[bearing.groove_gap(side)] for side in bearing.raceways])
        # m, rounding error of the distances, i.e. a few units in the last place of the radius
        self.digits = 8 * np.spacing(bearing.pitch_radius)
        # m, longest Newton step, small compared with the groove
        self.cap = 0.25 * (bearing.groove_gap(INNER) + bearing.groove_gap(OUTER))
        self.film, self.loose = film, loose
        self._balls: Floats | None = None  # (Z, 2), at the previous position of the ring
        self._bend(np.zeros((len(self.gap), len(azimuth))))

    def start(self) -> Floats:
        """Return a starting position, estimated by moving the ring through the play in the
        direction of the load and adding the approximate compression. Raises `NoEquilibrium` if the
        direction of the displacement is undetermined."""
        loads = np.where(self.free, self.loads, 0)
        size = np.linalg.norm(loads)
        if self.free.any() and not size and not np.any(self.held) and not self.loose:
            if np.all(seat.nearest(self.grooves(self.held))[0] <= self.digits):
                raise NoEquilibrium(
                    "without a load the position of a ring that is not preloaded is indeterminate"
                )
        squeeze = (5 * size / (len(self.azimuth) * self.stiffness.min())) ** (2 / 3)
        direction = loads / size if size else loads
        free = np.zeros(5)
        plain = self.bearing.layout == Layout()
        if plain and 0 < self.clearance <= 2 * play.groove_distance(self.bearing):
            free[:2] = direction[:2] * self.clearance / 2
            free[2] = direction[2] * play.free_endplay(self.bearing, self.clearance) / 2
        return np.where(self.free, free + direction * min(2 * squeeze, self.cap), self.held)

    def find(self, near: tuple[Floats, Floats] | None = None) -> tuple[Floats, Here]:
        """Find a position of stable equilibrium, and return it together with the state of the
        bearing there. The search can start from `near`, i.e. (position (5,) in m and rad, contact
        angles (C, Z)). Raises `NoEquilibrium` if none is found."""
        place = self.start()
        if near is not None:
            place = np.where(self.free, near[0] * self.metres, self.held)
            self._bend(near[1])
        for _ in range(50):
            before, loads, was = self.stiffness, self.loads.copy(), place
            place, here = self.settle(place)
            self._renew(place, here)
            settled = np.all(np.abs(self.stiffness / before - 1) < 1e-12)
            if settled and np.all(
                np.abs(self.loads - loads) <= 1e-12 * np.abs(loads).max(initial=0)
            ):
                break
            # tilts can be so compliant that, in every iteration, rounding errors change the last
            # digits of the stiffness
            if np.all(np.abs(place - was) <= self.digits):
                break
        else:
            raise NoEquilibrium("contact angles and contact stiffness do not converge")
        found = self.at(place)
        if self.free.any() and not found.touch.carried.any() and not self.loose:
            raise NoEquilibrium("no ball carries load: the position of the ring is indeterminate")
        return place, found

    def settle(self, place: Floats) -> tuple[Floats, Here]:
        """Return the position (5,) of a stable equilibrium for the current stiffness, and the state
        of the bearing there."""
        nudged, free = 0, self.free
        here = self.at(place)
        if not free.any():
            return place, here
        for _ in range(300):
            gradient, hessian = here.gradient[free], here.hessian(self.metres)[np.ix_(free, free)]
            size = np.linalg.norm(gradient)
            scale = np.abs(self.loads[free]).max() + here.touch.load.max()
            value, vector = np.linalg.eigh(hessian)
            # the residual may be as large as the rounding error of the distances times the
            # stiffness of the ring or, if only its softer directions are free, of a contact
            stiff = max(np.abs(value).max(), here.touch.along.max())
            if size <= 1e-11 * scale + self.digits * stiff:
                if value[0] >= -1e-9 * value[-1] or nudged == 5:
                    return place, here
                # the ring is balanced on one ball, so let it roll to one side
                place, nudged = place + self._whole(0.01 * self.cap * vector[:, 0]), nudged + 1
                here = self.at(place)
                continue
            floor = max(1e-6 * np.abs(value).max(), size / (100 * self.cap))
            step = -vector @ ((vector.T @ gradient) / np.maximum(np.abs(value), floor))
            step *= min(1, self.cap / np.linalg.norm(step))
            was, (place, here) = place, self._moved(place, here, step)
            if np.array_equal(was, place):
                if size <= 1e-8 * scale:
                    return place, here  # below the rounding error of the energy
                break
            if not np.linalg.norm(place[free]) < self.bearing.ball_radius:
                break
        said = " and moment ({:g}, {:g}) N m".format(*self.moment) if free[3:].any() else ""
        raise NoEquilibrium(
            f"no position of the ring balances radial and axial loads {np.hypot(*self.loads[:2]):g}"
            f" N, {self.loads[2]:g} N{said} with clearance {self.clearance:g} m"
        )

    def grooves(self, place: Floats) -> seat.Grooves:
        """Return the `seat.Grooves` for a given position of the ring."""
        inner = partial(self.reach, place=place / self.metres)
        return seat.Grooves(inner, self.outer, self.gap, self.stiffness, self.centrifugal, self.law)

    def at(self, place: Floats) -> Here:
        """Return the state of the bearing for a given position of the ring."""
        grooves = self.grooves(place)
        ball = self._balls = seat.settle(grooves, self._balls)
        touch = seat.touch(grooves, ball)
        energy = seat.energy(grooves, touch, ball).sum() - self.loads[self.free] @ place[self.free]
        inner = len(touch.reach.distance)
        # a ball with play carries no load at any position
        lies = (touch.load[:inner] > 0).any(0) & (touch.load[inner:] > 0).any(0)
        lies |= self.centrifugal > 0
        touch = touch._replace(load=np.where(lies, touch.load, 0.0))
        slope = touch.reach.slope[..., 2:] / self.metres
        pull = np.einsum("gz,gza->a", touch.load[:inner], slope)
        return Here(energy, pull - self.loads, touch)

    def angles(self, touch: seat.Touch) -> Floats:
        """Return the contact angles (C, Z) in rad, each relative to the axis of its own ring;
        negative zeros are replaced by zeros."""
        inner, outer = touch.reach.section, touch.direction[len(touch.reach.section) :]
        return (
            np.concatenate(
                [
                    np.arctan2(-inner[..., 1], -inner[..., 0]),
                    np.arctan2(outer[..., 1], outer[..., 0]),
                ]
            )
            + 0.0
        )

    def _bend(self, angle):
        """Compute the stiffness and the load law of the contacts at the contact angles (C, Z)."""
        bearing, modulus = self.bearing, self.bearing.effective_modulus
        radii = (
            bearing.effective_radii(side, one, self.clearance)
            for side, one in zip(bearing.raceways, angle)
        )
        self.stiffness = np.array([hertz.stiffness(hertz.exact(*one), modulus) for one in radii])
        self.law = (
            contact_law.hertzian(self.stiffness)
            if self.film is None
            else self.film.law(bearing, angle, self.clearance, self.stiffness)
        )

    def _renew(self, place, here):
        """Update the contact stiffness for the current contact angles, and the components of the
        moment that do work on the tilts for the current axis of the ring."""
        self._bend(self.angles(here.touch))
        if self.finite_shift:
            tilt = (place / self.metres)[3:]
            self.loads[3:] = circle.conjugate(self.moment, tilt) / self.metres[3:]

    def _whole(self, step):
        result = np.zeros(5)
        result[self.free] = step
        return result

    def _moved(self, place, here, step):
        """Return (position, `Here`) after the largest tried fraction of `step` that reduces the
        energy or the residual force, or unchanged if no fraction does."""
        slope, part = here.gradient[self.free] @ step, 1.0
        size = np.linalg.norm(here.gradient[self.free])
        for _ in range(50):
            trial = place + self._whole(part * step)
            there = self.at(trial)
            if (
                there.energy <= here.energy + 1e-4 * part * slope
                or np.linalg.norm(there.gradient[self.free]) < 0.5 * size
            ):
                return trial, there
            part /= 2
        return place, here
