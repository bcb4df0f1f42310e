# SPDX-License-Identifier: GPL-2.0-or-later
"""Width of a raceway groove around a ball: the angle of its shoulder, and the half-width of a
parabolic groove with the same capacitance. Lengths are in m, and angles are in rad."""

from typing import NamedTuple

import numpy as np

from raceway.arrays import Numbers
from raceway.theory.bearing import INNER, Bearing

USUAL_DEPTH = 0.18  # fraction of the ball diameter, assumed if the shoulder is unknown


class HalfWidths(NamedTuple):
    """Half-widths S in m of the parabola on both sides of a contact, which are equal at zero
    contact angle."""

    near: Numbers  # on the side of the closer shoulder
    far: Numbers


def depth(
    bearing: Bearing, raceway: int, shoulder: float = np.nan, clearance: float = 0.0
) -> float:
    """Return the depth t in m, i.e. the height of the shoulder with the diameter `shoulder` (m)
    above the bottom of the groove; t is 0.18 ball diameters if `shoulder` is NaN. The diametral
    `clearance` (m) is assigned to the outer groove.

    Raises `ValueError` if the shoulder is not between the bottom and the centre of the groove.
    """
    if np.isnan(shoulder):
        return USUAL_DEPTH * bearing.ball_diameter
    bottom = bearing.inner_radius if raceway == INNER else bearing.outer_radius + clearance / 2
    found = shoulder / 2 - bottom if raceway == INNER else bottom - shoulder / 2
    if not 0 < found <= bearing.groove(raceway):
        raise ValueError(
            f"shoulder diameter = {shoulder:g} m is {found:.6g} m from the groove's bottom: must be"
            f" more than 0 and at most the groove's radius, {bearing.groove(raceway):g} m"
        )
    return found


def shoulder_angle(
    groove: float, ball_radius: float, depth: float, gap: Numbers = 0.0, offset: float = 0.0
) -> Numbers:
    """Return theta_b in rad, the angle of the shoulder as seen from the centre of a ball that is
    `gap` (m) away from the bottom of its groove. The groove has the radius `groove` (m) and the
    depth `depth` (m), and its centre of curvature is `offset` (m) from the plane of the ball.

    tan(theta_b) = (r_c sin(theta) - offset)/(R_b - t + gap) with cos(theta) = 1 - t/r_c (derived in
    docs/electric).
    """
    sine = np.sqrt(depth * (2 * groove - depth))
    return np.arctan2(sine - offset, ball_radius - depth + gap)


def half_widths(
    bearing: Bearing,
    raceway: int,
    depth: float,
    angle: Numbers = 0.0,
    clearance: float = 0.0,
    semi_axis: Numbers = 0.0,
) -> HalfWidths:
    """Return the `HalfWidths` of a groove with the depth `depth` (m) at the contact angle `angle`
    (rad), measured around the contact ellipse, whose semi-axis across the groove is a = `semi_axis`
    (m; 0 if there is no load). The arrays have the shape to which `angle` and `semi_axis` are
    broadcast. `clearance` is diametral, in m.

    S = R_b (4 tan(t/4) ± 0.09 gamma) with t = theta_b -/+ angle is the half-width of the parabola
    that has the same capacitance as the arc (derived in docs/electric). The sign is + 0.09 gamma
    for the inner and - for the outer raceway. S is zero beyond the shoulder. Within the ellipse the
    groove is already the parabola, so the excess of the arc is subtracted there: 4 R_b q_a - a from
    the first term and a fraction (q_a/q)^2 of the second, with q = tan(t/4) and q_a = tan(a/(4
    R_b)).

    A groove of a four-point contact bearing ends in the central plane, where the other groove of
    the ring begins. On the side away from its shoulder, t is therefore the contact angle and the
    term with 0.09 is absent. With the `offset` G of the groove's centre and the contact angle
    alpha_0 of a centred ball, tan(theta_b) = (r_c sin(theta) - G)/(R_b - t + (r_c - R_b)(1 -
    cos(alpha_0))).

    >>> b = Bearing(9, 12.6e-3, 24.0e-3, 36.6e-3, 6.552e-3, 6.552e-3)
    >>> [round(1e3 * float(half_widths(b, side, 2.3e-3).near), 3) for side in (0, 1)]  # mm
    [5.85, 5.614]
    """
    radius, slack = bearing.ball_radius, bearing.groove_gap(raceway)
    offset, lean = bearing.arch(raceway), np.abs(angle)
    if offset:
        lower = slack - np.sqrt(slack**2 - offset**2)
        edge = shoulder_angle(bearing.groove(raceway), radius, depth, lower, offset)
        sides, turned = (edge - lean, lean), 0.0
    else:
        edge = shoulder_angle(bearing.groove(raceway), radius, depth)
        r_x, _ = bearing.effective_radii(raceway, angle, clearance)
        sides, turned = (edge - lean, edge + lean), 0.09 * (1 - r_x / radius)  # + inner, - outer
    within = np.tan(np.asarray(semi_axis, float) / (4 * radius))  # q_a
    widths = []
    for side in sides:
        quarter = np.tan(side / 4)
        part = (within / np.maximum(quarter, within + 1e-300)) ** 2
        width = radius * (4 * (quarter - within) + turned * (1 - part)) + semi_axis
        widths.append(np.maximum(width, 0.0)[()])
    return HalfWidths(*widths)
