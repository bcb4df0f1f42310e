# SPDX-License-Identifier: GPL-2.0-or-later
"""Reduced bending model of a round shaft, the input for `fix bearing/shaft ... flexible`.

The reduction follows Craig and Bampton (AIAA J. 6 (1968) 1313) in one plane. Its coordinates are
the displacement and tilt of the kept nodes, and the amplitudes of the modes that the other nodes
have with the kept nodes held. The natural modes of the free reduced shaft are its two rigid-body
motions and the elastic modes, which are mass-orthogonal to them. A round shaft has the same modes
in both planes.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from raceway.arrays import Floats
from raceway.theory import beam_motion
from raceway.theory.beam import FREEDOMS


class Bending(NamedTuple):
    """A shaft as a rigid body with n elastic modes in each plane, which are defined at N stations.

    The coordinate q (m) of a mode is its largest displacement. At a station, the shaft moves by
    ``shape[mode, station, 0] * q`` and tilts by ``shape[mode, station, 1] * q`` in the plane.
    """

    body: beam_motion.Rigid
    z: Floats  # (N,), m
    shape: Floats  # (n, N, 2), displacement (1) and tilt (rad/m) of each mode
    mass: Floats  # (n,), kg
    stiffness: Floats  # (n,), N/m
    damping: Floats  # (n,), N s/m
    # (n + 1, n + 1), to be multiplied by the spin; a rigid tilt (rad) first, then the modes
    gyroscopic: Floats


def bending(
    z: Floats,
    whole: beam_motion.Matrices,
    kept: Sequence[int],
    modes: int,
    stations: Sequence[int],
    damping: float = 0.0,
) -> Bending:
    """Return the `Bending` of the shaft with the matrices `whole` and the nodes at `z` (N,) in m.

    The response of the `kept` nodes to steady loads on them is exact; `modes` is the number of
    modes per plane with the kept nodes held. The result has ``2 len(kept) + modes - 2`` elastic
    modes. `stations` are the nodes at which the mode shapes are needed. `damping` is the damping
    ratio of every mode. Raises `ValueError` if there are more modes than the shaft has, or no
    elastic modes at all.

    >>> from raceway.theory.beam import STEEL, Section, divided
    >>> z, pieces = divided([Section(0.5, 0.02)], np.linspace(0, 0.5, 21))
    >>> found = bending(z, beam_motion.matrices(z, pieces), [4, 16], 4, [0, 4, 16, 20])
    >>> thin = 4.7300**2 * np.sqrt(STEEL.young / STEEL.density) * 0.005 / 0.5**2  # free beam
    >>> found.shape.shape, round(float(np.sqrt(found.stiffness / found.mass)[0] / thin), 3)
    ((6, 4, 2), 0.996)
    """
    import scipy.linalg

    body = beam_motion.rigid(z, whole)
    one, other = planes(len(z))
    mass, stiffness = one.T @ whole.mass @ one, one.T @ whole.stiffness @ one
    basis = _craig_bampton(mass, stiffness, kept, modes)
    few = [basis.T @ matrix @ basis for matrix in (stiffness, mass)]
    shapes = basis @ scipy.linalg.eigh(*few)[1][:, 2:]
    if not shapes.shape[1]:
        raise ValueError("a shaft that bends needs another kept position or a mode")
    # remove the rounding errors in the modes that correspond to rigid-body motions
    rigid = np.zeros((2 * len(z), 2))
    rigid[0::2, 0], rigid[0::2, 1], rigid[1::2, 1] = 1.0, z - body.centre, 1.0
    own = rigid.T @ mass
    shapes -= rigid @ np.linalg.solve(own @ rigid, own @ shapes)
    largest = np.abs(shapes[0::2]).argmax(0) * 2
    shapes /= shapes[largest, np.arange(shapes.shape[1])]
    tilting = np.column_stack([rigid[:, 1], shapes])
    gyroscopic = (one @ tilting).T @ whole.gyroscopic @ (other @ tilting)
    own_mass = np.einsum("ij,ik,kj->j", shapes, mass, shapes)
    own_stiffness = np.einsum("ij,ik,kj->j", shapes, stiffness, shapes)
    return Bending(
        body,
        z[list(stations)],
        shapes.T.reshape(shapes.shape[1], len(z), 2)[:, list(stations)],
        own_mass,
        own_stiffness,
        2 * damping * np.sqrt(own_mass * own_stiffness),
        (gyroscopic + gyroscopic.T) / 2,
    )


def planes(nodes: int) -> tuple[Floats, Floats]:
    """Return two matrices (5 N, 2 N), N = `nodes`, that map displacement and slope in a plane to
    the degrees of freedom of `beam`. The first is for the plane of x, in which the slope is ry; the
    second is for the plane of y, in which the slope is -rx."""
    one, other = np.zeros((FREEDOMS * nodes, 2 * nodes)), np.zeros((FREEDOMS * nodes, 2 * nodes))
    for k in range(nodes):
        one[FREEDOMS * k, 2 * k] = one[FREEDOMS * k + 4, 2 * k + 1] = 1.0
        other[FREEDOMS * k + 1, 2 * k], other[FREEDOMS * k + 3, 2 * k + 1] = 1.0, -1.0
    return one, other


def _craig_bampton(mass: Floats, stiffness: Floats, kept: Sequence[int], modes: int) -> Floats:
    """Return the motions (2 N, 2 kept + modes) in one plane, first those of the kept nodes, then
    those of the modes."""
    import scipy.linalg

    held = np.concatenate([2 * k + np.arange(2) for k in kept])
    rest = np.setdiff1d(np.arange(len(mass)), held)
    if modes > len(rest):
        raise ValueError(f"{modes} modes: the shaft has {len(rest)} in addition to its kept nodes")
    basis = np.zeros((len(mass), len(held) + modes))
    basis[held, np.arange(len(held))] = 1.0
    inner = np.ix_(rest, rest)
    if len(rest):
        basis[rest, : len(held)] = -np.linalg.solve(stiffness[inner], stiffness[np.ix_(rest, held)])
    if modes:
        basis[rest, len(held) :] = scipy.linalg.eigh(
            stiffness[inner], mass[inner], subset_by_index=[0, modes - 1]
        )[1]
    return basis
