# SPDX-License-Identifier: GPL-2.0-or-later
"""Speeds of the parts of a bearing whose balls roll without slip, and of balls in a run."""

from typing import NamedTuple

import numpy as np

from raceway.arrays import Numbers
from raceway.core import laws
from raceway.theory.bearing import Bearing


class Frequencies(NamedTuple):
    """Kinematic frequencies, in the same unit as the speeds of the rings."""

    cage: Numbers  # FTF, positive if the inner ring's speed is positive
    outer: Numbers  # BPFO, rate of ball passes over a point on the outer ring
    inner: Numbers  # BPFI, rate of ball passes over a point on the inner ring
    spin: Numbers  # BSF, rotational speed of a ball relative to the cage


def frequencies(
    bearing: Bearing, angle: Numbers = 0.0, inner: Numbers = 1.0, outer: Numbers = 0.0
) -> Frequencies:
    """Return the FTF, BPFO, BPFI and BSF at a contact `angle` in rad, for rings that turn at the
    speeds `inner` and `outer`. By default, the outer ring is at rest and the frequencies are in
    orders of the shaft speed.

    BSF = (1 - gamma^2 cos^2(angle)) / (2 gamma) |inner - outer|, where gamma is the ratio of ball
    to pitch diameter (Harris, Rolling Bearing Analysis, ch. 10): a ball rolls about an axis that is
    perpendicular to its contact normals.

    >>> from raceway.theory.bearing import Bearing
    >>> paper = Bearing(9, 12.6e-3, 24.0e-3, 36.6e-3, 6.552e-3, 6.552e-3)
    >>> [round(float(order), 4) for order in frequencies(paper)]
    [0.396, 3.5644, 5.4356, 2.3008]
    """
    ball = bearing.ball_radius * np.cos(angle)
    orbit, spin = laws.pure_rolling(ball, bearing.pitch_radius, inner, outer)
    passes = (bearing.balls * np.abs(orbit - ring) for ring in (outer, inner))
    return Frequencies(orbit, *passes, np.abs(orbit - spin) * np.cos(angle))


def cosine_of_cage(bearing: Bearing, order: float) -> float:
    """Return the cosine of the contact angle at which balls that roll without slip give the cage
    the `order` (ratio of cage speed to shaft speed with the outer ring at rest), i.e. the inverse
    of FTF in `frequencies`. The result is above 1 if the cage slips more than any angle can
    explain."""
    return (1 - 2 * order) * bearing.pitch_radius / bearing.ball_radius


def entrainment(bearing: Bearing, spin: Numbers, angle: Numbers = 0.0) -> Numbers:
    """Return the entrainment speed in m/s, which is the same at both raceways, for an inner ring
    that turns at `spin` rad/s.

    U_r = omega r_pitch (1 - gamma^2)/2 is half the sum of the speeds of both surfaces relative to
    the contact.
    """
    ball, pitch = bearing.ball_radius * np.cos(angle), bearing.pitch_radius
    orbit = laws.pure_rolling(ball, pitch, np.abs(spin), 0.0).orbit
    return (np.abs(spin) - orbit) * (pitch - ball)


def spall_length(
    bearing: Bearing, spin: Numbers, seconds: Numbers, angle: Numbers = 0.0
) -> Numbers:
    """Return the length in m of a spall along rolling, from the time `seconds` between the entry of
    a ball and its impact; the inner ring turns at `spin` rad/s.

    The impact occurs when the ball is half-way across (Sawalha and Randall, Mech. Syst. Signal
    Process. 25 (2011) 846). A ball that loses its load over the spall hits later, so this formula
    overestimates the length; `spall.length` takes the flight of the ball into account.

    >>> from raceway.theory.bearing import Bearing
    >>> paper = Bearing(9, 12.6e-3, 24.0e-3, 36.6e-3, 6.552e-3, 6.552e-3)
    >>> print(f"{spall_length(paper, 3000 * np.pi / 30, 0.2196e-3):.3e} m")
    2.000e-03 m
    """
    return 2 * entrainment(bearing, spin, angle) * np.asarray(seconds)
