# SPDX-License-Identifier: GPL-2.0-or-later
"""Inertia of a `beam`, and reduction of its matrices to a few coordinates.

The mass and gyroscopic matrices are consistent with Timoshenko's element (Przemieniecki, Theory of
Matrix Structural Analysis, 1968, ch. 11; Friswell et al., Dynamics of Rotating Machines, 2010, ch.
5). The reduction follows Craig and Bampton (AIAA J. 6 (1968) 1313): some nodes are kept; the other
nodes follow them and, in addition, vibrate in the modes of the shaft with the kept nodes held.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from raceway.arrays import Floats
from raceway.theory import beam
from raceway.theory.beam import FREEDOMS, STEEL, Disc, Section, Steel


class Matrices(NamedTuple):
    """Matrices (5 N, 5 N) for all nodes, M q'' + spin G q' + K q = f, with the spin in rad/s."""

    mass: Floats
    gyroscopic: Floats
    stiffness: Floats


class Reduced(NamedTuple):
    """A reduced shaft with 5 coordinates for each kept node and one for each mode."""

    mass: Floats  # (n, n)
    gyroscopic: Floats  # (n, n), to be multiplied by the spin
    stiffness: Floats  # (n, n)
    shapes: Floats  # (5 N, n), displacements of all nodes for a unit of each coordinate
    frequencies: Floats  # (modes,), rad/s, natural frequencies with the kept nodes held


class Rigid(NamedTuple):
    """A shaft as a rigid body."""

    mass: float  # kg
    centre: float  # m, position of the centre of mass along the shaft
    axial: float  # kg m^2
    transverse: float  # kg m^2, about an axis through the centre


def _planes(section: Section, steel: Steel) -> tuple[Floats, Floats]:
    """Return the mass matrices (4, 4) of an element in one plane: one for displacements and one for
    tilts, i.e. for rotation about a diameter."""
    length, soft = section.length, beam.softness(section, steel)
    one = steel.density * beam.area(section) * length / (1 + soft) ** 2
    a = 13 / 35 + 7 * soft / 10 + soft**2 / 3
    b = (11 / 210 + 11 * soft / 120 + soft**2 / 24) * length
    c = 9 / 70 + 3 * soft / 10 + soft**2 / 6
    d = (13 / 420 + 3 * soft / 40 + soft**2 / 24) * length
    e = (1 / 105 + soft / 60 + soft**2 / 120) * length**2
    f = (1 / 140 + soft / 60 + soft**2 / 120) * length**2
    moved = one * np.array([[a, b, c, -d], [b, e, d, -f], [c, d, a, -b], [-d, -f, -b, e]])
    two = steel.density * beam.second_moment(section) / (length * (1 + soft) ** 2)
    g, h = 6 / 5, (1 / 10 - soft / 2) * length
    i = (2 / 15 + soft / 6 + soft**2 / 3) * length**2
    j = (-1 / 30 - soft / 6 + soft**2 / 6) * length**2
    tilted = two * np.array([[g, h, -g, h], [h, i, -h, j], [-g, -h, g, -h], [h, j, -h, i]])
    return moved, tilted


def _element(section: Section, steel: Steel) -> tuple[Floats, Floats]:
    """Return the mass matrix (10, 10) of an element between two nodes, and its gyroscopic matrix
    (10, 10) at 1 rad/s."""
    moved, tilted = _planes(section, steel)
    mass = np.zeros((2 * FREEDOMS, 2 * FREEDOMS))
    picks = []
    for across, tilt, sign in ((0, 4, 1.0), (1, 3, -1.0)):
        pick = np.zeros((4, 2 * FREEDOMS))
        for row, column in enumerate((across, tilt, FREEDOMS + across, FREEDOMS + tilt)):
            pick[row, column] = sign if row % 2 else 1.0
        picks.append(pick)
        mass += pick.T @ (moved + tilted) @ pick
    axial = steel.density * beam.area(section) * section.length / 6
    mass[np.ix_([2, 7], [2, 7])] += axial * np.array([[2, 1], [1, 2]])
    # the polar inertia is twice the diametral one, and rx is minus the slope in its plane
    across = -2 * picks[1].T @ tilted @ picks[0]
    return mass, across - across.T


def matrices(
    z: Floats, pieces: Sequence[Section], discs: Sequence[Disc] = (), steel: Steel = STEEL
) -> Matrices:
    """Assemble the `Matrices` of elements between the nodes `z` (N,) in m (see `beam.divided`),
    with `discs` at nodes."""
    stiffness = beam.stiffness(pieces, steel)
    mass, gyroscopic = np.zeros_like(stiffness), np.zeros_like(stiffness)
    for k, piece in enumerate(pieces):
        at = slice(FREEDOMS * k, FREEDOMS * (k + 2))
        for whole, part in zip((mass, gyroscopic), _element(piece, steel)):
            whole[at, at] += part
    for disc in discs:
        first = FREEDOMS * int(np.argmin(np.abs(z - disc.at)))
        at = np.arange(first, first + FREEDOMS)
        mass[at, at] += [disc.mass] * 3 + [disc.transverse] * 2
        gyroscopic[first + 3, first + 4] += disc.axial
        gyroscopic[first + 4, first + 3] -= disc.axial
    return Matrices(mass, gyroscopic, stiffness)


def rigid(z: Floats, whole: Matrices) -> Rigid:
    """Return the rigid-body properties of `whole`, whose nodes are at `z` (N,) in m.

    >>> z, pieces = beam.divided([Section(0.5, 0.04)], [])
    >>> found = rigid(z, matrices(z, pieces))
    >>> round(found.mass, 4), round(found.centre, 4), round(found.axial, 7)
    (4.9009, 0.25, 0.0009802)
    >>> round(found.transverse / (found.mass * (0.5**2 + 3 * 0.02**2) / 12), 6)
    1.0
    """
    nodes = len(z)
    moved, turned = np.zeros((nodes, FREEDOMS)), np.zeros((nodes, FREEDOMS))
    moved[:, 0] = 1.0
    turned[:, 0], turned[:, 4] = z, 1.0
    moved, turned = moved.ravel(), turned.ravel()
    mass = float(moved @ whole.mass @ moved)
    centre = float(moved @ whole.mass @ turned) / mass
    about = turned - centre * moved
    other = np.zeros((nodes, FREEDOMS))
    other[:, 1], other[:, 3] = centre - z, 1.0
    return Rigid(
        mass,
        centre,
        float(other.ravel() @ whole.gyroscopic @ about),
        float(about @ whole.mass @ about),
    )


def reduced(whole: Matrices, kept: Sequence[int], modes: int) -> Reduced:
    """Reduce `whole` to the nodes `kept` and to the lowest `modes` of the other nodes.

    The coordinate of a mode is its largest displacement in m. Raises `ValueError` if more modes are
    requested than the other nodes have degrees of freedom."""
    import scipy.linalg

    n = len(whole.mass)
    held = np.concatenate([FREEDOMS * k + np.arange(FREEDOMS) for k in kept])
    rest = np.setdiff1d(np.arange(n), held)
    if modes > len(rest):
        raise ValueError(f"{modes} modes: the shaft has {len(rest)} in addition to its bearings")
    shapes = np.zeros((n, len(held) + modes))
    shapes[held, np.arange(len(held))] = 1.0
    inner = np.ix_(rest, rest)
    frequencies = np.zeros(0)
    if len(rest):
        shapes[rest, : len(held)] = -np.linalg.solve(
            whole.stiffness[inner], whole.stiffness[np.ix_(rest, held)]
        )
    if modes:
        squares, own = scipy.linalg.eigh(
            whole.stiffness[inner], whole.mass[inner], subset_by_index=[0, modes - 1]
        )
        frequencies = np.sqrt(squares)
        shapes[rest, len(held) :] = own
        moved = np.abs(shapes[:, len(held) :].reshape(-1, FREEDOMS, modes)[:, :3]).max((0, 1))
        shapes[:, len(held) :] /= moved
    small = [shapes.T @ one @ shapes for one in whole]
    return Reduced(*small, shapes, frequencies)


def frequencies(whole: Matrices | Reduced, springs: Floats, speed: float = 0.0) -> Floats:
    """Return the natural frequencies (n,) in rad/s on `springs` (n, n), in ascending order. Motions
    that no spring restrains have the frequency 0.

    >>> z, pieces = beam.divided([Section(0.1, 0.04)] * 12, [])
    >>> ends = np.zeros(5 * len(z))
    >>> ends[[0, 1, 2, -5, -4]] = 1e12
    >>> found = frequencies(matrices(z, pieces), np.diag(ends))
    >>> thin = (np.pi / 1.2) ** 2 * np.sqrt(STEEL.young / STEEL.density) * 0.01
    >>> bool(0.98 < found[0] / thin < 1.0)
    True
    """
    n = len(whole.mass)
    stiffness = whole.stiffness + springs
    if speed == 0.0:
        import scipy.linalg

        return np.sqrt(np.maximum(scipy.linalg.eigh(stiffness, whole.mass, eigvals_only=True), 0.0))
    inverse = np.linalg.inv(whole.mass)
    system = np.block(
        [[np.zeros((n, n)), np.eye(n)], [-inverse @ stiffness, -speed * inverse @ whole.gyroscopic]]
    )
    return np.sort(np.abs(np.linalg.eigvals(system).imag))[::2]
