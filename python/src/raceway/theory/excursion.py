# SPDX-License-Identifier: GPL-2.0-or-later
"""Distances by which balls run ahead of their cage and lag behind it.

Under a moment or a combined load, the contact angles differ from ball to ball, and so do the speeds
at which the balls roll around the bearing. A ball then moves relative to a cage that turns
uniformly; bearing software calls this circumferential ball advance. If the play of a pocket is
smaller than this motion, the pocket restrains the ball. The ball then slides on both raceways, and
friction there presses it against the pocket.
"""

import math
from typing import NamedTuple

import numpy as np
from scipy.optimize import brentq

from raceway.arrays import Floats
from raceway.core import laws
from raceway.theory import cage_speed, sliding
from raceway.theory.bearing import INNER, OUTER, Bearing
from raceway.theory.static import Equilibrium
from raceway.units import prefixed

POINTS = 720  # number of points on the path of a ball around the bearing, for the integrals


class Excursion(NamedTuple):
    """Motion of balls relative to a cage that turns uniformly."""

    ahead: float  # m, largest distance ahead of the mean
    behind: float  # m, largest distance behind the mean, negative
    play: float  # m, play of the pockets along the pitch circle
    force: float | None  # N, estimated largest pocket force; None without friction coefficients

    @property
    def whole(self) -> float:
        """Distance in m from the rearmost to the foremost position."""
        return self.ahead - self.behind


def excursion(
    bearing: Bearing,
    state: Equilibrium,
    speed: float,
    friction: Floats | None = None,
    play: float | None = None,
) -> Excursion | None:
    """Compute the `Excursion` at the equilibrium `state` of a bearing with one row and one groove
    per ring. The inner ring turns at `speed` (rad/s), and the outer ring is at rest. Returns None
    for other bearings, or if no ball is loaded.

    Each ball rolls at its own contact angles (`cage_speed.rolling`); unloaded balls move at the
    mean speed. The advance of a ball is R times the integral of 1 - w_c/w over the azimuth, where w
    is the ball's speed and w_c is the harmonic mean of the speeds of all balls, which makes the
    advance periodic over a turn. If the excursion exceeds `play` (m; by default the estimate used
    in runs), a ball is restrained by (1 - play/excursion) (w - w_c) R at both raceways. The
    traction due to this slip, by Heathcote's law with the coefficients `friction` (2, Z), presses
    the ball against its pocket. The cage speed is the speed at which these forces balance.
    """
    if np.ndim(state.inner.load) != 1:
        return None
    sides = [cage_speed.Rolling(one.load, one.angle, one.a) for one in (state.inner, state.outer)]
    loaded = (sides[INNER].load > 0) & (sides[OUTER].load > 0)
    if not loaded.any():
        return None
    own = np.asarray(cage_speed.rolling(bearing, *sides, tilted=True))
    own = own * (1 + (1 - own) * cage_speed.shortened(bearing, *sides))
    mean = 1 / np.mean(1 / own[loaded])
    own = np.where(loaded, own, mean)
    path = _integral(1 - mean / own) * bearing.pitch_radius
    found = Excursion(
        float(path.max()),
        float(path.min()),
        laws.usual_play() * bearing.ball_diameter if play is None else play,
        None,
    )
    if friction is None:
        return found
    held = max(0.0, 1 - found.play / found.whole) if found.whole > 0 else 0.0
    if held == 0.0:
        return found._replace(force=0.0)

    def forces(cage):
        slip = held * (cage - own) * abs(speed) * bearing.pitch_radius
        orbit = abs(speed) * mean
        both = [
            _traction(bearing, side, slip, sides[side], friction[side], orbit)
            for side in (INNER, OUTER)
        ]
        return (both[INNER] + both[OUTER]) * loaded

    cage = brentq(lambda w: forces(w).sum(), own.min(), own.max())
    return found._replace(force=float(np.abs(forces(cage)).max()))


def _traction(bearing, side, slip, one, friction, orbit):
    """Return the traction in N along rolling on a ball whose slip relative to free rolling is
    `slip` (m/s)."""
    r_x, _ = bearing.effective_radii(side, one.angle)
    r_d = sliding.deformed_radius(bearing.groove(side), bearing.ball_radius)
    u = orbit * bearing.pitch_radius
    free = sliding.free_slip(u, one.a, r_d, r_x)
    return sliding.heathcote(free + slip, one.load, friction, u, one.a, r_d, r_x).force


def _integral(values):
    """Return the integral over a turn of samples at equal angles, minus its mean, at `POINTS`
    angles."""
    count = len(values)
    waves = np.fft.fft(values) / count
    order = np.round(np.fft.fftfreq(count, 1 / count)).astype(int)
    spectrum = np.zeros(POINTS, complex)
    turning = order != 0
    spectrum[order[turning]] = waves[turning] / (1j * order[turning])
    return np.real(np.fft.ifft(spectrum)) * POINTS


def warning(found: Excursion) -> str | None:
    """Return a warning if the excursion of the balls exceeds the pocket play, otherwise None."""
    if found.whole <= found.play:
        return None
    text = (
        f"the balls run up to {prefixed(found.ahead, 'm', 3)} ahead of and"
        f" {prefixed(-found.behind, 'm', 3)} behind their cage, {prefixed(found.whole, 'm', 3)} in"
        f" total, but its pockets have a play of {prefixed(found.play, 'm', 3)}"
    )
    if found.force is None or not math.isfinite(found.force):
        return text
    return f"{text}: some press against them with about {prefixed(found.force, 'N', 3)}"
