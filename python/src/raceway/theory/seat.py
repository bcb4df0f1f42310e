# SPDX-License-Identifier: GPL-2.0-or-later
"""Equilibrium position of a ball between the grooves of an inner and an outer ring, in the plane
through the bearing's axis (Jones 1960).

Coordinates are (radial, axial) in m. Each of Z balls has C contacts, one for each groove, with the
inner grooves first. Each contact is a spring that obeys its `contact_law`. The energy of a spring
is a convex function of the ball's position, and so is the total energy including the centrifugal
load. A ball therefore moves from groove to groove without a jump.
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from raceway.arrays import Floats
from raceway.errors import NoEquilibrium
from raceway.theory import circle, hertz
from raceway.theory.contact_law import Law
from raceway.theory.small_motion import Linear


class Grooves(NamedTuple):
    """Surroundings of the balls: grooves, contact stiffness and centrifugal load."""

    # maps balls (Z, 2) to the `Reach` from the circles of the inner groove centres, in arrays
    # (inner grooves, Z)
    inner: Callable[[Floats], circle.Reach]
    outer: Floats  # (outer grooves, Z, 2), m, centres of curvature of the outer grooves
    gap: Floats  # (C, 1), m, difference of radii r_c - R_b
    stiffness: Floats  # (C, Z), N/m^1.5, contact stiffness
    centrifugal: Floats  # (Z,), N, centrifugal load, which is directed outwards
    law: Law  # contact law for overlaps (C, Z)


class Touch(NamedTuple):
    """Contacts of balls at given positions."""

    distance: Floats  # (C, Z), m, distance from the ball to the centre of curvature
    direction: Floats  # (C, Z, 2), unit vectors from ball to raceway
    load: Floats  # (C, Z), N
    along: Floats  # (C, Z), N/m, stiffness of each contact along its line of action
    energy: Floats  # (C, Z), J
    elastic: Floats  # (C, Z), m, compression of the steel
    reach: circle.Reach  # distances from the inner grooves

    @property
    def carried(self) -> Floats:
        """(Z,), bool, True for balls with an inner contact; other balls do not support the inner
        ring."""
        return (self.load[: len(self.reach.distance)] > 0).any(0)

    @property
    def curve(self) -> Floats:
        """(C, Z, 2, 2), second derivatives of the distances with respect to the ball's position."""
        inner = len(self.reach.distance)
        line = self.direction[inner:, :, :, None] * self.direction[inner:, :, None, :]
        outer = (np.eye(2) - line) / np.maximum(self.distance[inner:], 1e-300)[..., None, None]
        return np.concatenate([self.reach.curve(2), outer])


def touch(grooves: Grooves, ball: Floats) -> Touch:
    """Return the `Touch` of balls at the positions `ball` (Z, 2)."""
    reach, arm = grooves.inner(ball), ball - grooves.outer
    length = np.linalg.norm(arm, axis=-1)
    distance = np.concatenate([reach.distance, length])
    direction = [reach.slope[..., :2], arm / np.maximum(length, 1e-300)[..., None]]
    found = grooves.law(distance - grooves.gap)
    return Touch(distance, np.concatenate(direction), *found, reach)


def energy(grooves: Grooves, touch: Touch, ball: Floats) -> Floats:
    """Return the energy (Z,) in J of all springs, minus the work of the centrifugal load."""
    return touch.energy.sum(0) - grooves.centrifugal * (ball[:, 0] - grooves.outer[0, :, 0])


def gradient(grooves: Grooves, touch: Touch) -> Floats:
    """Return the derivative (Z, 2) of the energy in N, i.e. minus the force on each ball."""
    result = (touch.load[..., None] * touch.direction).sum(0)
    result[:, 0] -= grooves.centrifugal
    return result


def hessian(touch: Touch) -> Floats:
    """Return the second derivative (Z, 2, 2) of the energy in N/m. It consists of the stiffness of
    each spring along its line of action, and of Q/s across it."""
    line = touch.direction[..., :, None] * touch.direction[..., None, :]
    return _springs(touch.along, line, touch.load, touch.curve).sum(0)


def linear(touch: Touch) -> Linear:
    """Return the linearised balls as `Linear`."""
    inner, count = len(touch.reach.distance), touch.load.shape[1]
    line, curve = np.zeros((2, len(touch.load), count, 7, 7))
    approach = np.zeros((len(touch.load), count, 7))
    approach[:inner], approach[inner:, :, :2] = touch.reach.slope, touch.direction[inner:]
    line = approach[..., :, None] * approach[..., None, :]
    curve[:inner], curve[inner:, :, :2, :2] = touch.reach.curve(7), touch.curve[inner:]
    whole = _springs(touch.along, line, touch.load, curve).sum(0)
    return Linear(whole, approach, touch.along, touch.carried)


def _springs(along, line, load, curve):
    return along[..., None, None] * line + load[..., None, None] * curve


def nearest(grooves: Grooves) -> tuple[Floats, ...]:
    """For each ball, find the inner and the outer groove that compress it most or, if none does,
    that leave it the least play. Return the compression (Z,) in m (negative if there is play), the
    unit vector (Z, 2) from the outer to the inner centre, the distance (Z,) between these centres,
    the outer centre (Z, 2), and the indices of the two contacts (2, Z)."""
    pairs, inner = [], None
    for k, outer in enumerate(grooves.outer):
        inner = grooves.inner(outer)
        count = len(inner.distance)
        gap = grooves.gap[:count] + grooves.gap[count + k]
        # exact if the circle lies in the plane of the ball
        line = -inner.distance[..., None] * inner.slope[..., :2]
        number = np.broadcast_to([[[i], [count + k]] for i in range(count)], (count, 2, len(outer)))
        centre = np.broadcast_to(outer, line.shape)
        pairs.append((inner.distance - gap, line, inner.distance, centre, number.swapaxes(1, 2)))
    parts = [np.concatenate(one) for one in zip(*pairs)]
    best = np.argmax(parts[0], axis=0), np.arange(parts[0].shape[1])
    squeeze, line, distance, centre, number = (one[best] for one in parts)
    return squeeze, line, distance, centre, number.T


def settle(grooves: Grooves, near: Floats | None = None) -> Floats:
    """Return the positions (Z, 2) at which every ball is in equilibrium. If `near` is given, the
    search starts from these nearby positions for balls that are held. Raises `NoEquilibrium` if
    Newton's method does not converge."""
    centrifugal, stiffness = grooves.centrifugal, grooves.stiffness
    tight, line, distance, outer, pair = nearest(grooves)
    balls = np.arange(len(outer))
    squeeze, play = np.maximum(tight, 0), np.minimum(tight, 0)
    soft, hard = stiffness[pair, balls]
    gap = grooves.gap[pair, 0]
    # both loads act along one line and are equal and opposite; a ball with play is put in the
    # middle
    share = squeeze / (1 + (soft / hard) ** (2 / 3)) + play / 2
    between = outer + line * (1 - (gap[0] + share) / distance)[:, None]
    thrown = outer.copy()
    thrown[:, 0] += gap[1] + (centrifugal / hard) ** (2 / 3)
    ball = np.where(((squeeze > 0) | (centrifugal == 0))[:, None], between, thrown)
    if near is not None:
        ball = np.where(((squeeze > 0) | (centrifugal > 0))[:, None], near, ball)
    scale = centrifugal + hertz.load(hard, squeeze)
    longest = 0.25 * gap[:, 0].sum()  # longest step, small compared with the groove
    # keeps the matrix regular if a ball has lost contact with one or both grooves
    floor = (1e-9 * scale.max() + 1e-30) / longest * np.eye(2)
    digits = 8 * np.spacing(outer[:, 0])
    ball, excess = _newton(grooves, ball, scale, longest, floor, digits)
    # a slow ball is hardly pressed into the outer groove, along which Newton's method crawls; it is
    # at rest at the bottom or where it touches the inner groove on its way there
    if (stuck := excess > 0).any():
        alone = (touch(grooves, thrown).load > 0).sum(0) == 1
        corner = _corner(outer, line / distance[:, None], distance, gap, (soft, hard), centrifugal)
        rest = np.where((alone | np.isnan(corner).any(1))[:, None], thrown, corner)
        ball = np.where(stuck[:, None], rest, ball)
        ball, excess = _newton(grooves, ball, scale, longest, floor, digits)
    if np.any(excess > 0):
        raise NoEquilibrium(
            f"no equilibrium position found for ball {int(np.argmax(excess))} between its raceways"
        )
    return ball


def _newton(grooves, ball, scale, longest, floor, digits):
    """Return the positions (Z, 2) found by Newton's method, and by how much their residual forces
    exceed the limit (Z,)."""
    stiffness = grooves.stiffness
    now = touch(grooves, ball)
    for _ in range(200):
        slope = gradient(grooves, now)
        size = np.linalg.norm(slope, axis=-1)
        # distances have errors in the last digits of the circle's radius, even for contacts that
        # have only just closed
        rounding = 1.5 * (stiffness * np.sqrt(now.elastic + digits)).sum(0) * digits
        left = size > 1e-12 * scale + rounding
        if not left.any():
            break
        step = -np.linalg.solve(hessian(now) + floor, slope[..., None])[..., 0]
        step *= np.minimum(1, longest / np.maximum(np.linalg.norm(step, axis=-1), 1e-300))[:, None]
        # converged balls stop, because their rounding errors would delay the others
        step[~left] = 0.0
        before, (ball, now) = ball, _moved(grooves, ball, step, slope, now)
        if np.array_equal(before, ball):
            break
    return ball, size - 1e-7 * np.maximum(scale, 1e-6 * scale.max()) - rounding


def _corner(outer, line, distance, gap, stiffness, centrifugal):
    """Return the positions (Z, 2) at which balls with play touch both grooves under their
    centrifugal load, without film; NaN if it does not press them into both."""
    with np.errstate(invalid="ignore", divide="ignore"):
        # where circles with the radii of both gaps about the centres of curvature intersect
        along = (distance**2 + gap[1] ** 2 - gap[0] ** 2) / (2 * distance)
        across = np.sqrt(gap[1] ** 2 - along**2)
        side = np.stack([-line[:, 1], line[:, 0]], -1)
        side *= np.where(side[:, 0] < 0, -1, 1)[:, None]  # the intersection farther out
        arms = np.stack([(along - distance)[:, None] * line, along[:, None] * line], 1)
        arms = (arms + (across[:, None] * side)[:, None]) / gap.T[..., None]
        (a, b), (c, d) = arms[:, 0].T, arms[:, 1].T
        whole = a * d - b * c
        # the loads along both arms that balance the centrifugal load
        load = centrifugal * np.stack([d, -b]) / whole
        inner, to_outer = (load / np.stack(stiffness)) ** (2 / 3)
        shift = np.stack([d * inner - b * to_outer, a * to_outer - c * inner], -1)
        return outer + gap[1][:, None] * arms[:, 1] + shift / whole[:, None]


def _moved(grooves, ball, step, slope, now):
    """Return the positions of the balls and their `Touch` after a step of each ball from the
    current `Touch`. The step is halved until the energy or the residual force decreases."""
    here, descent, size = (
        energy(grooves, now, ball),
        (slope * step).sum(-1),
        np.linalg.norm(slope, axis=-1),
    )
    part = np.ones(len(ball))
    for _ in range(40):
        trial = ball + part[:, None] * step
        there = touch(grooves, trial)
        better = energy(grooves, there, trial) <= here + 1e-4 * part * descent
        better |= np.linalg.norm(gradient(grooves, there), axis=-1) < 0.5 * size
        if np.all(better):
            return trial, there
        part = np.where(better, part, part / 2)
    trial = ball + part[:, None] * step
    return trial, touch(grooves, trial)
