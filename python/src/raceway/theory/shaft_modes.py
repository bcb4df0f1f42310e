# SPDX-License-Identifier: GPL-2.0-or-later
"""Classification of a shaft's natural motions on its bearings, and its critical speeds (Friswell et
al., Dynamics of Rotating Machines, 2010, ch. 5 and 6)."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from raceway.arrays import Floats
from raceway.theory import beam_motion
from raceway.theory.beam import FREEDOMS
from raceway.theory.beam_motion import Matrices
from raceway.theory.shaft import Rest, Shaft
from raceway.theory.shaft_motion import nodes, springs

FREE = 1e-5  # motions below this fraction of the median frequency are considered free
ROUND = 0.1  # motions with orbits of lower circularity are called planar
BENT = 0.5  # modes with a larger fraction of their strain energy in the shaft are called bending


class Mode(NamedTuple):
    """A natural motion or a critical speed."""

    speed: float  # rad/s, natural frequency, or the shaft speed that equals it
    shape: str  # axial, parallel, conical, bending or free
    whirl: str  # forward, backward or planar; empty for an axial or a free motion


def modes(shaft: Shaft, rest: Rest, speed: float) -> list[Mode]:
    """Return the natural motions at the shaft `speed` (rad/s), in order of frequency.

    >>> from raceway.theory.bearing import Bearing
    >>> from raceway.theory.beam import Section
    >>> from raceway.theory.shaft import Load, Seat, rest
    >>> b = Bearing(9, 12.6e-3, 24.0e-3, 36.6e-3, 6.552e-3, 6.552e-3)
    >>> whole = Shaft([Section(0.4, 0.04)])
    >>> loads = [Load(0.2, (0.0, -3000.0, 500.0))]
    >>> still = rest(whole, [Seat(0.0, b), Seat(0.4, b)], loads)
    >>> [one.shape for one in modes(whole, still, 300.0)[:3]]
    ['axial', 'bending', 'bending']
    """
    import scipy.linalg

    z, whole = nodes(shaft, rest)
    bearings = springs(z, rest)
    stiffness = whole.stiffness + bearings
    if speed == 0:  # modes are real, so both modes of a pair with equal frequency are planar
        squares, real = scipy.linalg.eigh(stiffness, whole.mass)
        speeds = np.sqrt(np.maximum(squares, 0.0))
        return _named(z, whole, bearings, list(zip(speeds, real.T, strict=True)))
    n = len(stiffness)
    inverse = np.linalg.inv(whole.mass)
    system = np.block(
        [[np.zeros((n, n)), np.eye(n)], [-inverse @ stiffness, -speed * inverse @ whole.gyroscopic]]
    )
    values, vectors = np.linalg.eig(system)
    order = [k for k in np.argsort(values.imag) if values[k].imag > 0]
    found = [(values[k].imag, vectors[:n, k]) for k in order]
    return _named(z, whole, bearings, found)


def critical_speeds(shaft: Shaft, rest: Rest, highest: float) -> list[Mode]:
    """Return the shaft speeds (rad/s) up to `highest` that coincide with the whirl frequency of one
    of the shaft's natural motions, for the bearing stiffness of `rest`. Axial motions have no
    critical speed.

    They follow from -w^2 M + i w^2 G + K = 0: the squares w^2 are the eigenvalues of K u = w^2 (M -
    i G) u.
    """
    import scipy.linalg

    z, whole = nodes(shaft, rest)
    bearings = springs(z, rest)
    stiffness = whole.stiffness + bearings
    squares, vectors = scipy.linalg.eig(stiffness, whole.mass - 1j * whole.gyroscopic)
    real = (np.abs(squares.imag) < 1e-6 * np.abs(squares)) & (squares.real > 0)
    real &= squares.real <= highest**2
    order = [k for k in np.argsort(squares.real) if real[k]]
    found = [(float(np.sqrt(squares[k].real)), vectors[:, k]) for k in order]
    return [one for one in _named(z, whole, bearings, found) if one.whirl]


def _named(
    z: Floats, whole: Matrices, bearings: Floats, found: Sequence[tuple[float, Floats]]
) -> list[Mode]:
    rigid = _rigid_motions(z, whole)
    least = FREE * np.median([speed for speed, _ in found]) if found else 0.0
    named = []
    for speed, shape in found:
        if speed < least:
            named.append(Mode(float(speed), "free", ""))
            continue
        name = _shape(shape, whole, bearings, rigid)
        named.append(Mode(float(speed), name, "" if name == "axial" else _whirl(shape)))
    return named


def _rigid_motions(z, whole):
    """Return {name: (k, 5 N)}, the motions of the shaft as a rigid body, scaled to unit inertia."""
    centre = beam_motion.rigid(z, whole).centre
    parts = np.zeros((5, len(z), FREEDOMS))
    for k in range(3):
        parts[k, :, k] = 1.0
    parts[3, :, 0], parts[3, :, 4] = z - centre, 1.0
    parts[4, :, 1], parts[4, :, 3] = centre - z, 1.0
    flat = parts.reshape(5, -1)
    flat = flat / np.sqrt(np.einsum("ki,ij,kj->k", flat, whole.mass, flat))[:, None]
    return {"axial": flat[2:3], "parallel": flat[:2], "conical": flat[3:]}


def _shape(shape, whole, bearings, rigid):
    along = np.where(np.arange(len(shape)) % FREEDOMS == 2, shape, 0.0)
    if _quadratic(along, whole.mass) > 0.5 * _quadratic(shape, whole.mass):
        return "axial"
    bent = _quadratic(shape, whole.stiffness)
    if bent > BENT * (bent + _quadratic(shape, bearings)):
        return "bending"
    share = {name: (np.abs(one @ whole.mass @ shape) ** 2).sum() for name, one in rigid.items()}
    return max(("parallel", "conical"), key=lambda name: share[name])


def _quadratic(shape, matrix):
    """Return twice the energy of a complex shape, u* A u."""
    return np.real(np.conj(shape) @ matrix @ shape)


def _whirl(shape):
    """Return the direction of whirl, i.e. the direction in which the nodes orbit relative to the
    spin about +z."""
    x, y = shape.reshape(-1, FREEDOMS)[:, :2].T
    turn = -2 * np.imag(np.conj(x) * y).sum() / (np.abs(x) ** 2 + np.abs(y) ** 2).sum()
    return "planar" if abs(turn) < ROUND else "forward" if turn > 0 else "backward"
