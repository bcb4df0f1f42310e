# SPDX-License-Identifier: GPL-2.0-or-later
"""Distances by which balls run ahead of their cage and lag behind it.

Under a moment or a combined load, the contact angles differ from ball to ball, and so do the speeds
at which the balls roll around the bearing. A ball then moves relative to a cage that turns
uniformly; bearing software calls this circumferential ball advance. If the play of a pocket is
smaller than this motion, the pocket restrains the ball. The ball then slides on both raceways, and
friction there presses it against the pocket. The slip and the friction in the pocket dissipate
power (`friction_torque`).
"""

import math
from typing import NamedTuple

import numpy as np

from raceway.arrays import Floats, short
from raceway.core import laws
from raceway.theory import cage_speed, sliding
from raceway.theory.bearing import INNER, OUTER, Bearing
from raceway.theory.static import Equilibrium
from raceway.units import prefixed

POINTS = 720  # least number of points on the path of a ball around the bearing, for the integrals
SHIFTS = 41  # number of tried displacements of the cage


class Excursion(NamedTuple):
    """Motion of balls relative to a cage that turns uniformly."""

    ahead: float  # m, largest distance ahead of the mean
    behind: float  # m, largest distance behind the mean, negative
    play: float  # m, play of the pockets along the pitch circle
    needed: float  # m, smallest play with which no ball would touch its pocket
    # (2, Z), N, estimated forces of the raceways on balls that their pockets restrain, and the slip
    # (Z,) in m/s that causes them; None without friction coefficients
    forces: Floats | None = None
    slip: Floats | None = None

    __repr__ = short

    @property
    def force(self) -> float | None:
        """Estimated largest pocket force in N; None without friction coefficients."""
        return None if self.forces is None else float(np.abs(self.forces.sum(0)).max())

    @property
    def power(self) -> Floats:
        """Power (2, Z) in W dissipated by the slip of restrained balls."""
        return np.abs(self.forces * self.slip)

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
    *,
    centred: bool = False,
) -> Excursion | None:
    """Compute the `Excursion` at the equilibrium `state` of a bearing with one row and one groove
    per ring. The inner ring turns at `speed` (rad/s), and the outer ring is at rest. Returns None
    for other bearings, or if no ball is loaded.

    Each ball rolls at its own contact angles (`cage_speed.rolling`); balls with hardly any load
    move at the mean speed. The advance of a ball is R times the integral of 1 - w_c/w over the
    azimuth, where w is the ball's speed and w_c is the harmonic mean of the speeds of all balls,
    which makes the advance periodic over a turn. A cage that is not `centred` by a land shifts in
    its plane to where its spherical pockets leave the balls the most room. If the excursion then
    needs more than `play` (m; by default the estimate used in runs), a ball is restrained by (1 -
    play/needed) (w - w_c) R at both raceways. The traction due to this slip, by Heathcote's law
    with the coefficients `friction` (2, Z), presses the ball against its pocket. The cage speed is
    the speed at which these forces balance.
    """
    if np.ndim(state.inner.load) != 1:
        return None
    sides = [cage_speed.Rolling(one.load, one.angle, one.a) for one in (state.inner, state.outer)]
    loaded = state.inner.heavy & state.outer.heavy
    if not loaded.any():
        return None
    own = np.asarray(cage_speed.rolling(bearing, *sides, tilted=True))
    own = own * (1 + (1 - own) * cage_speed.shortened(bearing, *sides))
    mean = 1 / np.mean(1 / own[loaded])
    own = np.where(loaded, own, mean)
    path = _integral(1 - mean / own) * bearing.pitch_radius
    path = -path if speed < 0 else path  # balls pass through the angles in the other order
    found = Excursion(
        float(path.max()),
        float(path.min()),
        laws.usual_play() * bearing.ball_diameter if play is None else play,
        float(np.ptp(path)) if centred else _needed(path),
    )
    if friction is None:
        return found
    held = max(0.0, 1 - found.play / found.needed) if found.needed > 0 else 0.0
    if held == 0.0:
        return found._replace(forces=np.zeros((2, len(own))), slip=np.zeros(len(own)))

    from scipy.optimize import brentq  # loading it takes longer than a summary of a run

    def restrained(cage):
        slip = held * (cage - own) * abs(speed) * bearing.pitch_radius
        both = [
            _traction(bearing, side, slip, sides[side], friction[side], abs(speed) * mean)
            for side in (INNER, OUTER)
        ]
        return np.array(both) * loaded, slip

    cage = brentq(lambda w: restrained(w)[0].sum(), own.min(), own.max())
    forces, slip = restrained(cage)
    return found._replace(forces=forces, slip=slip)


def _needed(path):
    """Return the play in m that balls on the `path` (m ahead of the mean, at equal angles) need in
    the spherical pockets of a cage that is free to shift in its plane. A shift d changes the
    distance from the middle of a pocket by d sin(psi - b) along the path and by d cos(psi - b)
    along the radius."""
    wave = np.fft.fft(path)[1] * 2 / len(path)
    psi = 2 * np.pi * np.arange(len(path)) / len(path) + np.angle(wave)
    shift = np.linspace(0, 1, SHIFTS)[:, None] * abs(wave)
    along = path - shift * np.cos(psi)
    along = along - (along.max(1, keepdims=True) + along.min(1, keepdims=True)) / 2
    return float(2 * np.hypot(along, shift * np.sin(psi)).max(1).min())


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
    angles or slightly more, among which are those of the samples: the extremes then do not depend
    on which ball is the first."""
    count = len(values)
    points = count * -(-POINTS // count)
    waves = np.fft.fft(values) / count
    order = np.round(np.fft.fftfreq(count, 1 / count)).astype(int)
    spectrum = np.zeros(points, complex)
    turning = order != 0
    spectrum[order[turning]] = waves[turning] / (1j * order[turning])
    return np.real(np.fft.ifft(spectrum)) * points


def warning(found: Excursion) -> str | None:
    """Return a warning if the excursion of the balls needs more than the pocket play, otherwise
    None."""
    if found.needed <= found.play:
        return None
    text = (
        f"the balls run up to {prefixed(found.ahead, 'm', 3)} ahead of and"
        f" {prefixed(-found.behind, 'm', 3)} behind their cage, {prefixed(found.whole, 'm', 3)} in"
        f" total, but its pockets have a play of {prefixed(found.play, 'm', 3)}"
    )
    if found.force is None or not math.isfinite(found.force):
        return text
    return f"{text}: some press against them with about {prefixed(found.force, 'N', 3)}"
