# SPDX-License-Identifier: GPL-2.0-or-later
"""Cage speed from statics, accurate enough (1e-4) for comparison with a measured spectral line.

`kinematics.frequencies` assumes a single contact angle. This module adds three effects. First, the
contact angles at the two raceways differ because of the centrifugal load. Second, the speed then
depends on the axis about which a ball rotates. Third, in a curved groove a ball rolls without
sliding along two lines of its contact ellipse (Heathcote), not at the bottom of the groove.
"""

import math
from typing import NamedTuple

import numpy as np

from raceway.arrays import Floats
from raceway.theory import sliding
from raceway.theory.bearing import INNER, OUTER, Bearing
from raceway.theory.models import STATICS
from raceway.theory.static import Equilibrium

# One standard deviation, relative to the order. Rolling resistance and drag slow the balls by up to
# 1e-4 if all of them are loaded (tests/hosts/test_identify.py compares this with runs)
ERROR = 1e-4
# Play of a pocket along the pitch circle, as a fraction of the ball diameter (docs/cage)
PLAYS = (0.01, 0.04)
PLAY = PLAYS[1]
# Slip of a cage with play j, divided by j/(length of the loaded arc), in the two extreme cases. The
# cage hangs towards the load by its weight, or its driving ball lifts it off; 1 if it is centred
# (docs/cage)
SLIPS = (-1.1, 2.2)


def order(bearing: Bearing, state: Equilibrium, models: str = "full") -> float:
    """Return the ratio of cage speed to inner ring speed at an equilibrium `state` with the outer
    ring at rest, as a load-weighted mean over all balls. Raises `ValueError` for unknown models.

    Each ball rolls at both contacts (Harris, Rolling Bearing Analysis, ch. 10)::

        w_c/w = A/(A + B),  A = (1 - g cos a_i)(cos a_o + tan b sin a_o),
                            B = (1 + g cos a_o)(cos a_i + tan b sin a_i)

    where g is the ratio of ball diameter to pitch diameter, and b is the angle of the axis about
    which the ball rotates. With models paper, b is 0, because nothing tilts that axis relative to
    the bearing's axis. Otherwise b is half the sum of both contact angles, for which spin
    dissipates the same power at both contacts. Differential slip then adds a fraction (1 - w_c/w)
    (e_i - e_o), with e = 0.1206 a^2/(2 R_d R_x), where a is the semi-axis of the ellipse across the
    groove.

    >>> from raceway.theory import static
    >>> b = Bearing(9, 7.94e-3, 15.55e-3, 23.49e-3, 4.0891e-3, 4.1685e-3)
    >>> rest = static.equilibrium(b, 0.0, 30.0, clearance=8e-6)
    >>> [round(9 * order(b, rest, models), 4) for models in ("paper", "full")]
    [3.6006, 3.6015]
    """
    return _mean(bearing, state, models, _orbit)


def ball_order(bearing: Bearing, state: Equilibrium, models: str = "full") -> float:
    """Return the rotation of a ball relative to the cage (BSF), in orders of the inner ring's
    speed; the arguments are as in `order`.

    A ball rolls on the outer raceway about an axis at the angle b, which is half the sum of both
    contact angles: w_b/w_c = (1 + g cos a_o)/(g cos(b - a_o)). This formula is also used with the
    models `paper`, in which the ball's axis does not tilt. Differential slip adds a fraction (1 -
    w_c/w) e_i + w_c/w e_o, because both rings are slower than the surface of the ball.

    >>> from raceway.theory import static
    >>> b = Bearing(9, 7.94e-3, 15.55e-3, 23.49e-3, 4.0891e-3, 4.1685e-3)
    >>> rest = static.equilibrium(b, 0.0, 30.0, clearance=8e-6)
    >>> [round(ball_order(b, rest, models), 4) for models in ("paper", "full")]
    [2.3602, 2.3615]
    """
    return _mean(bearing, state, models, _rotation)


def _mean(bearing, state, models, of):
    """Return the load-weighted mean over all balls of the values that `of` computes."""
    if models not in STATICS:
        raise ValueError(f"models '{models}' is not one of {', '.join(STATICS)}")
    inner, outer = (Rolling(side.load, side.angle, side.a) for side in (state.inner, state.outer))
    values = of(bearing, inner, outer, models != "paper")
    return float(np.average(values, weights=inner.load + outer.load))


def _orbit(bearing, inner, outer, full):
    speed = rolling(bearing, inner, outer, tilted=full)
    return speed * (1 + (1 - speed) * shortened(bearing, inner, outer)) if full else speed


def _rotation(bearing, inner, outer, full):
    gamma = bearing.ball_radius / bearing.pitch_radius
    speed = rolling(bearing, inner, outer, tilted=True)
    apart = (inner.angle - outer.angle) / 2
    own = speed * (1 + gamma * np.cos(outer.angle)) / (gamma * np.cos(apart))
    if not full:
        return own
    slip_i, slip_o = slips(bearing, inner, outer)
    return own * (1 + (1 - speed) * slip_i + speed * slip_o)


class Rolling(NamedTuple):
    """Loads, contact angles and semi-axes of the contacts of one ring, in arrays of equal shape."""

    load: Floats  # N
    angle: Floats  # rad, contact angle
    a: Floats  # m, semi-axis across the groove


def rolling(bearing: Bearing, inner: Rolling, outer: Rolling, *, tilted: bool) -> Floats:
    """Return w_c/w of `order` for each ball, without differential slip. The angle b is half the
    sum of both contact angles if `tilted` is true, and 0 otherwise."""
    gamma = bearing.ball_radius / bearing.pitch_radius
    tilt = np.tan((inner.angle + outer.angle) / 2) if tilted else 0.0
    there = _along(outer.angle, tilt) * (1 - gamma * np.cos(inner.angle))
    here = _along(inner.angle, tilt) * (1 + gamma * np.cos(outer.angle))
    return there / (there + here)


def slips(bearing: Bearing, inner: Rolling, outer: Rolling) -> list[Floats]:
    """Return [e_i, e_o] of `order` for each ball, i.e. the fraction by which each ring is slower
    than the ball's surface in free rolling."""
    found = []
    for side, one in ((INNER, inner), (OUTER, outer)):
        r_x, _ = bearing.effective_radii(side, one.angle)
        r_d = sliding.deformed_radius(bearing.groove(side), bearing.ball_radius)
        found.append(sliding.free_slip(1.0, one.a, r_d, r_x))
    return found


def shortened(bearing: Bearing, inner: Rolling, outer: Rolling) -> Floats:
    """Return e_i - e_o of `order` for each ball."""
    slip_i, slip_o = slips(bearing, inner, outer)
    return slip_i - slip_o


def _along(angle: Floats, tilt: Floats | float) -> Floats:
    return np.cos(angle) + tilt * np.sin(angle)


def lags(bearing: Bearing, state: Equilibrium) -> tuple[float, float]:
    """Return the smallest and the largest slip of a cage due to pocket play (`slips_of_play`), as
    fractions of the cage speed. Both are 0 if all balls are loaded.

    The loaded arc spans the loaded balls. The play is assumed to be `PLAY` ball diameters, because
    makers seldom state it.
    """
    loaded = int(np.count_nonzero(np.atleast_2d(state.inner.load > 0).any(0)))
    if loaded >= len(state.azimuth) or not loaded:
        return 0.0, 0.0
    arc = 2 * math.pi * bearing.pitch_radius * loaded / len(state.azimuth)
    return slips_of_play(PLAY * bearing.ball_diameter, arc)


def slips_of_play(play: float, arc: float) -> tuple[float, float]:
    """Return the smallest and the largest slip of a rigid cage in any position. `play` is the play
    of its pockets along the pitch circle (m), and `arc` is the length of the part of that circle on
    which balls are loaded (m).

    Unloaded balls fall back to the rear of their pockets, while loaded balls run ahead to the
    front.
    """
    low, high = (share * play / arc for share in SLIPS)
    return low, high
