# SPDX-License-Identifier: GPL-2.0-or-later
"""A rotor with matrices from a rotor dynamics program, and the bending modes of this rotor.

The degrees of freedom of a node are x, y, z, rx, ry, rz (ROSS since 2.0) or x, y, rx, ry (ROSS
before 2.0); axes are right-handed, with z along the shaft. The matrices satisfy M q'' + (C + spin
G) q' + K q = f in kg, m, s, N and rad, with the spin in rad/s. The rotor must be unsupported,
because the simulation adds the bearings.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from raceway.arrays import Floats
from raceway.theory import beam_motion, shaft_bending
from raceway.theory.beam import FREEDOMS

# {degrees of freedom per node: their indices in this package, and those in the file}
OURS = {4: (0, 1, 3, 4), 6: (0, 1, 2, 3, 4)}
THEIRS = {4: (0, 1, 2, 3), 6: (0, 1, 2, 3, 4)}
SMALL = 1e-9  # tolerance for rounding errors, as a fraction of the largest number
NEAR = 1e-6  # m, tolerance of a node's position
PROPER = 1e-6  # largest coupling of modes by damping, as a fraction of the diagonal


class Rotor(NamedTuple):
    """An unsupported rotor with N nodes."""

    z: Floats  # (N,), m, increasing
    whole: beam_motion.Matrices  # (5 N, 5 N)
    damping: Floats  # (5 N, 5 N)


def rotor(
    z: ArrayLike,
    mass: ArrayLike,
    stiffness: ArrayLike,
    gyroscopic: ArrayLike,
    damping: ArrayLike | None = None,
) -> Rotor:
    """Create a `Rotor` without bearings from nodes at `z` (N,) in m and from matrices (n, n), where
    n is 4 N or 6 N.

    Raises `ValueError` for properties that `fix bearing/shaft` does not support: matrices that are
    not symmetric (G: not antisymmetric), matrices that differ between the two planes, and stiffness
    or damping that restrains the rotor.

    >>> from raceway.theory.beam import Section, divided
    >>> z, pieces = divided([Section(0.4, 0.04)], [0.1, 0.2, 0.3])
    >>> whole = beam_motion.matrices(z, pieces)
    >>> six = np.delete(np.arange(30), np.arange(5, 30, 6))
    >>> M, G, K = (np.zeros((30, 30)) for _ in whole)
    >>> for to, one in zip((M, G, K), whole):
    ...     to[np.ix_(six, six)] = one
    >>> np.array_equal(rotor(z, M, K, G).whole.stiffness, whole.stiffness)
    True
    """
    z = np.asarray(z, float)
    if z.ndim != 1 or len(z) < 2 or not np.all(np.isfinite(z)) or not np.all(np.diff(z) > 0):
        raise ValueError("there must be at least two node positions, finite and increasing")
    given = dict(M=mass, K=stiffness, G=gyroscopic)
    if damping is not None:
        given["C"] = damping
    ours = {name: _ours(name, np.asarray(one, float), len(z)) for name, one in given.items()}
    ours.setdefault("C", np.zeros_like(ours["K"]))
    found = Rotor(z, beam_motion.Matrices(ours["M"], ours["G"], ours["K"]), ours["C"])
    _check(found)
    return found


def bending(
    of: Rotor,
    kept: Sequence[float],
    *,
    modes: int = 4,
    damping: float = 0.0,
    places: Sequence[float] = (),
) -> shaft_bending.Bending:
    """Return the bending of the rotor `of` in the same form as `shaft_bending.bending`, with the
    rotor's own damping in addition to the `damping` ratio of every mode.

    The response of the nodes at `kept` (m) to steady loads is exact. Stations are these nodes, the
    centre of mass and `places` (m), which may be anywhere on the rotor. Between two nodes,
    displacements follow from a Timoshenko beam without loads, which is exact for an element with
    constant cross-section. Raises `ValueError` for a kept position without a node, a position off
    the rotor, too many modes, or damping that couples the modes.
    """
    nodes = sorted({node(of, place) for place in kept})
    if not nodes:
        raise ValueError("needs positions to keep, such as those of the bearings")
    everywhere = range(len(of.z))
    found = shaft_bending.bending(of.z, of.whole, nodes, modes, everywhere, damping)
    stations = [*of.z[nodes], found.body.centre, *places]
    if off := [one for one in stations if not of.z[0] - NEAR <= one <= of.z[-1] + NEAR]:
        raise ValueError(
            f"{off[0]:g} m is not on the rotor, which reaches from {of.z[0]:g} to {of.z[-1]:g} m"
        )
    at = np.unique(np.round(stations, 9))
    return found._replace(
        z=at,
        shape=np.stack([_shape(of, found.shape, one) for one in at], axis=1),
        damping=found.damping + _modal_damping(of, found),
    )


def node(of: Rotor, place: float) -> int:
    """Return the index of the node at `place` (m). Raises `ValueError` if there is none."""
    nearest = int(np.argmin(np.abs(of.z - place)))
    if not abs(of.z[nearest] - place) <= NEAR:
        raise ValueError(
            f"a kept position must be a node: none is at {place:g} m, the nearest is at"
            f" {of.z[nearest]:g} m"
        )
    return nearest


def _ours(name, matrix, nodes):
    """Convert a matrix to this package's degrees of freedom, (5 N, 5 N)."""
    sizes = [freedoms * nodes for freedoms in OURS]
    if matrix.shape not in [(size, size) for size in sizes]:
        raise ValueError(
            f"{name} is {' x '.join(map(str, matrix.shape))}, but {nodes} nodes need"
            f" {sizes[0]} x {sizes[0]} or {sizes[1]} x {sizes[1]}"
        )
    if not np.all(np.isfinite(matrix)):
        raise ValueError(f"{name} has a number that is not finite")
    freedoms = len(matrix) // nodes
    to, of = (
        np.add.outer(count * np.arange(nodes), places[freedoms]).ravel()
        for count, places in ((FREEDOMS, OURS), (freedoms, THEIRS))
    )
    whole = np.zeros((FREEDOMS * nodes, FREEDOMS * nodes))
    whole[np.ix_(to, to)] = matrix[np.ix_(of, of)]
    return whole


def _check(of):
    # tilts are multiplied by the element length, so that one tolerance applies to all entries
    length = np.diff(of.z).mean()
    unit = np.tile([1.0, 1.0, 1.0, 1 / length, 1 / length], len(of.z))
    one, other = shaft_bending.planes(len(of.z))
    rigid = np.zeros((2 * len(of.z), 2))
    rigid[0::2, 0], rigid[0::2, 1], rigid[1::2, 1] = 1.0, (of.z - of.z[0]) / length, 1.0
    named = dict(M=of.whole.mass, K=of.whole.stiffness, C=of.damping, G=of.whole.gyroscopic)
    for name, matrix in named.items():
        matrix = matrix * np.outer(unit, unit)
        small = SMALL * np.abs(matrix).max()
        for why, rest in _faults(name, matrix, one, other, rigid):
            if np.abs(rest).max() > small:
                raise ValueError(f"{name} {why}")
    if not np.all(np.linalg.eigvalsh(one.T @ of.whole.mass @ one) > 0):
        raise ValueError("M is not positive definite transverse to the shaft")


def _faults(name, matrix, one, other, rigid):
    """Yield (error text, entries that must be 0) for each condition on a matrix. `one` and `other`
    select its planes, and `rigid` contains the motions of a rigid body in one plane."""
    own, both = one.T @ matrix @ one, one.T @ matrix @ other
    if name == "G":
        yield "is not antisymmetric", matrix + matrix.T
        yield "differs between the planes of x and y", both - both.T
        return
    yield "is not symmetric", matrix - matrix.T
    if name != "M":  # checked before the planes are compared, because bearings often differ there
        yield (
            "restrains the rotor, which must be free to move as a rigid body. Leave bearings, seals"
            " and axial forces out; in ROSS, M0, K0, C0 and G0 do not include bearings",
            own @ rigid / np.abs(rigid).max(),
        )
    yield "differs between the planes of x and y", own - other.T @ matrix @ other
    yield "couples the planes of x and y", both


def _element(of, k):
    """Return the stiffness (4, 4) in the plane of x of the element between nodes k and k + 1."""
    at = np.array([FREEDOMS * k, FREEDOMS * k + 4])
    return of.whole.stiffness[np.ix_(at, at + FREEDOMS)]


def _shape(of, shape, place):
    """Return the displacement and tilt (n, 2) at `place` (m) for the modes whose `shape` (n, N, 2)
    is given at the nodes, interpolated with the static shapes of Timoshenko's element
    (Przemieniecki 1968, ch. 5)."""
    k = int(np.clip(np.searchsorted(of.z, place) - 1, 0, len(of.z) - 2))
    length = of.z[k + 1] - of.z[k]
    u = min(max((place - of.z[k]) / length, 0.0), 1.0)
    if u in (0.0, 1.0):
        return shape[:, k + int(u)]
    block = _element(of, k)
    if not block[0, 0] < 0:
        raise ValueError(f"no shaft joins the nodes at {of.z[k]:g} and {of.z[k + 1]:g} m")
    # ratio of shear to bending displacement
    soft = 2 + 12 * block[1, 1] / (block[0, 0] * length**2)
    moved = np.array(
        [
            1 - 3 * u**2 + 2 * u**3 + soft * (1 - u),
            length * (u - 2 * u**2 + u**3 + soft / 2 * (u - u**2)),
            3 * u**2 - 2 * u**3 + soft * u,
            length * (u**3 - u**2 + soft / 2 * (u**2 - u)),
        ]
    )
    tilted = np.array(
        [
            6 * (u**2 - u) / length,
            1 - 4 * u + 3 * u**2 + soft * (1 - u),
            6 * (u - u**2) / length,
            3 * u**2 - 2 * u + soft * u,
        ]
    )
    ends = shape[:, k : k + 2].reshape(len(shape), 4)
    return ends @ np.column_stack([moved, tilted]) / (1 + soft)


def _modal_damping(of, found):
    """Return the modal damping (n,) in N s/m due to the rotor's own damping; all nodes must be
    stations of `found`."""
    shapes = found.shape.reshape(len(found.mass), -1).T
    plane = shaft_bending.planes(len(of.z))[0]
    whole = shapes.T @ plane.T @ of.damping @ plane @ shapes
    own = np.maximum(np.diag(whole), 0.0)
    size = np.sqrt(np.outer(own, own))
    apart = np.abs(whole - np.diag(np.diag(whole)))
    if np.any(apart > PROPER * size + SMALL * np.sqrt(found.mass * found.stiffness).min()):
        raise ValueError(
            "C couples elastic modes, but the file has one damping value for each. A C proportional"
            " to K does not couple them. Otherwise leave C out and give a damping ratio"
        )
    return own
