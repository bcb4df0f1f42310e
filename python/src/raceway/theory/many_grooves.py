# SPDX-License-Identifier: GPL-2.0-or-later
"""Equilibrium of a ring with several rows of balls, or with several grooves for each ball: double
row and four-point contact ball bearings.

As `static`: the outer ring is fixed, balls stay at their azimuths and are free in the plane through
the bearing's axis, contacts are Hertz springs, and displacements are small. A ball may press on
each groove of a ring. The energy of all contacts is convex, so Newton's method finds its one
minimum, and a ball changes from groove to groove without a jump.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from raceway.arrays import Floats
from raceway.errors import NoEquilibrium
from raceway.theory import circle, contact_law, hertz
from raceway.theory.bearing import INNER, OUTER, Bearing
from raceway.theory.small_motion import Linear, condensed
from raceway.theory.static import STRAIGHT, Contacts, contacts, imposed

RENEWALS, STEPS = 60, 400  # of contact stiffness, and of Newton's method with each
EXACT = 1e-9  # of the loads, what may be left of the balance
ARRANGEMENTS = {"back_to_back": 1.0, "face_to_face": -1.0}


@dataclass(frozen=True)
class Row:
    """Balls on one circle, and their grooves."""

    bearing: Bearing
    at: float = 0.0  # m, of the balls' plane along the axis, from the point where loads act
    # m, of the centres of the grooves from that plane along the axis
    inner: tuple[float, ...] = (0.0,)
    outer: tuple[float, ...] = (0.0,)
    clearance: float = 0.0  # m, diametral
    phase: float = 0.0  # rad, azimuth of the first ball


class Carried(NamedTuple):
    """A row in balance: contacts by groove and ball, (grooves, Z)."""

    inner: Contacts
    outer: Contacts
    azimuth: Floats  # (Z,), rad, of the balls
    # of the balls about their rest, for `small_motion.response`: inner grooves, then outer ones
    linear: Linear


@dataclass(frozen=True)
class Rest:
    """Where the ring rests."""

    place: Floats  # (5,), m and rad: x, y, z, rx, ry of the inner ring
    rows: list[Carried]
    force: Floats  # (5,), N and N m: of the balls on the inner ring
    stiffness: Floats  # (5, 5), at the present contact ellipses
    residual: float  # what is left of the balance over the loads


def four_point(bearing: Bearing, angle: float, clearance: float = 0.0) -> list[Row]:
    """The row of a four-point contact bearing: two grooves a ring, that at -z first, which balls
    meet at `angle` (rad) when nothing pushes. Of `bearing` it has balls, pitch and groove radii.
    `clearance` is diametral, m; negative is preload on all four points.

    Raises `ValueError` for an angle that is not above 0 and below a right one.
    """
    if not 0 < angle < np.pi / 2:
        raise ValueError(f"angle {angle:g} rad must lie between 0 and pi/2")
    gap = [bearing.groove_gap(side) for side in (INNER, OUTER)]
    inside = bearing.pitch_radius + gap[INNER] * np.cos(angle) - bearing.inner_groove
    outside = bearing.pitch_radius - gap[OUTER] * np.cos(angle) + bearing.outer_groove
    both = [(-size * np.sin(angle), size * np.sin(angle)) for size in gap]
    shape = replace(bearing, inner_radius=float(inside), outer_radius=float(outside))
    return [Row(shape, 0.0, *both, clearance=clearance)]


def double_row(
    bearing: Bearing,
    spacing: float,
    angle: float,
    preload: float = 0.0,
    arrangement: str = "back_to_back",
) -> list[Row]:
    """Two rows `spacing` (m) apart that meet at the free contact `angle` (rad) of `bearing`, 0 of
    deep grooves. `preload` in m is how far each row is pushed together along the axis after first
    contact. Raises `ValueError` for an arrangement that is none.
    """
    if arrangement not in ARRANGEMENTS:
        raise ValueError(f"arrangement '{arrangement}' is none of {', '.join(ARRANGEMENTS)}")
    reach = (bearing.groove_gap(INNER) + bearing.groove_gap(OUTER)) * np.sin(angle) + preload
    way = ARRANGEMENTS[arrangement]
    return [Row(bearing, -way * spacing / 2 * s, inner=(s * reach,)) for s in (1, -1)]


def equilibrium(
    rows: Sequence[Row],
    force: ArrayLike = (0.0, 0.0, 0.0),
    moment: ArrayLike | None = None,
    *,
    held: Mapping[str, float] | None = None,
    orbital_speed: float = 0.0,
    ball_density: float = 7800.0,
) -> Rest:
    """`Rest` of a ring on `rows` under a `force` (3,) in N and a `moment` (2,) in N m.

    `held` maps degrees of freedom to the values they are held at. Without it tilts are held at 0,
    or free when a moment, zero perhaps, is given. `orbital_speed` in rad/s gives balls their
    centrifugal load. Raises `NoEquilibrium` when the rows cannot hold the loads.

    >>> b = Bearing(9, 12.6e-3, 24.0e-3, 36.6e-3, 6.552e-3, 6.552e-3)
    >>> rest = equilibrium(four_point(b, 0.61), (0.0, 0.0, 1000.0))
    >>> (rest.rows[0].inner.load[:, 0] / rest.rows[0].inner.load.max()).round(6).tolist()
    [0.0, 1.0]
    """
    if held is None:
        held = STRAIGHT if moment is None else {}
    couple = (0.0, 0.0) if moment is None else moment
    loads = np.concatenate([np.asarray(force, float), np.asarray(couple, float)])
    if not np.all(np.isfinite(loads)):
        raise NoEquilibrium(f"loads {loads} must be finite")
    whole = [_Row(row, orbital_speed, ball_density) for row in rows]
    return _Ring(whole, loads, imposed(held)).find()


class _Row:
    """A row with the stiffness of its contacts."""

    def __init__(self, row, orbital_speed, density):
        self.row, bearing = row, row.bearing
        self.azimuth = row.phase + 2 * np.pi * np.arange(bearing.balls) / bearing.balls
        mass = 4 / 3 * np.pi * bearing.ball_radius**3 * density
        self.centrifugal = mass * bearing.pitch_radius * orbital_speed**2
        radius = bearing.groove_circle(OUTER, row.clearance)
        middle = (bearing.groove_circle(INNER) + radius) / 2
        self.start = np.tile([middle, 0.0], (bearing.balls, 1))
        self.centres = [np.array([radius, offset]) for offset in row.outer]
        count = bearing.balls
        self.bend(*(np.zeros((len(one), count)) for one in (row.inner, row.outer)))

    def bend(self, *angles):
        """Renew the stiffness of the contacts at their angles (grooves, Z), inner and outer."""
        bearing = self.row.bearing
        self.stiffness = []
        for side, angle in zip((INNER, OUTER), angles):
            radii = bearing.effective_radii(side, angle, self.row.clearance)
            self.stiffness.append(hertz.stiffness(hertz.exact(*radii), bearing.effective_modulus))

    def angles(self, ball, place):
        """Of all contacts, loaded or not: an angle that came with the load would not settle."""
        sides = ([], [])
        for side, *_, angle in self.contacts(ball, place):
            sides[side].append(angle)
        return [np.array(one) for one in sides]

    def contacts(self, ball, place):
        """(side, `contact_law.Response` (Z,), distance (Z,), its derivatives (Z, 7), (Z, 7, 7),
        angle (Z,)) of every groove."""
        bearing, result = self.row.bearing, []
        for k, offset in enumerate(self.row.inner):
            lever = self.row.at + offset
            turn = np.eye(5)
            turn[0, 4], turn[1, 3] = lever, -lever
            seen = ball - [0.0, offset]
            one = circle.straight(seen, turn @ place, self.azimuth, bearing.groove_circle(INNER))
            both = np.eye(7)
            both[2:, 2:] = turn
            angle = np.arctan2(-one.section[:, 1], -one.section[:, 0])
            curve = both.T @ one.curve @ both
            result.append((INNER, k, one.distance, one.slope @ both, curve, angle))
        for k, centre in enumerate(self.centres):
            arm = ball - centre
            distance = np.maximum(np.linalg.norm(arm, axis=1), 1e-300)
            unit = arm / distance[:, None]
            slope, curve = np.zeros((len(ball), 7)), np.zeros((len(ball), 7, 7))
            slope[:, :2] = unit
            across = np.eye(2) - unit[:, :, None] * unit[:, None, :]
            curve[:, :2, :2] = across / distance[:, None, None]
            result.append((OUTER, k, distance, slope, curve, np.arctan2(unit[:, 1], unit[:, 0])))
        for side, k, distance, slope, curve, angle in result:
            law = contact_law.hertzian(self.stiffness[side][k])
            found = law(distance - bearing.groove_gap(side))
            yield side, found, distance, slope, curve, angle

    def sums(self, ball, place):
        """(energy, gradient (Z, 7), Hessian (Z, 7, 7), balls on the inner ring (Z,))."""
        energy = -self.centrifugal * (ball[:, 0] - self.start[:, 0]).sum()
        gradient, hessian = np.zeros((len(ball), 7)), np.zeros((len(ball), 7, 7))
        gradient[:, 0], carried = -self.centrifugal, np.zeros(len(ball), bool)
        for side, found, _, slope, curve, _ in self.contacts(ball, place):
            energy += found.energy.sum()
            gradient += found.load[:, None] * slope
            hessian += found.slope[:, None, None] * slope[:, :, None] * slope[:, None, :]
            hessian += found.load[:, None, None] * curve
            if side == INNER:
                carried |= found.load > 0
        return energy, gradient, hessian, carried

    def carried(self, ball, place):
        _, _, hessian, loaded = self.sums(ball, place)
        sides, approach, along = ([], []), [], []
        for side, found, distance, slope, _, angle in self.contacts(ball, place):
            sides[side].append((distance, found.load, np.where(found.load > 0, angle, 0.0)))
            approach.append(slope)
            along.append(found.slope)
        linear = Linear(hessian, np.array(approach), np.array(along), loaded)
        both = (
            contacts(self.row.bearing, side, *map(np.array, zip(*one)), self.row.clearance)
            for side, one in enumerate(sides)
        )
        return Carried(*both, self.azimuth, linear)


class _Ring:
    """The ring and all balls at once."""

    def __init__(self, rows, loads, held):
        self.rows, self.loads = rows, loads
        self.free = np.isnan(held)
        pitch = max(one.row.bearing.pitch_radius for one in rows)
        self.lengths = np.array([1.0, 1.0, 1.0, pitch, pitch])
        self.place = np.nan_to_num(held)
        self.balls = [one.start.copy() for one in rows]
        gaps = [one.row.bearing.groove_gap(side) for one in rows for side in (INNER, OUTER)]
        self.cap = 0.1 * min(gaps)  # m, longest step
        stiff = max(hertz_stiffness.max() for one in rows for hertz_stiffness in one.stiffness)
        self.soft = 1e-3 * stiff * np.sqrt(self.cap)  # N/m

    def find(self):
        for _ in range(RENEWALS):
            before = [stiffness for one in self.rows for stiffness in one.stiffness]
            left = self.settle()
            for one, ball in zip(self.rows, self.balls):
                one.bend(*one.angles(ball, self.place))
            after = [stiffness for one in self.rows for stiffness in one.stiffness]
            if all(np.allclose(a, b, rtol=1e-9, atol=0) for a, b in zip(after, before)):
                return self.rest(left)
        raise NoEquilibrium("contact angles and contact stiffness do not settle")

    def totals(self, place, balls):
        """(energy, gradient of the ring (5,), its Hessian, and of each row (gradient, Hessian))."""
        parts = [one.sums(ball, place) for one, ball in zip(self.rows, balls)]
        energy = sum(part[0] for part in parts) - self.loads[self.free] @ place[self.free]
        gradient = sum(part[1][:, 2:].sum(0) for part in parts) - np.where(
            self.free, self.loads, 0.0
        )
        return energy, gradient, parts

    def settle(self):
        """Newton's method on ring and balls; what is left of the balance over the loads."""
        energy, gradient, parts = self.totals(self.place, self.balls)
        for _ in range(STEPS):
            size, scale = self.left(gradient, parts)
            if size <= 0.01 * EXACT * scale:
                break
            step, moves = self.step(gradient, parts)
            slope = gradient[self.free] @ step[self.free]
            slope += sum((part[1][:, :2] * move).sum() for part, move in zip(parts, moves))
            share = 1.0
            while share > 1e-9:
                place = self.place + share * step
                balls = [ball + share * move for ball, move in zip(self.balls, moves)]
                there = self.totals(place, balls)
                # near the end energies are alike to rounding, and forces tell
                if (
                    there[0] <= energy + 1e-4 * share * slope
                    or self.left(*there[1:])[0] < 0.5 * size
                ):
                    break
                share /= 2
            else:
                break
            self.place, self.balls, (energy, gradient, parts) = place, balls, there
            if np.abs(self.place * self.lengths).max() > 1e3 * self.cap:
                break
        size, scale = self.left(gradient, parts)
        if not size <= EXACT * scale:
            raise NoEquilibrium(
                f"no place of the ring balances the loads {self.loads}: {size / scale:.1e} of them"
                " is left"
            )
        return float(size / scale) if scale else 0.0

    def left(self, gradient, parts):
        """(largest force that is left on ring and balls, largest force there is), N."""
        balls = max(np.abs(part[1][:, :2]).max() for part in parts)
        ring = np.abs((gradient / self.lengths)[self.free]).max(initial=0.0)
        pushed = max(np.abs(part[1][:, 2:] / self.lengths).max() for part in parts)
        return max(ring, balls), np.abs(self.loads / self.lengths).max() + pushed

    def step(self, gradient, parts):
        """(ring's step (5,), each row's (Z, 2)): balls are eliminated first."""
        whole, pull, rows = np.zeros((5, 5)), -gradient, []
        tiny = 1e-12 * self.soft * np.eye(2)
        for _, slope, hessian, _ in parts:
            soft = tiny + np.where(np.abs(hessian[:, :2, :2]).max((1, 2)) > 0, 0.0, self.soft)[
                :, None, None
            ] * np.eye(2)
            inverse = np.linalg.inv(hessian[:, :2, :2] + soft)
            mixed = hessian[:, :2, 2:]
            whole += (hessian[:, 2:, 2:] - mixed.transpose(0, 2, 1) @ inverse @ mixed).sum(0)
            pull = pull + np.einsum("zia,zij,zj->a", mixed, inverse, slope[:, :2])
            rows.append((inverse, mixed, slope[:, :2]))
        step = np.zeros(5)
        if self.free.any():
            free = np.flatnonzero(self.free)
            lengths = self.lengths[free]
            value, vector = np.linalg.eigh(whole[np.ix_(free, free)] / np.outer(lengths, lengths))
            value = np.maximum(value, 1e-6 * max(value[-1], self.soft))
            step[free] = vector @ (vector.T @ (pull[free] / lengths) / value) / lengths
        moves = [-np.einsum("zij,zj->zi", one, slope + mixed @ step) for one, mixed, slope in rows]
        # one share of all, so that it stays a way down
        longest = max(np.abs(step * self.lengths).max(), *(np.abs(move).max() for move in moves))
        share = min(1.0, self.cap / max(longest, 1e-300))
        return share * step, [share * move for move in moves]

    def rest(self, left):
        _, gradient, parts = self.totals(self.place, self.balls)
        stiffness = np.zeros((5, 5))
        for _, _, hessian, carried in parts:
            if carried.any():
                stiffness += condensed(hessian[carried])
        if self.free.any() and not any(part[3].any() for part in parts):
            raise NoEquilibrium("no ball carries: nothing says where the ring sits")
        force = -(gradient + np.where(self.free, self.loads, 0.0))
        rows = [one.carried(ball, self.place) for one, ball in zip(self.rows, self.balls)]
        return Rest(self.place, rows, force, stiffness, left)
