# SPDX-License-Identifier: GPL-2.0-or-later
"""Small vibrations of a shaft about its equilibrium (`shaft`): rigid-body properties, bending
modes, and natural frequencies for the bearing stiffness at equilibrium."""

from collections.abc import Sequence

import numpy as np

from raceway.arrays import Floats
from raceway.theory import beam, beam_motion, shaft_bending
from raceway.theory.beam import FREEDOMS
from raceway.theory.shaft import Load, Rest, Shaft

FINENESS = 24  # minimum number of elements in a shaft


def nodes(
    shaft: Shaft, rest: Rest, places: Sequence[float] = ()
) -> tuple[Floats, beam_motion.Matrices]:
    """Return the positions z in m and the `beam_motion.Matrices` of the nodes, which are the nodes
    of `rest`, nodes at `places` (m) and additional nodes. Raises `ValueError` for a position off
    the shaft."""
    z, _ = beam.divided(shaft.sections, [*rest.z, *places])
    longest = z[-1] / FINENESS
    places = [
        place
        for first, last in zip(z, z[1:])
        for place in np.linspace(first, last, int(np.ceil((last - first) / longest)) + 1)
    ]
    z, pieces = beam.divided(shaft.sections, places)
    return z, beam_motion.matrices(z, pieces, shaft.discs, shaft.steel)


def rigid(shaft: Shaft, rest: Rest) -> beam_motion.Rigid:
    """Return the shaft as a rigid body, the input for `fix bearing/shaft`."""
    return beam_motion.rigid(*nodes(shaft, rest))


def bending(
    shaft: Shaft,
    rest: Rest,
    loads: Sequence[Load],
    *,
    modes: int = 4,
    damping: float = 0.0,
    kept: Sequence[float] = (),
    places: Sequence[float] = (),
) -> shaft_bending.Bending:
    """Return the bending modes of `shaft`. The kept nodes are at the bearings, at the positions of
    transverse `loads`, and at `kept` (m).

    The number of `modes` per plane and the `damping` ratio are as in `shaft_bending.bending`.
    Stations are the nodes of `rest`, the centre of mass, `kept` and `places` (m). Raises
    `ValueError` for a position off the shaft or if there are too many modes.
    """
    centre = rigid(shaft, rest).centre
    stations = [*rest.z, centre, *kept, *places]
    z, whole = nodes(shaft, rest, [centre, *kept, *places])

    def node(place):
        return int(np.argmin(np.abs(z - place)))

    across = [one.at for one in loads if any(one.force[:2]) or any(one.moment)]
    held = {node(place) for place in (*(one.seat.at for one in rest.bearings), *across, *kept)}
    return shaft_bending.bending(
        z, whole, sorted(held), modes, sorted({node(place) for place in stations}), damping
    )


def frequencies(shaft: Shaft, rest: Rest, speed: float) -> Floats:
    """Return the natural frequencies (5 N,) in rad/s, in ascending order, at the shaft `speed` in
    rad/s.

    >>> from raceway.theory.bearing import Bearing
    >>> from raceway.theory.beam import Section
    >>> from raceway.theory.shaft import Load, Seat, rest
    >>> b = Bearing(9, 12.6e-3, 24.0e-3, 36.6e-3, 6.552e-3, 6.552e-3)
    >>> whole = Shaft([Section(0.4, 0.04)])
    >>> loads = [Load(0.2, (0.0, -3000.0, 500.0))]
    >>> still = rest(whole, [Seat(0.0, b), Seat(0.4, b)], loads)
    >>> [round(f / 2 / np.pi) for f in frequencies(whole, still, 300.0)[:3]]
    [259, 482, 494]
    """
    z, whole = nodes(shaft, rest)
    return beam_motion.frequencies(whole, springs(z, rest), speed)


def springs(z: Floats, rest: Rest) -> Floats:
    """Return the stiffness (5 N, 5 N) of the bearings at the nodes `z` (N,) in m."""
    whole = np.zeros((FREEDOMS * len(z), FREEDOMS * len(z)))
    for one in rest.bearings:
        first = FREEDOMS * int(np.argmin(np.abs(z - one.seat.at)))
        whole[first : first + FREEDOMS, first : first + FREEDOMS] += one.stiffness
    return whole
