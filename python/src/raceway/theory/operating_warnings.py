# SPDX-License-Identifier: GPL-2.0-or-later
"""Warnings about the results of a bearing at one operating point, and the range of its torque."""

from typing import NamedTuple

import numpy as np

from raceway.theory import ball_motion, excursion, life, validity
from raceway.theory.bearing import Bearing, Layout
from raceway.theory.cage_drag import CageRing
from raceway.theory.excursion import Excursion
from raceway.theory.friction_torque import Losses
from raceway.theory.running import Running


class OfFriction(NamedTuple):
    """How the friction of balls limits the results of statics."""

    gyroscopic: float  # largest friction coefficient that balls need against gyroscopic moments
    ends: tuple[float, float]  # smallest and largest torque of runs divided by that of statics
    warnings: list[str]


def wide_grooves(body: Bearing) -> list[str]:
    """Return a list with a warning that the rating used for the life applies only to narrower
    grooves, which is empty if the grooves are narrow enough."""
    if min(wide := life.wide_grooves(body)) >= 1 - 1e-9:
        return []
    return [
        "groove radii above {:g} (inner) and {:g} (outer) of the ball diameter reduce the load"
        " ratings of the balls to {:.0%} and {:.0%} of those that follow from C in the file".format(
            *life.CONFORMITY, *wide
        )
    ]


def advance(run: Running, lost: Losses | None, cage: CageRing | None) -> Excursion | None:
    """Return the motion of balls relative to their `cage`, or None if a ring has several grooves or
    rows. `lost` are the losses of the bearing, or None if it has no friction."""
    if lost is not None and lost.advance is not None:
        return lost.advance
    if run.bearing.layout != Layout():
        return None
    friction, play = lost and lost.friction, cage and cage.play or None
    return excursion.excursion(run.bearing, run.rolling, run.ring, friction, play)


def restrained(ahead: Excursion | None) -> list[str]:
    """Return a list with a warning if balls that run `ahead` of their cage press against it."""
    text = ahead and excursion.warning(ahead)
    return [text] if text else []


def of_friction(run: Running, lost: Losses, ahead: Excursion | None) -> OfFriction:
    """Return the `OfFriction` of a bearing with the losses `lost`, whose balls run `ahead` of their
    cage or lag behind it."""
    state, friction = run.rolling, lost.friction
    needed = ball_motion.gyroscopic(run.bearing, state, run.ring, run.rolling_orbit, run.density)
    needed = needed * np.atleast_2d(state.inner.heavy).any(0)
    doubts = _doubts(state, friction, needed, ahead)
    pressed = doubts["pockets"] > validity.TORQUE["pockets"].bound
    *ends, torque = validity.torque_range(doubts, _wedged(run, lost, ahead) if pressed else 0.0)
    sliding = _sliding(state, friction, needed, run.motion is not None)
    return OfFriction(needed.max(), tuple(ends), sliding + torque)


def _doubts(state, friction, needed, ahead):
    """Return the values on which the accuracy of the friction torque depends, with the names in
    `validity.TORQUE`."""
    sides = (state.inner, state.outer)
    tilted = any(np.any(np.abs(one.angle[one.heavy]) > 1e-3) for one in sides)
    return dict(
        pockets=0.0 if ahead is None else ahead.needed / ahead.play,
        gyroscopic=(needed / _available(state, friction)).max(),
        unloaded=np.mean(~np.atleast_2d(state.inner.heavy).any(0)) if tilted else 0.0,
    )


def _wedged(run, lost, ahead):
    """Return the power dissipated if the cage is not shifted to where the balls have the most room,
    so that they have only half of it, divided by the power in `lost`."""
    cage = run.friction.cage
    if cage is None or cage.land or run.motion:
        return 0.0
    tight = run.friction._replace(cage=cage._replace(play=ahead.play / 2))
    return run._replace(friction=tight).losses().power / lost.power


def _available(state, friction):
    """Return the mean friction coefficient (Z,) of the contacts of each ball."""
    load = np.vstack([state.inner.load, state.outer.load])
    return np.maximum((friction * load).sum(0), 1e-300) / np.maximum(load.sum(0), 1e-300)


def _sliding(state, friction, needed, included):
    """Return a list with a warning if friction cannot hold balls against their gyroscopic moment;
    `included` says whether the state of these balls was solved for."""
    slide = needed > _available(state, friction)
    if not slide.any():
        return []
    where = "around a ring that is free in its plane" if included else "in a run"
    return [
        f"the friction of {slide.sum()} balls is below the coefficient of {needed.max():.2g} that"
        f" their gyroscopic moment requires: they slide across their grooves, and {where} they may"
        " skid and dissipate more"
    ]
