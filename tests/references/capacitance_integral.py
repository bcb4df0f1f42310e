# SPDX-License-Identifier: GPL-2.0-or-later
"""Capacitance of the gap around a ball, computed from the integral I = integral of dA/(h + g) in m.
It is the reference for `capacitance_outside` and takes a few milliseconds per contact.

The gap g around a loaded contact is the exact Hertz gap (Carlson's integrals, DLMF 19.16; Johnson
1985, ch. 4; see docs/electric for the derivation). The coordinates are in the plane of the contact:
x along rolling, which is unbounded, and y across the groove up to the shoulders.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike
from raceway.arrays import Floats, Numbers
from raceway.theory import hertz
from raceway.theory.bearing import INNER, Bearing
from raceway.theory.groove_width import shoulder_angle
from scipy.special import elliprd, elliprf

NODES, WEIGHTS = np.polynomial.legendre.leggauss(10)
# all in e-folds of the distance from an edge: first point, last point and step size along x; depth
# and width of the panels along y
NEAR, FAR, STEP = -22.0, 22.0, 0.4
DEEP, PANEL = 25.0, 2.5


class Hertz(NamedTuple):
    """A loaded elliptical contact, in SI units."""

    r_x: float
    r_y: float
    a: float
    b: float
    overlap: float
    strength: float  # p = 3 Q/(2 pi E'), m^2


def contact(r_x: float, r_y: float, modulus: float, load: float) -> Hertz:
    """Compute the `Hertz` contact of surfaces with the given effective radii in m under a load in
    N, with E' = `modulus` in Pa. Raises `ValueError` if the load is not positive."""
    if not load > 0:
        raise ValueError(f"load = {load} N must be positive")
    ellipse = hertz.exact(r_x, r_y)
    a, b = (float(axis) for axis in hertz.semi_axes(ellipse, modulus, load))
    strength = 3 * load / (2 * np.pi * modulus)
    overlap = 2 * strength * elliprf(0, b * b, a * a)
    return Hertz(r_x, r_y, a, b, float(overlap), strength)


def gap(one: Hertz, x: ArrayLike, y: ArrayLike) -> Numbers:
    """Return the gap g in m at the distances x along rolling and y across the groove from the
    centre. The gap is zero inside the ellipse. x and y are broadcast.

    >>> one = contact(4.990476e-3, 163.8e-3, 210e9 / 0.91, 120.0)
    >>> print(f"{1e9 * gap(one, 2 * one.b, 0.0):.0f} nm, {1e9 * gap(one, 0.0, 2 * one.a):.0f} nm")
    1410 nm, 4800 nm
    """
    x, y = np.asarray(x, float), np.asarray(y, float)
    beyond = one.a**2 * (x**2 - one.b**2) + one.b**2 * y**2
    return _gap(one, x, y, np.maximum(beyond, 0.0))


def _gap(one, x, y, beyond):
    """Return the gap at (x, y). `beyond` = a^2 x^2 + b^2 y^2 - a^2 b^2 is passed separately because
    the difference of squares would be inaccurate near the ellipse."""
    aa, bb, xx, yy = one.a**2, one.b**2, x * x, y * y
    half = (aa + bb - xx - yy) / 2
    root = np.sqrt(half * half + beyond)
    # the larger root of l^2 + 2 half l - beyond = 0, computed without cancellation
    positive = half > 0
    lift = np.where(positive, beyond / np.where(positive, half + root, 1.0), root - half)
    p = elliprf(lift, lift + bb, lift + aa)
    p_x = elliprd(lift, lift + aa, lift + bb)
    p_y = elliprd(lift, lift + bb, lift + aa)
    elastic = one.strength * (2 * p - 2 / 3 * (xx * p_x + yy * p_y))
    value = xx / (2 * one.r_x) + yy / (2 * one.r_y) - one.overlap + elastic
    return np.maximum(value, 0.0)[()]


def parabola(
    r_x: float, r_y: float, modulus: float, load: float, separation: ArrayLike, width: float
) -> Numbers:
    """Return I in m around the ellipse for each `separation` h (m). The groove is approximated by a
    parabola up to y = ± `width` (m). The gap is computed only once for all separations.

    Raises `ValueError` if the load is not positive.

    >>> one = parabola(4.990476e-3, 163.8e-3, 210e9 / 0.91, 120.0, [30e-9, 1e-6], 4.2e-3)
    >>> (1e3 * one).round(1).tolist()  # mm
    [2477.3, 1066.1]
    """
    one = contact(r_x, r_y, modulus, load)
    beside = _strips(one, *_inward(one.a, min(one.a, width)), separation)
    beyond = 0.0
    if width > one.a:
        beyond = _strips(one, *_outward(one.a, width), separation)
    return 2 * (beside + beyond)


def arc(
    bearing: Bearing,
    raceway: int,
    load: float,
    separation: ArrayLike,
    depth: float,
    angle: float = 0.0,
) -> Numbers:
    """Return I in m around the ellipse for each `separation` (m), in a circular groove of depth
    `depth` (m) at the contact angle `angle` (rad).

    Within the width of the ellipse, the gap is the same as in `parabola`. Beyond it, the gap is
    corrected by the difference between the arc and the parabola, and the radius along rolling
    follows the raceway. Raises `ValueError` if the load is not positive.
    """
    r_x, r_y = (float(value) for value in bearing.effective_radii(raceway, angle))
    one = contact(r_x, r_y, bearing.effective_modulus, load)
    edge = float(shoulder_angle(bearing.groove(raceway), bearing.ball_radius, depth))
    total = 0.0
    for side in (-1, 1):
        reach = bearing.ball_radius * (edge + side * abs(angle))
        total = total + _strips(one, *_inward(one.a, min(one.a, reach)), separation)
        if reach <= one.a:
            continue
        y, weight = _outward(one.a, reach)
        psi = y / bearing.ball_radius
        air, start = (
            _arc_gap(bearing, raceway, 0.0, at) for at in (psi, one.a / bearing.ball_radius)
        )
        bend = air - y**2 / (2 * r_y) - (start - one.a**2 / (2 * r_y))
        area = weight * (1 + air / (2 * bearing.ball_radius))
        # side * psi points towards the shoulder to which the contact angle leans
        slope = _along(bearing, raceway, psi if side < 0 else -psi, abs(angle))
        turned = slope - _along(bearing, raceway, 0.0, abs(angle))
        total = total + _strips(one, y, area, separation, bend, turned)
    return total


def rigid_arc(
    bearing: Bearing, raceway: int, separation: ArrayLike, depth: float, angle: float = 0.0
) -> Numbers:
    """Return I in m for an unloaded ball at each `separation` (m) from the bottom of a circular
    groove of depth `depth` (m). For two eccentric cylinders, the result is accurate to 6e-5."""
    gaps = np.atleast_1d(np.asarray(separation, float))
    total = np.zeros(gaps.shape)
    for place, g0 in np.ndenumerate(gaps):
        edge = float(shoulder_angle(bearing.groove(raceway), bearing.ball_radius, depth, g0))
        for side in (-1, 1):
            psi, weight = _outward(0.0, edge + side * abs(angle))
            air = _arc_gap(bearing, raceway, g0, psi)
            slope = _along(bearing, raceway, psi if side < 0 else -psi, abs(angle))
            width = np.pi * np.sqrt(2 / (slope * air))
            total[place] += np.sum(weight * (bearing.ball_radius + air / 2) * width)
    return total.reshape(np.shape(separation))[()]


def beside(ratio: ArrayLike) -> Numbers:
    """Return G(H) of `laws.gap_beside` by numerical integration over strips of a line
    contact across the ellipse."""
    ratio = np.atleast_1d(np.asarray(ratio, float))
    y, weight = _inward(1.0, 1.0)
    xi = np.exp(np.arange(NEAR, FAR, STEP))  # the lower limit is one
    line = (1 + xi) * np.sqrt(xi * (2 + xi)) - np.log1p(xi + np.sqrt(xi * (2 + xi)))
    height = ratio[:, None] / (1 - y * y)
    strip = STEP * np.sum(xi / (height[..., None] + line), axis=-1)
    return 2 * np.sum(weight / np.sqrt(1 - y * y) * strip, axis=-1)


def _arc_gap(bearing, raceway, g0, psi):
    """Return the distance from ball to groove along a ray at the angle `psi` from the centre of the
    ball. At the bottom of the groove the distance is g0."""
    groove, radius = bearing.groove(raceway), bearing.ball_radius
    c = groove - radius - g0
    return np.sqrt(groove**2 - (c * np.sin(psi)) ** 2) - c * np.cos(psi) - radius


def _along(bearing, raceway, psi, angle):
    """Return 1/R_x at the angle `psi` from a contact at `angle`, measured towards the bottom."""
    cosine = np.cos(angle - psi)
    if raceway == INNER:
        curve = cosine / (bearing.inner_radius + bearing.inner_groove * (1 - cosine))
    else:
        curve = -cosine / (bearing.outer_radius - bearing.outer_groove * (1 - cosine))
    return 1 / bearing.ball_radius + curve


def _strips(one, y, weight, separation, bend=0.0, turned=0.0):
    """Return the sum over `y` of `weight` times the integral of dx/(h + g) for each h in
    `separation`."""
    inside = np.maximum(1 - (y / one.a) ** 2, 0.0)
    edge = one.b * np.sqrt(inside)
    away = one.b * np.exp(np.arange(NEAR, FAR, STEP))
    x = edge[:, None] + away
    past = one.b**2 * np.maximum(y**2 - one.a**2, 0.0)
    beyond = one.a**2 * away * (2 * edge[:, None] + away) + past[:, None]
    gaps = _gap(one, x, y[:, None], beyond)
    gaps = gaps + np.reshape(bend, (-1, 1)) + x * x / 2 * np.reshape(turned, (-1, 1))
    heights = np.asarray(separation, float)
    sums = [2 * STEP * np.sum(weight @ (away / (h + gaps))) for h in heights.ravel()]
    return np.reshape(sums, heights.shape)[()]


def _panels(length, last):
    """Return nodes and weights for distances that decrease from `length` over at least `last`
    e-folds."""
    count = int(np.ceil(last / PANEL))
    width = last / count
    start = width * np.arange(count)[:, None]
    fold = (start + width * (1 + NODES) / 2).ravel()
    away = length * np.exp(-fold)
    return away, np.tile(width / 2 * WEIGHTS, count) * away


def _inward(a, reach) -> tuple[Floats, Floats]:
    """Return (y, weights) from 0 to `reach`, at most a, with nodes that are denser towards a."""
    away, weight = _panels(a, DEEP)
    if reach < a:  # the groove ends within the ellipse
        half = reach / 2
        return half * (1 + NODES), half * WEIGHTS
    return a - away, weight


def _outward(a, reach) -> tuple[Floats, Floats]:
    """Return (y, weights) from a to `reach`, with nodes that are denser towards a."""
    away, weight = _panels(reach - a, DEEP)
    return a + away, weight
