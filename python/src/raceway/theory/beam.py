# SPDX-License-Identifier: GPL-2.0-or-later
"""Stiffness of a round shaft made of straight sections, modelled as a Timoshenko beam along z.

Like a ring, a node has five degrees of freedom: x, y, z and the tilts rx, ry. The cross-section
tilts with the ring on it, so dx/dz = ry and dy/dz = -rx if there is no shear.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from raceway.arrays import Floats
from raceway.theory.steel import Steel

FREEDOMS = 5


class Section(NamedTuple):
    """A straight section of a shaft; lengths in m."""

    length: float
    diameter: float
    bore: float = 0.0


class Disc(NamedTuple):
    """A rigid body on the shaft that is thin in the axial direction."""

    at: float  # m
    mass: float  # kg
    axial: float = 0.0  # kg m^2
    transverse: float = 0.0  # kg m^2


STEEL = Steel()


def area(section: Section) -> float:
    """Return the area of the cross-section in m^2."""
    return np.pi / 4 * (section.diameter**2 - section.bore**2)


def second_moment(section: Section) -> float:
    """Return the second moment of area of the cross-section about a diameter in m^4."""
    return np.pi / 64 * (section.diameter**4 - section.bore**4)


def shear_coefficient(section: Section, poisson: float) -> float:
    """Return the shear coefficient of the cross-section (Cowper, J. Appl. Mech. 33 (1966) 335).

    >>> round(shear_coefficient(Section(1.0, 0.04), 0.3), 4)
    0.8864
    """
    hollow = (section.bore / section.diameter) ** 2
    even = (1 + hollow) ** 2
    return 6 * (1 + poisson) * even / ((7 + 6 * poisson) * even + (20 + 12 * poisson) * hollow)


def softness(section: Section, steel: Steel = STEEL) -> float:
    """Return the ratio of shear displacement to bending displacement for an element that is
    clamped at one end and guided at the other."""
    modulus = steel.young / (2 * (1 + steel.poisson))
    shear = shear_coefficient(section, steel.poisson) * area(section) * modulus
    return 12 * steel.young * second_moment(section) / (shear * section.length**2)


def element(section: Section, steel: Steel = STEEL) -> Floats:
    """Return the stiffness (10, 10) of an element between two nodes, in N/m, N and N m/rad."""
    length, bending = section.length, steel.young * second_moment(section)
    soft = softness(section, steel)
    k = bending / ((1 + soft) * length**3)
    plane = k * np.array(
        [
            [12, 6 * length, -12, 6 * length],
            [6 * length, (4 + soft) * length**2, -6 * length, (2 - soft) * length**2],
            [-12, -6 * length, 12, -6 * length],
            [6 * length, (2 - soft) * length**2, -6 * length, (4 + soft) * length**2],
        ]
    )
    stiffness = np.zeros((2 * FREEDOMS, 2 * FREEDOMS))
    for across, tilt, sign in ((0, 4, 1.0), (1, 3, -1.0)):
        at = [across, tilt, FREEDOMS + across, FREEDOMS + tilt]
        turn = np.array([1.0, sign, 1.0, sign])
        stiffness[np.ix_(at, at)] += plane * np.outer(turn, turn)
    axial = steel.young * area(section) / length
    stiffness[np.ix_([2, 7], [2, 7])] += axial * np.array([[1, -1], [-1, 1]])
    return stiffness


def divided(sections: Sequence[Section], places: Sequence[float]) -> tuple[Floats, list[Section]]:
    """Return (z of the nodes in m, elements between them). There are nodes at the ends of the
    sections and at `places` (m), rounded to whole nm. Raises `ValueError` if one of the `places` is
    off the shaft."""
    ends = np.round(np.concatenate([[0.0], np.cumsum([one.length for one in sections])]), 9)
    places = np.round(np.asarray(places, float), 9)
    if len(off := places[(places < 0) | (places > ends[-1])]):
        raise ValueError(f"{off[0]:g} m is not on the shaft, which reaches from 0 to {ends[-1]:g}")
    nodes = np.unique(np.concatenate([ends, places]))
    middle = (nodes[1:] + nodes[:-1]) / 2
    inside = np.clip(np.searchsorted(ends, middle) - 1, 0, len(sections) - 1)
    return nodes, [
        sections[k]._replace(length=float(length)) for k, length in zip(inside, np.diff(nodes))
    ]


def stiffness(pieces: Sequence[Section], steel: Steel = STEEL) -> Floats:
    """Return the stiffness (5 N, 5 N) of N - 1 elements in series. The degrees of freedom are
    ordered by node and, within a node, as x, y, z, rx, ry."""
    whole = np.zeros((FREEDOMS * (len(pieces) + 1),) * 2)
    for k, piece in enumerate(pieces):
        at = slice(FREEDOMS * k, FREEDOMS * (k + 2))
        whole[at, at] += element(piece, steel)
    return whole


def weight(pieces: Sequence[Section], gravity: Floats, steel: Steel = STEEL) -> Floats:
    """Return the loads (5 N,) due to the shaft's own weight under `gravity` (3,) in m/s^2. They
    include the moments that a uniform load exerts at the ends of an element."""
    loads = np.zeros(FREEDOMS * (len(pieces) + 1))
    for k, piece in enumerate(pieces):
        per_length = steel.density * area(piece) * np.asarray(gravity, float)
        for end, sign in ((k, 1.0), (k + 1, -1.0)):
            at = FREEDOMS * end
            loads[at : at + 3] += per_length * piece.length / 2
            loads[at + 4] += sign * per_length[0] * piece.length**2 / 12
            loads[at + 3] -= sign * per_length[1] * piece.length**2 / 12
    return loads
