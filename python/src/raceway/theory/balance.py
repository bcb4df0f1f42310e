# SPDX-License-Identifier: GPL-2.0-or-later
"""The inner ring's balance: energy of a bearing in the ring's five degrees of freedom, the balls
following, and its minimum.

Inside, tilts are multiplied by a length and moments divided by it, so that all five are metres and
newtons.
"""

from functools import partial

import numpy as np
from numpy.typing import ArrayLike

from raceway.arrays import Floats, Numbers
from raceway.errors import NoEquilibrium
from raceway.theory import circle, contact_law, hertz, seat
from raceway.theory import clearance as play
from raceway.theory.bearing import INNER, OUTER, Bearing
from raceway.theory.contact_law import FilmInGap
from raceway.theory.small_motion import condensed


class Balance:
    """One bearing under one load, for contact stiffness given per raceway and ball."""

    def __init__(
        self,
        bearing: Bearing,
        force: Floats,
        moment: ArrayLike,
        held: Floats,
        azimuth: Floats,
        clearance: float,
        centrifugal: float,
        finite_shift: bool,
        film: FilmInGap | None = None,
    ) -> None:
        """`force` (3,) N, `moment` (2,) N m; `held` (5,) imposed places in m and rad, NaN where the
        ring is free."""
        self.bearing, self.clearance, self.azimuth = bearing, clearance, azimuth
        self.centrifugal, self.moment, self.finite_shift = (
            centrifugal,
            np.asarray(moment, float),
            finite_shift,
        )
        # per unit of place
        self.metres = np.array([1.0, 1.0, 1.0, bearing.pitch_radius, bearing.pitch_radius])
        self.free, self.held = np.isnan(held), np.nan_to_num(held) * self.metres
        self.loads = np.concatenate([force, self.moment]) / self.metres
        self.reach = circle.exact if finite_shift else circle.straight
        self.gap = np.array([bearing.groove_gap(side) for side in (INNER, OUTER)])
        self.outer = np.tile([bearing.groove_circle(OUTER, clearance), 0.0], (len(azimuth), 1))
        # m: distances are known to some last digits of the radius
        self.digits = 8 * np.spacing(bearing.pitch_radius)
        self.cap = 0.25 * self.gap.sum()  # longest Newton step, m: small against the groove
        self.film = film
        self._bend(np.zeros((2, len(azimuth))))

    def start(self) -> Floats:
        """A place that takes up the play toward the load, plus a first guess of the squeeze."""
        loads = np.where(self.free, self.loads, 0)
        size = np.linalg.norm(loads)
        squeeze = (5 * size / (len(self.azimuth) * self.stiffness.min())) ** (2 / 3)
        direction = loads / size if size else loads
        free = np.zeros(5)
        if 0 < self.clearance <= 2 * play.groove_distance(self.bearing):
            free[:2] = direction[:2] * self.clearance / 2
            free[2] = direction[2] * play.free_endplay(self.bearing, self.clearance) / 2
        return np.where(self.free, free + direction * min(2 * squeeze, self.cap), self.held)

    def find(self) -> Floats:
        """The place of a stable equilibrium. Raises `NoEquilibrium`."""
        place = self.start()
        for _ in range(50):
            before, loads, was = self.stiffness, self.loads.copy(), place
            place = self.settle(place)
            self._renew(place)
            settled = np.all(np.abs(self.stiffness / before - 1) < 1e-12)
            if settled and np.all(
                np.abs(self.loads - loads) <= 1e-12 * np.abs(loads).max(initial=0)
            ):
                return place
            # tilts can be so soft that what is left to rounding keeps the stiffness from repeating
            # to the last digits
            if np.all(np.abs(place - was) <= self.digits):
                return place
        raise NoEquilibrium("contact angles and contact stiffness do not settle")

    def settle(self, place: Floats) -> Floats:
        """Place (5,) of a stable equilibrium for the present stiffness."""
        nudged, free = 0, self.free
        if not free.any():
            return place
        for _ in range(300):
            gradient, hessian, load = self.derivatives(place)
            gradient, hessian = gradient[free], hessian[np.ix_(free, free)]
            size, scale = np.linalg.norm(gradient), np.abs(self.loads[free]).max() + load.max()
            value, vector = np.linalg.eigh(hessian)
            # what is left may be the last digits of the distances, times the stiffness
            if size <= 1e-11 * scale + self.digits * np.abs(value).max():
                if value[0] >= -1e-9 * value[-1] or nudged == 5:
                    return place
                # a ring balanced on one ball: let it roll to one side
                place, nudged = place + self._whole(0.01 * self.cap * vector[:, 0]), nudged + 1
                continue
            floor = max(1e-6 * np.abs(value).max(), size / (100 * self.cap))
            step = -vector @ ((vector.T @ gradient) / np.maximum(np.abs(value), floor))
            step *= min(1, self.cap / np.linalg.norm(step))
            moved = place + self._whole(self._part(place, step, gradient, size) * step)
            if np.array_equal(moved, place):
                if size <= 1e-8 * scale:
                    return place  # rounding: the energy cannot tell any more
                break
            place = moved
            if not np.linalg.norm(place[free]) < self.bearing.ball_radius:
                break
        said = " and moment ({:g}, {:g}) N m".format(*self.moment) if free[3:].any() else ""
        raise NoEquilibrium(
            f"no place of the ring balances radial and axial load {np.hypot(*self.loads[:2]):g} N, "
            f"{self.loads[2]:g} N{said} with clearance {self.clearance:g} m"
        )

    def balls(self, place: Floats) -> tuple[seat.Grooves, Floats, seat.Touch]:
        """The balls' `Grooves` and `Touch` with the ring at a place."""
        ring = place / self.metres
        inner = partial(
            self.reach, place=ring, azimuth=self.azimuth, radius=self.bearing.groove_circle(INNER)
        )
        grooves = seat.Grooves(
            inner, self.outer, self.gap, self.stiffness, self.centrifugal, self.law
        )
        ball = seat.settle(grooves)
        touch = seat.touch(grooves, ball)
        if self.centrifugal == 0:  # a ball with play touches nothing, wherever it was put
            touch = touch._replace(load=np.where(touch.load.min(0) > 0, touch.load, 0.0))
        return grooves, ball, touch

    def energy(self, place: Floats) -> float:
        """J, up to a constant."""
        grooves, ball, _ = self.balls(place)
        return seat.energy(grooves, ball).sum() - self.loads[self.free] @ place[self.free]

    def derivatives(self, place: Floats) -> tuple[Floats, Floats, Floats]:
        """Gradient (5,) and Hessian (5, 5) of the energy in the ring's place, the balls following;
        contact loads (2, Z)."""
        grooves, _, touch = self.balls(place)
        slope = touch.reach.slope[:, 2:] / self.metres
        gradient = np.einsum("z,za->a", touch.load[INNER], slope) - self.loads
        linear = seat.linear(grooves, touch)
        reduced = condensed(linear.stiffness[linear.loaded])
        return gradient, reduced / np.outer(self.metres, self.metres), touch.load

    def angles(self, touch: seat.Touch) -> Floats:
        """Contact angles (2, Z), rad, each against its own ring; no minus zero."""
        inner, outer = touch.reach.section, touch.direction[OUTER]
        return (
            np.array([np.arctan2(-inner[:, 1], -inner[:, 0]), np.arctan2(outer[:, 1], outer[:, 0])])
            + 0.0
        )

    def ellipse(self, side: int, angle: Numbers) -> hertz.Ellipse:
        """`hertz.Ellipse` of the contacts of one raceway."""
        return hertz.exact(*self.bearing.effective_radii(side, angle, self.clearance))

    def _bend(self, angle):
        """Stiffness and law of the contacts at contact angles (2, Z)."""
        self.stiffness = self._stiffness(angle)
        self.law = (
            contact_law.hertzian(self.stiffness)
            if self.film is None
            else self.film.law(self.bearing, angle, self.clearance, self.stiffness)
        )

    def _stiffness(self, angle):
        return np.array(
            [
                hertz.stiffness(self.ellipse(side, angle[side]), self.bearing.effective_modulus)
                for side in (INNER, OUTER)
            ]
        )

    def _renew(self, place):
        """Contact stiffness of the present angles; the moment's part along the tilts of the present
        axis."""
        self._bend(self.angles(self.balls(place)[2]))
        if self.finite_shift:
            tilt = (place / self.metres)[3:]
            self.loads[3:] = circle.conjugate(self.moment, tilt) / self.metres[3:]

    def _whole(self, step):
        result = np.zeros(5)
        result[self.free] = step
        return result

    def _part(self, place, step, gradient, size):
        """How much of a step brings the energy, or the force left, down; 0 for none."""
        here, slope, part = self.energy(place), gradient @ step, 1.0
        for _ in range(50):
            trial = place + self._whole(part * step)
            if (
                self.energy(trial) <= here + 1e-4 * part * slope
                or np.linalg.norm(self.derivatives(trial)[0][self.free]) < 0.5 * size
            ):
                return part
            part /= 2
        return 0.0
