# SPDX-License-Identifier: GPL-2.0-or-later
"""Rotation of balls that roll on both raceways under Coulomb's law and the gyroscopic moment.

In the plane spanned by the bearing's axis e and the radial direction u of a ball, rolling on both
raceways leaves one speed undetermined: the radial component x of the ball's rotation. The orbital
speed Omega and both spins are linear functions of x. An orbiting ball with inertia J needs the
moment J Omega x about the direction t of its path. Only friction across the raceways can supply
this moment, so the ball rotates about t and slides across both raceways at the speed s:

    J Omega x = R_b sum of mu Q s/sqrt(s^2 + v^2),    v = s_e/3.80,

as in the law that the simulation uses for slip across the groove (docs/tribology, Slip in a time
step). This rotation in turn needs the moment J Omega s/R_b about u, which is supplied by spin:

    sum of M_k domega_k/dx + J Omega s/R_b = 0,    M_k = the moment of spin in the presence of s.

If friction is too low to supply the moment, x is limited and s grows, i.e. the ball pivots and
slides.
"""

from typing import NamedTuple

import numpy as np

from raceway.arrays import Floats, short
from raceway.core import laws
from raceway.theory import sliding
from raceway.theory.bearing import INNER, OUTER, Bearing

HALVINGS = 120  # number of bisections; sliding speeds range over up to 20 orders of magnitude
ROUNDS = 5  # number of iterations for the orbital speed


class Attitude(NamedTuple):
    """Motion of Z balls with two contacts each; contacts with the inner ring come first."""

    orbit: Floats  # (Z,), rad/s, orbital speed
    spin: Floats  # (2, Z), rad/s, spin of the ball relative to the ring about the contact normal
    moment: Floats  # (2, Z), N m, moment that opposes the spin
    across: Floats  # (Z,), m/s, sliding speed across both raceways, not negative
    force: Floats  # (2, Z), N, force that opposes the sliding
    radial: Floats  # (Z,), rad/s, radial component x of the rotation

    __repr__ = short


def balanced(
    bearing: Bearing,
    angle: Floats,
    ring: float,
    limit: Floats,
    a: Floats,
    pure: Floats,
    edge: Floats,
    density: float,
) -> Attitude:
    """Compute the `Attitude` of balls at the contact angles `angle` (2, Z) in rad, with the inner
    ring turning at `ring` rad/s (not 0).

    The contacts (2, Z) are described by the friction `limit` mu Q (N), the semi-axis `a` (m), the
    moment `pure` of pure spin (N m) and the sliding speed `edge` s_e of differential slip (m/s).
    The ball `density` in kg/m^3 must be above 0.
    """
    none, turn = rolling(bearing, angle, ring)
    radius, edge = bearing.ball_radius, np.maximum(edge, sliding.LEAST)
    inertia = 8 / 15 * np.pi * radius**5 * density
    momentum = inertia * np.abs(none[0])
    for _ in range(ROUNDS):  # the orbital speed depends only weakly on x
        slide = _slide(none, turn, radius, limit, a, pure, edge, momentum)
        motion, share, force = _at(slide, none, turn, radius, limit, a, edge, momentum)
        momentum = inertia * np.abs(motion[0])
    radial = (motion[1] - none[1]) / turn[1]
    return Attitude(motion[0], motion[1:], pure * share, np.abs(slide), np.abs(force), radial)


def _at(slide, none, turn, radius, limit, a, edge, momentum):
    """Return three arrays for balls that slide at `slide` (Z,) m/s, which has the sign of x: the
    orbit and spins (3, Z), the fractions of the moment of pure spin (2, Z), and the forces across
    the grooves (2, Z). `momentum` is J Omega."""
    force = limit * slide / np.hypot(slide, edge / sliding.LEAN)
    motion = none + turn * radius * force.sum(0) / momentum
    return motion, laws.spin_shares(np.abs(motion[1:]) * a, edge, np.abs(slide)).spin, force


def _slide(none, turn, radius, limit, a, pure, edge, momentum):
    """Return the `slide` for `_at` at which the moments about u balance; their sum increases with
    it."""
    high = radius * (pure * np.abs(turn[1:])).sum(0) / momentum
    low = -high
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        motion, share, _ = _at(middle, none, turn, radius, limit, a, edge, momentum)
        against = (np.sign(motion[1:]) * pure * share * turn[1:]).sum(0)
        beyond = against + momentum * middle / radius > 0
        low, high = np.where(beyond, low, middle), np.where(beyond, middle, high)
    return (low + high) / 2


def rolling(bearing: Bearing, angle: Floats, ring: float) -> tuple[Floats, Floats]:
    """Return (none, turn), both (3, Z). `none` contains the orbit and both spins in rad/s of balls
    that roll on both raceways without radial rotation, and `turn` their changes per rad/s of radial
    rotation. The angles (2, Z) and `ring` are as in `balanced`."""
    sizes = angle[INNER], angle[OUTER], ring, bearing.ball_radius, bearing.pitch_radius
    none, one = (laws.rolling_on_both(*sizes, radial) for radial in (0.0, 1.0))
    none, one = (np.array([m.orbit, m.spin_inner, m.spin_outer]) for m in (none, one))
    return none, one - none
