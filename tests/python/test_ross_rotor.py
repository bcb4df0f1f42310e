# SPDX-License-Identifier: GPL-2.0-or-later
"""A ROSS rotor is converted to the file of a flexible shaft.

ROSS 2.3.0 computed `ross_rotor.csv`, which contains nonzero entries of the upper triangles of M0,
K0 and G0: those of the first element and of the nodes in the middle and at the end. The rotor is a
steel shaft of eight elements, each 50 mm long and 40 mm in diameter, with
DiskElement.from_geometry(4, steel, 0.02, 0.04, 0.2). At both ends there are bearings with kxx = 2e8
and kyy = 3e8.
"""

import csv
import json
import sys
import types
from pathlib import Path

import numpy as np
import pytest
from commands import reply
from raceway import beam, beam_motion, ross_file, rotor_matrices, shaft_bending
from raceway.theory.beam import Section

FILE = Path(__file__).parent / "ross_rotor.csv"
Z = np.linspace(0.0, 0.4, 9)  # m
SPRINGS = (2e8, 3e8)  # N/m, springs at both ends
FREQUENCIES = {  # {spin in rad/s: frequencies in Hz from ROSS for two pairs of bending modes}
    0.0: (265.2845, 267.7216, 1059.7397, 1078.9096),
    1000.0: (265.2594, 267.7468, 961.1215, 1186.4734),
}
PARTS = (0, 12), (48, 6), (24, 6)  # first element, last node, node in the middle: place, size
SIX = np.delete(np.arange(54), np.arange(5, 54, 6))  # the degrees of freedom of ROSS except rz


def of_ross():
    """Return keyword arguments for `rotor_matrices.rotor`. All elements are alike; the node in the
    middle carries the disc."""
    found = {name: np.zeros((54, 54)) for name in "MKG"}
    with open(FILE) as file:
        for row in csv.DictReader(file):
            i, j, value = int(row["row"]), int(row["column"]), float(row["value"])
            found[row["matrix"]][i, j] = value
            found[row["matrix"]][j, i] = -value if row["matrix"] == "G" else value
    for whole in found.values():
        first, end, middle = (whole[k : k + n, k : k + n].copy() for k, n in PARTS)
        for at in range(0, 48, 6):
            whole[at : at + 6, at + 6 : at + 12] = first[:6, 6:]
            whole[at + 6 : at + 12, at : at + 6] = first[6:, :6]
            if at:
                whole[at : at + 6, at : at + 6] = middle if at == 24 else first[:6, :6] + end
    return dict(z=Z, mass=found["M"], stiffness=found["K"], gyroscopic=found["G"])


@pytest.fixture
def given():
    return of_ross()


@pytest.fixture(scope="module")
def found():
    return rotor_matrices.rotor(**of_ross())


def springs(count, ends, sizes=SPRINGS):
    whole = np.zeros((count, count))
    for first in ends:
        for k, size in enumerate(sizes):
            whole[first + k, first + k] = size
    return whole


@pytest.mark.parametrize("spin", FREQUENCIES)
def test_its_matrices_are_ours(found, spin):
    """The frequencies equal those computed by ROSS to all printed digits. This also verifies the
    sign of the gyroscopic terms."""
    held = springs(45, (0, 40), (*SPRINGS, 1e7))
    ours = beam_motion.frequencies(found.whole, held, spin) / (2 * np.pi)
    for want in FREQUENCIES[spin]:
        assert np.abs(ours - want).min() < 1e-4


@pytest.mark.parametrize("spin", FREQUENCIES)
def test_bending_pairs(found, spin):
    """The frequencies of the reduced rotor on its bearings agree within 1e-3 for the first pair and
    within 5e-3 for the second."""
    few = rotor_matrices.bending(found, (0.0, 0.4), modes=4)
    n, ends = len(few.mass) + 2, [int(np.argmin(np.abs(few.z - at))) for at in (0.0, 0.4)]
    mass = np.diag(np.tile([few.body.mass, few.body.transverse, *few.mass], 2))
    stiffness = np.diag(np.tile([0.0, 0.0, *few.stiffness], 2))
    gyroscopic = np.zeros_like(mass)
    gyroscopic[1:n, n + 1 :], gyroscopic[n + 1 :, 1:n] = few.gyroscopic, -few.gyroscopic
    for at in ends:
        row = np.array([1.0, few.z[at] - few.body.centre, *few.shape[:, at, 0]])
        for plane, size in enumerate(SPRINGS):
            half = slice(plane * n, (plane + 1) * n)
            stiffness[half, half] += size * np.outer(row, row)
    whole = beam_motion.Matrices(mass, gyroscopic, stiffness)
    ours = beam_motion.frequencies(whole, np.zeros_like(mass), spin)[:4] / (2 * np.pi)
    error = np.abs(ours / FREQUENCIES[spin] - 1)
    assert max(error[:2]) < 1e-3 and max(error[2:]) < 5e-3


def test_four_degrees_of_freedom(found, given):
    """Matrices of older ROSS versions, in x, y, rx and ry, result in the same lateral motion of the
    rotor."""
    four = np.sort(np.concatenate([6 * np.arange(9) + k for k in (0, 1, 3, 4)]))
    for name in ("mass", "stiffness", "gyroscopic"):
        given[name] = given[name][np.ix_(four, four)]
    one = rotor_matrices.bending(rotor_matrices.rotor(**given), (0.0, 0.4))
    other = rotor_matrices.bending(found, (0.0, 0.4))
    for a, b in zip(one, other):
        assert np.array_equal(a, b)


def test_a_station_between_nodes(given):
    """Displacement and tilt at the station equal those of a beam with a node at the station, i.e.
    of an element with bending and shear."""
    place, ends = 0.17, (0.0, 0.4)
    z, pieces = beam.divided([Section(0.4, 0.1)], Z)
    thick = beam_motion.matrices(z, pieces)
    for name, one in zip(("mass", "gyroscopic", "stiffness"), thick):
        given[name] = np.zeros((54, 54))
        given[name][np.ix_(SIX, SIX)] = one
    found = rotor_matrices.rotor(**given)
    few = rotor_matrices.bending(found, ends, modes=0, places=[place])
    everywhere = shaft_bending.bending(z, found.whole, [0, 8], 0, range(9)).shape
    finer, pieces = beam.divided([Section(0.4, 0.1)], [*Z, place])
    at = int(np.argmin(np.abs(finer - place)))
    for mode, shape in enumerate(everywhere):
        stiffness = beam.stiffness(pieces)
        line = np.array([5 * k + d for k in range(len(finer)) for d in (0, 4)])
        stiffness = stiffness[np.ix_(line, line)]
        own = [2 * at, 2 * at + 1]
        rest = np.setdiff1d(np.arange(len(line)), own)
        want = -np.linalg.solve(
            stiffness[np.ix_(own, own)], stiffness[np.ix_(own, rest)] @ shape.ravel()
        )
        there = int(np.argmin(np.abs(few.z - place)))
        assert few.shape[mode, there] == pytest.approx(want, rel=1e-9)


def test_its_own_damping(given):
    """Damping that is proportional to the stiffness damps every mode in the same proportion."""
    rotor = rotor_matrices.rotor(**given, damping=2e-6 * given["stiffness"])
    few = rotor_matrices.bending(rotor, (0.0, 0.4), damping=0.01)
    want = 2e-6 * few.stiffness + 0.02 * np.sqrt(few.mass * few.stiffness)
    assert few.damping == pytest.approx(want, rel=1e-9)


# ---- rejected
def put(name, *entries):
    """Change an entry (row, column, value) and its mirror image in the matrix."""

    def change(given):
        for i, j, value in entries:
            given[name] = given[name].copy()
            given[name][i, j] += value
            if i != j:
                given[name][j, i] += value

    return change


def one_way(given):
    given["stiffness"][0, 4] *= 1.001


def damped_mass(given):
    given["damping"] = 10.0 * given["mass"]


@pytest.mark.parametrize(
    "change, says",
    [
        (one_way, "K is not symmetric"),
        (put("stiffness", (0, 0, 2e8), (1, 1, 3e8)), "K restrains the rotor.*Leave bearings"),
        (put("stiffness", (0, 0, 1e3), (1, 1, 1e3)), "K restrains the rotor"),
        (put("mass", (24, 24, 1.0)), "M differs between the planes of x and y"),
        (put("mass", (24, 25, 0.1)), "M couples the planes of x and y"),
        (put("gyroscopic", (27, 28, 1e-3)), "G is not antisymmetric"),
        (damped_mass, "C restrains the rotor"),
        (lambda given: given.update(mass=-given["mass"]), "M is not positive definite"),
        (lambda given: given.update(z=Z[::-1]), "at least two node positions, finite and"),
        (lambda given: given.update(z=Z[:-1]), "M is 54 x 54, but 8 nodes need 32 x 32 or 48 x 48"),
        (put("mass", (0, 0, np.nan)), "M has a number that is not finite"),
    ],
)
def test_refused(given, change, says):
    change(given)
    with pytest.raises(ValueError, match=says):
        rotor_matrices.rotor(**given)


def test_damping_that_couples_modes(given):
    """A damper between nodes that does not affect rigid-body motions couples elastic modes."""
    second = np.zeros(54)
    second[[0, 24, 48]] = 1.0, -2.0, 1.0
    other = np.zeros(54)
    other[[1, 25, 49]] = 1.0, -2.0, 1.0
    damping = 100.0 * (np.outer(second, second) + np.outer(other, other))
    rotor = rotor_matrices.rotor(**given, damping=damping)
    with pytest.raises(ValueError, match="C couples elastic modes"):
        rotor_matrices.bending(rotor, (0.0, 0.4))


@pytest.mark.parametrize(
    "kept, places, says",
    [
        ((0.0, 0.17), (), "a kept position must be a node: none is at 0.17 m, the nearest is"),
        ((0.0, 0.4), (0.41,), "0.41 m is not on the rotor, which reaches from 0 to 0.4 m"),
        ((), (), "needs positions to keep"),
    ],
)
def test_places_refused(found, kept, places, says):
    with pytest.raises(ValueError, match=says):
        rotor_matrices.bending(found, kept, places=places)


# ---- files
@pytest.fixture(scope="module")
def npz(tmp_path_factory):
    """Write the file described on the page, and return its path."""
    path, ross = tmp_path_factory.mktemp("ross") / "rotor.npz", of_ross()
    np.savez(path, M=ross["mass"], K=ross["stiffness"], G=ross["gyroscopic"], z=ross["z"])
    return path


def test_npz(npz, found, tmp_path, capsys):
    file = tmp_path / "rotor.modes"
    words = ["--reduced", str(file), "--kept", "0", "0.4", "--places", "0.17", "--json"]
    printed = json.loads(reply(capsys, ["shaft", npz, *words]))
    want = rotor_matrices.bending(found, (0.0, 0.4), places=[0.17])
    rows = [line.split() for line in file.read_text().splitlines()]
    stations = [[float(one) for one in row[1:]] for row in rows if row[0] == "station"]
    assert [row[0] for row in stations] == [0.0, 0.17, 0.2, 0.4]  # the centre is a station
    assert np.array_equal(np.array(stations)[:, 1:], want.shape.swapaxes(0, 1).reshape(4, -1))
    (stiffness,) = (row[1:] for row in rows if row[0] == "modal_stiffness")
    assert np.array_equal([float(one) for one in stiffness], want.stiffness)
    volume = np.pi / 4 * (0.4 * 0.04**2 + 0.02 * (0.2**2 - 0.04**2))
    assert printed["rigid"]["mass_kg"] == pytest.approx(7810 * volume)
    assert printed["frequencies_Hz"][0] == pytest.approx(
        np.sqrt(want.stiffness / want.mass)[0] / (2 * np.pi), rel=2e-3
    )


def test_toml(monkeypatch, tmp_path, given, capsys):
    """A rotor saved by ROSS is read without its bearings; the nodes of the bearings are kept."""
    rotor = types.SimpleNamespace(
        M0=given["mass"],
        K0=given["stiffness"],
        C0=np.zeros((54, 54)),
        G0=given["gyroscopic"],
        nodes_pos=Z.tolist(),
        bearing_elements=[types.SimpleNamespace(n=8), types.SimpleNamespace(n=1)],
    )
    load = types.SimpleNamespace(load={str(tmp_path / "r.toml"): rotor}.__getitem__)
    monkeypatch.setitem(sys.modules, "ross", types.SimpleNamespace(Rotor=load))
    (tmp_path / "r.toml").touch()
    file = tmp_path / "r.modes"
    assert "9 nodes from 0 m to 400 mm, without its bearings at 50 mm, 400 mm" in (
        reply(capsys, ["shaft", tmp_path / "r.toml", "--reduced", file])
    )
    places = [line.split()[1] for line in file.read_text().splitlines() if line[:7] == "station"]
    assert [float(one) for one in places] == [0.05, 0.2, 0.4]
    assert "there is no such file" in reply(capsys, ["shaft", tmp_path / "none.toml"], code=1)


@pytest.mark.parametrize(
    "words, says",
    [
        (["--reduced", "FILE"], "has no bearings: give their positions with --kept Z ..."),
        (["--reduced", "FILE", "--kept", "0", "0.17"], "none is at 0.17 m"),
        (["--reduced", "FILE", "--kept", "0", "--modes", "40"], "40 modes: the shaft has 16"),
        (["--out", "FILE"], "--out draws a shaft at rest on its bearings"),
    ],
)
def test_mistakes(npz, tmp_path, capsys, words, says):
    file = tmp_path / "out"
    assert (
        says
        in reply(
            capsys, ["shaft", npz, *[str(file) if one == "FILE" else one for one in words]], code=1
        )
        and not file.exists()
    )


@pytest.mark.parametrize(
    "data, says",
    [
        (None, "cannot read"),
        (b"no file of numpy", "numpy.savez(FILE, M=r.M0"),
        (dict(M=np.eye(8), K=np.eye(8), z=Z[:2]), "has no G; numpy.savez"),
        (dict(M=np.eye(8), Kst=np.eye(8)), "unknown 'Kst'; known: M, K, G, z, C"),
        (dict(M=np.eye(8) * 1j, K=np.eye(8), G=np.eye(8), z=Z[:2]), "'M' has type complex128"),
    ],
)
def test_files_refused(tmp_path, capsys, data, says):
    path = tmp_path / "bad.npz"
    if isinstance(data, bytes):
        path.write_bytes(data)
    elif data:
        np.savez(path, **data)
    assert says in reply(capsys, ["shaft", path], code=1)


def test_without_ross(monkeypatch, tmp_path, capsys):
    monkeypatch.setitem(sys.modules, "ross", None)
    assert not ross_file.is_ross("inputs/shafts/motor")
    assert "cannot load ROSS" in reply(capsys, ["shaft", tmp_path / "r.toml"], code=1)
