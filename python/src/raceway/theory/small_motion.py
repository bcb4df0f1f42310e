# SPDX-License-Identifier: GPL-2.0-or-later
"""Small motions of a ring about its equilibrium, with balls that follow the ring, described by a 5
x 5 stiffness matrix and a 5 x 5 damping matrix.

Each ball has two degrees of freedom in the plane through the bearing's axis, and the ring has five.
Springs, dampers and inertia of the balls are assembled in these seven degrees of freedom at one
frequency. The degrees of freedom of each ball are then eliminated, and the contributions of all
balls to the ring are added. The damper of a contact therefore acts only on a part of the ring's
motion, as does the spring with which it is in series.
"""

from typing import NamedTuple

import numpy as np

from raceway.arrays import Floats, Numbers, short

SLOW = 1e-9  # rad/s, low enough for the damping to equal the limit for slow motion


class Linear(NamedTuple):
    """Linearised balls of a ring in equilibrium. Derivatives are taken with respect to the seven
    coordinates of `circle`, in which those of the ball come first."""

    stiffness: Floats  # (Z, 7, 7), second derivatives of the energy, N/m, N and N m
    approach: Floats  # (C, Z, 7), derivatives of the overlaps of the contacts, inner ones first
    along: Floats  # (C, Z), N/m, stiffness of the contacts along their lines of action
    # (Z,), bool, True for balls with an inner contact, because only these support the inner ring
    loaded: Floats

    __repr__ = short


class Response(NamedTuple):
    """Response of a ring to small motions at one frequency, in the order x, y, z, rx, ry."""

    stiffness: Floats  # (5, 5), N/m, N/rad, N m/rad
    damping: Floats  # (5, 5), N s/m, N s/rad, N m s/rad

    __repr__ = short


def condensed(whole: Floats) -> Floats:
    """Return the stiffness (5, 5), real or complex, of a ring with balls `whole` (Z, 7, 7) that
    follow it."""
    own, mixed = whole[:, 2:, 2:], whole[:, :2, 2:]
    follow = np.linalg.solve(whole[:, :2, :2], mixed)
    return (own - mixed.transpose(0, 2, 1) @ follow).sum(0)


def response(
    linear: Linear,
    damping: Numbers,
    frequency: float = 0.0,
    *,
    stiffening: Numbers = 0.0,
    ball_mass: float = 0.0,
) -> Response:
    """Return the `Response` for dampers `damping` (C, Z) in N s/m that are in parallel with the
    springs of the contacts, at `frequency` in rad/s; 0 gives the limit for slow motion.

    `stiffening` (C, Z) in N/m is added to the springs, for example the stiffness of a film at that
    frequency. `ball_mass` in kg is the mass of one ball, which moves in its plane. Raises
    `ValueError` if the frequency or a damper is negative.

    The two springs of a ball are in series, and so are its two dampers:

    >>> from raceway.theory import static
    >>> from raceway.theory.bearing import Bearing
    >>> b = Bearing(9, 12.6e-3, 24.0e-3, 36.6e-3, 6.552e-3, 6.552e-3)
    >>> rest = static.equilibrium(b, 3000.0)
    >>> one = response(rest.linear, 1e-5 * rest.linear.along)
    >>> round(float(one.damping[0, 0] / one.stiffness[0, 0] * 1e5), 3)
    1.0
    """
    damping = np.asarray(damping, float)
    if not (frequency >= 0 and np.all(damping >= 0)):
        raise ValueError(
            f"frequency {frequency:g} rad/s must be 0 or more, and so must all dampers, of which"
            f" the smallest is {damping.min():g} N s/m"
        )
    rate = max(frequency, SLOW)
    added = np.broadcast_to(stiffening + 1j * rate * damping, linear.along.shape)
    whole = linear.stiffness + np.einsum("sz,sza,szb->zab", added, linear.approach, linear.approach)
    whole[:, [0, 1], [0, 1]] -= ball_mass * frequency**2
    ring = condensed(whole[linear.loaded])
    return Response(ring.real, ring.imag / rate)
