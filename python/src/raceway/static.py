# SPDX-License-Identifier: GPL-2.0-or-later
"""Quasi-static equilibrium of a whole bearing under radial and axial load (Harris 2006; Jones 1960).

Written from theory, without a look at the simulation it is compared with.

The outer ring is fixed. Each ball stays at its azimuth (the cage's work) and is free in the plane through the
bearing's axis, between an outer and an inner groove; the contact angles follow. Every contact is an elastic spring
in a convex distance, so the balls and then the ring minimise a convex energy, and Newton's method with a line
search needs no luck in its start. Contact stiffness depends weakly on the contact angle and is renewed outside
that minimisation.

The theory moves each inner groove by delta_r cos(psi), as if its circle were straight over the shift. With
`finite_shift` the circle stays a circle, as in a simulation: at 5 kN that takes 0.4 % off the load of a 6208's ball
80 degrees from the load line and adds 0.07 % on it. A ring resting on one ball is then unstable and rolls sideways.

Left out: friction, gyroscopic moments, tilt of the rings.
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from raceway import clearance as play
from raceway import hertz, seat
from raceway.bearing import INNER, OUTER
from raceway.errors import NoEquilibrium


class Contacts(NamedTuple):
    """One raceway's contacts, arrays of one value a ball; zero load where there is none."""

    overlap: np.ndarray  # m
    load: np.ndarray  # N
    angle: np.ndarray  # rad, positive where the inner ring is pushed to +z
    a: np.ndarray  # m, across the groove
    b: np.ndarray  # m, along rolling
    pressure: np.ndarray  # Pa


@dataclass(frozen=True)
class Equilibrium:
    """Where the bearing rests."""

    shift: np.ndarray  # (3,), m: inner ring against outer
    azimuth: np.ndarray  # (Z,), rad
    inner: Contacts
    outer: Contacts
    residual: float  # N, what is left of the force balance on the ring


def equilibrium(bearing, radial_load, axial_load=0.0, *, clearance=0.0, load_azimuth=0.0, phase=0.0,
                orbital_speed=0.0, ball_density=7800.0, finite_shift=False):
    """`Equilibrium` of `bearing` under loads in N on the inner ring, toward `load_azimuth` (rad) and +z.

    `clearance` is diametral, m; `phase` the azimuth of the first ball, rad, or of every ball when they are not evenly
    spaced (Z,); `orbital_speed` of the balls, rad/s,
    gives each the centrifugal load m r omega^2 with m from `ball_density` in kg/m^3; `finite_shift` see above.
    Raises `NoEquilibrium` when the ring is free to move or the balls are forced out of their grooves.
    """
    loads = np.array([radial_load * np.cos(load_azimuth), radial_load * np.sin(load_azimuth), axial_load], float)
    if not (np.all(np.isfinite(loads)) and np.isfinite(clearance) and np.isfinite(orbital_speed)):
        raise NoEquilibrium(f"loads {radial_load} N, {axial_load} N, clearance {clearance} m and orbital speed "
                            f"{orbital_speed} rad/s must be finite")
    if not np.any(loads) and clearance >= 0:
        raise NoEquilibrium("without a load nothing says where a ring with clearance sits")
    system = _System(bearing, loads, clearance, phase, orbital_speed, ball_density, finite_shift)
    shift = system.start()
    for _ in range(50):
        before = system.stiffness
        shift = system.settle(shift)
        system.renew_stiffness(shift)
        if np.all(np.abs(system.stiffness / before - 1) < 1e-12):
            return system.state(shift)
    raise NoEquilibrium("contact angles and contact stiffness do not settle")


class _System:
    """The energy of the bearing for contact stiffness given per raceway and ball."""

    def __init__(self, bearing, loads, clearance, phase, orbital_speed, ball_density,
                 finite_shift):
        self.bearing, self.loads, self.clearance, self.finite_shift = bearing, loads, clearance, finite_shift
        even = 2 * np.pi * np.arange(bearing.balls) / bearing.balls
        self.azimuth = np.asarray(phase, float) if np.ndim(phase) else phase + even
        self.cos, self.sin = np.cos(self.azimuth), np.sin(self.azimuth)
        self.gap = np.array([bearing.groove_gap(side) for side in (INNER, OUTER)])
        mass = 4 / 3 * np.pi * bearing.ball_radius**3 * ball_density
        self.centrifugal = mass * bearing.pitch_radius * orbital_speed**2
        self.stiffness = self._stiffness(np.zeros((2, bearing.balls)))
        self.outer_centre = np.tile([bearing.groove_circle(OUTER, clearance), 0.0], (bearing.balls, 1))
        self.cap = 0.25 * self.gap.sum()  # longest Newton step, m: small against the groove

    def _stiffness(self, angle):
        return np.array([hertz.stiffness(self._ellipse(side, angle[side]), self.bearing.effective_modulus)
                         for side in (INNER, OUTER)])

    def _ellipse(self, side, angle):
        return hertz.exact(*self.bearing.effective_radii(side, angle, self.clearance))

    def renew_stiffness(self, shift):
        _, _, touch, _ = self._balls(shift)
        self.stiffness = self._stiffness(self._angles(touch.direction))

    @staticmethod
    def _angles(direction):
        """Contact angles (2, Z) of unit vectors (2, Z, 2) from ball to raceway."""
        return np.array([np.arctan2(-direction[INNER, :, 1], -direction[INNER, :, 0]),
                         np.arctan2(direction[OUTER, :, 1], direction[OUTER, :, 0])]) + 0.0  # no minus zero

    def start(self):
        """A shift that takes up the play toward the load, plus a first guess of the squeeze."""
        size = np.linalg.norm(self.loads)
        squeeze = (5 * size / (self.bearing.balls * self.stiffness.min())) ** (2 / 3)
        direction = self.loads / size if size else np.zeros(3)
        free = np.zeros(3)
        if 0 < self.clearance <= 2 * play.groove_distance(self.bearing):
            free[:2] = direction[:2] * self.clearance / 2
            free[2] = direction[2] * play.free_endplay(self.bearing, self.clearance) / 2
        return free + direction * min(2 * squeeze, self.cap)

    def _inner_centre(self, shift):
        """Centres (Z, 2) of the inner groove in each ball's plane, and their derivatives (Z, 2, 3)."""
        circle = self.bearing.groove_circle(INNER)
        sideways = (-shift[0] * self.sin + shift[1] * self.cos) * self.finite_shift
        chord = np.sqrt(np.maximum(circle**2 - sideways**2, (0.1 * circle) ** 2))
        centre = np.stack([shift[0] * self.cos + shift[1] * self.sin + chord, np.full_like(chord, shift[2])], 1)
        slope = np.zeros((len(chord), 2, 3))
        slope[:, 0, 0] = self.cos + sideways / chord * self.sin
        slope[:, 0, 1] = self.sin - sideways / chord * self.cos
        slope[:, 1, 2] = 1
        return centre, slope

    def _balls(self, shift):
        """The balls' `Grooves`, places and `Touch`, and the grooves' derivatives in the shift."""
        centre, slope = self._inner_centre(shift)
        grooves = seat.Grooves(np.stack([centre, self.outer_centre]), self.gap, self.stiffness, self.centrifugal)
        ball = seat.settle(grooves)
        touch = seat.touch(grooves, ball)
        if self.centrifugal == 0:  # a ball with play touches nothing, wherever it was put
            touch = touch._replace(load=np.where(touch.load.min(0) > 0, touch.load, 0.0))
        return grooves, ball, touch, slope

    def _energy(self, shift):
        grooves, ball, *_ = self._balls(shift)
        return seat.energy(grooves, ball).sum() - self.loads @ shift

    def _derivatives(self, shift):
        """Gradient (3,) and Hessian (3, 3) of the energy in the ring's shift, the balls following."""
        grooves, _, touch, slope = self._balls(shift)
        load, pull = touch.load, -touch.load[INNER, :, None] * touch.direction[INNER]
        gradient = np.einsum("zi,zij->j", pull, slope) - self.loads
        each = seat.hessian(grooves, touch)
        live = load[INNER] > 0
        inner, both = each[INNER, live], each[:, live].sum(0)
        reduced = inner - inner @ np.linalg.solve(both, inner)
        hessian = np.einsum("zia,zij,zjb->ab", slope[live], reduced, slope[live])
        if self.finite_shift:
            side = np.stack([-self.sin, self.cos, np.zeros_like(self.sin)], 1)
            hessian -= np.einsum("z,za,zb->ab", pull[:, 0] / self.bearing.groove_circle(INNER), side, side)
        return gradient, hessian, load

    def settle(self, shift):
        """Shift (3,) in m of a stable equilibrium for the present stiffness."""
        nudged = 0
        for _ in range(300):
            gradient, hessian, load = self._derivatives(shift)
            size = np.linalg.norm(gradient)
            value, vector = np.linalg.eigh(hessian)
            if size <= 1e-11 * (np.abs(self.loads).max() + load.max()):
                if value[0] >= -1e-9 * value[-1] or nudged == 5:
                    return shift
                # a ring balanced on one ball: let it roll to one side
                shift, nudged = shift + 0.01 * self.cap * vector[:, 0], nudged + 1
                continue
            floor = max(1e-6 * np.abs(value).max(), size / (100 * self.cap))
            step = -vector @ ((vector.T @ gradient) / np.maximum(np.abs(value), floor))
            step *= min(1, self.cap / np.linalg.norm(step))
            here, slope, part = self._energy(shift), gradient @ step, 1.0
            for _ in range(50):
                trial = shift + part * step
                if (self._energy(trial) <= here + 1e-4 * part * slope
                        or np.linalg.norm(self._derivatives(trial)[0]) < 0.5 * size):
                    break
                part /= 2
            else:
                if size <= 1e-8 * (np.abs(self.loads).max() + load.max()):
                    return shift  # rounding: the energy cannot tell any more
                break
            shift = trial
            if not np.linalg.norm(shift) < self.bearing.ball_radius:
                break
        raise NoEquilibrium(f"no place of the ring balances radial and axial load {np.hypot(*self.loads[:2]):g} N, "
                            f"{self.loads[2]:g} N with clearance {self.clearance:g} m")

    def state(self, shift):
        _, _, touch, _ = self._balls(shift)
        angle, load = self._angles(touch.direction), touch.load
        sides = []
        for side in (INNER, OUTER):
            ellipse, modulus = self._ellipse(side, angle[side]), self.bearing.effective_modulus
            a, b = hertz.semi_axes(ellipse, modulus, load[side])
            if np.any(a >= self.bearing.groove(side)) or np.any((load[side] > 0) & (np.cos(angle[side]) <= 0)):
                raise NoEquilibrium(f"the load forces balls out of the {('inner', 'outer')[side]} groove: contact "
                                    f"angle {np.degrees(np.abs(angle[side]).max()):.0f} degrees, contact half-width "
                                    f"{a.max():.2g} m in a groove of radius {self.bearing.groove(side):g} m")
            overlap = np.where(load[side] > 0, touch.distance[side] - self.gap[side], 0.0)
            sides.append(Contacts(overlap, load[side], angle[side], a, b,
                                  hertz.pressure(ellipse, modulus, load[side])))
        residual = float(np.linalg.norm(self._derivatives(shift)[0]))
        return Equilibrium(shift, self.azimuth, *sides, residual)
