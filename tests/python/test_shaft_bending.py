# SPDX-License-Identifier: GPL-2.0-or-later
"""A shaft as a rigid body with elastic modes is compared with the beam with all its nodes, and its
file is tested."""

from pathlib import Path

import numpy as np
import pytest
from commands import reply
from raceway import beam, beam_motion, shaft, shaft_bending, shaft_file, shaft_motion
from raceway.cli import main
from raceway.theory.beam import Disc, Section

MOTOR = Path(__file__).parents[2] / "inputs/shafts/motor"
RINGS = (0.05, 0.35)  # m
SPRINGS = np.diag([2e8, 3e8, 1e7, 4e3, 3e3])  # N/m and N m/rad, stiffness of a bearing


@pytest.fixture(scope="module")
def rotor():
    """Return (z, matrices) of a shaft with an overhang and with a disc away from its middle."""
    z, pieces = beam.divided([Section(0.4, 0.03), Section(0.1, 0.02)], np.linspace(0, 0.5, 41))
    return z, beam_motion.matrices(z, pieces, [Disc(0.15, 4.0, 0.02, 0.011)])


def node(z, place):
    return int(np.argmin(np.abs(z - place)))


def reduced(rotor, modes, kept=RINGS):
    z, whole = rotor
    everywhere = range(len(z))
    return shaft_bending.bending(z, whole, [node(z, one) for one in kept], modes, everywhere)


def motions(found, place):
    """Return the matrix (4, 2 (2 + n)) that maps x, slope and modes in one plane, followed by those
    in the other plane, to x, y, rx and ry at a position."""
    k = node(found.z, place)
    plane = np.array(
        [
            [1.0, found.z[k] - found.body.centre, *found.shape[:, k, 0]],
            [0.0, 1.0, *found.shape[:, k, 1]],
        ]
    )
    none = np.zeros_like(plane[0])
    return np.array(
        [[*plane[0], *none], [*none, *plane[0]], [*none, *-plane[1]], [*plane[1], *none]]
    )


def system(found):
    """Return the matrices in the coordinates of `motions`, including the springs of the
    bearings."""
    body = found.body
    mass = np.diag(np.tile([body.mass, body.transverse, *found.mass], 2))
    stiffness = np.diag(np.tile([0.0, 0.0, *found.stiffness], 2))
    n = len(mass) // 2
    gyroscopic = np.zeros_like(mass)
    gyroscopic[1:n, n + 1 :], gyroscopic[n + 1 :, 1:n] = found.gyroscopic, -found.gyroscopic
    across = SPRINGS[np.ix_([0, 1, 3, 4], [0, 1, 3, 4])]
    springs = sum(motions(found, at).T @ across @ motions(found, at) for at in RINGS)
    return beam_motion.Matrices(mass, gyroscopic, stiffness), springs


def on_springs(z, count):
    whole = np.zeros((count, count))
    for place in RINGS:
        at = 5 * node(z, place) + np.arange(5)
        whole[np.ix_(at, at)] = SPRINGS
    return whole


@pytest.mark.parametrize("spin", [0.0, 1000.0])
def test_bending_pairs(rotor, spin):
    """The first pair of frequencies is within 1e-3 of that of the whole beam, and the second within
    5e-3, including the splitting due to spin."""
    z, whole = rotor
    exact = beam_motion.frequencies(whole, on_springs(z, 5 * len(z)), spin)
    found = beam_motion.frequencies(*system(reduced(rotor, 4)), spin)
    error = [np.abs(exact / one - 1).min() for one in found[:4]]
    assert max(error[:2]) < 1e-3 and max(error[2:]) < 5e-3
    if spin:
        assert found[1] / found[0] > 1.02 and found[3] / found[2] > 1.02  # splitting is significant


def test_more_modes_are_closer(rotor):
    z, whole = rotor
    exact = beam_motion.frequencies(whole, on_springs(z, 5 * len(z)))
    errors = [
        np.abs(exact / beam_motion.frequencies(*system(reduced(rotor, modes)))[2] - 1).min()
        for modes in (1, 4, 10)
    ]
    assert errors[0] > 10 * errors[1] > 30 * errors[2]


def test_modes_are_free_of_the_rigid_body(rotor):
    z, whole = rotor
    found = reduced(rotor, 4)
    body = beam_motion.rigid(z, whole)
    assert found.body == body and found.gyroscopic[0, 0] == pytest.approx(body.axial, rel=1e-9)
    planes = np.zeros((5 * len(z), 6 + 2))
    planes[0::5, :2] = np.column_stack([np.ones_like(z), z - body.centre])
    planes[4::5, 1] = 1.0
    planes[0::5, 2:], planes[4::5, 2:] = found.shape[..., 0].T, found.shape[..., 1].T
    mass, stiffness = planes.T @ whole.mass @ planes, planes.T @ whole.stiffness @ planes
    size = np.sqrt(np.diag(mass))
    assert np.abs(mass / np.outer(size, size) - np.eye(8)).max() < 1e-7
    assert np.diag(mass)[2:] == pytest.approx(found.mass)
    assert np.diag(stiffness)[2:] == pytest.approx(found.stiffness)
    assert np.abs(found.shape[..., 0]).max(1) == pytest.approx(1.0)


def test_steady_loads_at_kept_places(rotor):
    z, whole = rotor
    place, load = 0.5, np.array([300.0, -100.0])
    exact = np.zeros(5 * len(z))
    exact[[5 * node(z, place), 5 * node(z, place) + 1]] = load
    exact = np.linalg.solve(whole.stiffness + on_springs(z, len(exact)), exact).reshape(-1, 5)
    found = reduced(rotor, 2, (*RINGS, place))
    matrices, springs = system(found)
    force = motions(found, place)[:2].T @ load
    small = np.linalg.solve(matrices.stiffness + springs, force)
    for at in (*RINGS, place):
        want = exact[node(z, at), [0, 1, 3, 4]]
        assert motions(found, at) @ small == pytest.approx(want, rel=1e-8, abs=1e-13)


# ---- the file
def test_file(tmp_path, capsys):
    """The file contains all keywords, all numbers to the last digit, and the positions of its
    stations."""
    file = tmp_path / "motor.modes"
    words = ["--modes", "3", "--damping", "0.02", "--places", "0.27", "--kept", "0.1"]
    assert main(["shaft", str(MOTOR), "--reduced", str(file), *words]) == 0
    case = shaft_file.read(MOTOR)
    rest = shaft.rest(case.shaft, case.seats, case.loads, speed=case.rpm * np.pi / 30)
    want = shaft_motion.bending(
        case.shaft, rest, case.loads, modes=3, damping=0.02, kept=[0.1], places=[0.27]
    )
    title, *lines = file.read_text().splitlines()
    assert title == "raceway-shaft 1" and "units m kg s N rad" in lines
    rows = {}
    for line in lines:
        name, *numbers = line.split()
        if name not in ("#", "units"):
            rows.setdefault(name, []).append([float(one) for one in numbers])
    assert rows["mass"] == [[want.body.mass]] and rows["centre"] == [[want.body.centre]]
    assert rows["inertia"] == [[want.body.axial, want.body.transverse]]
    assert rows["modes"] == [[9]]  # for the bearings, a load, 0.1 m, and three modes
    assert np.array_equal(rows["modal_mass"][0], want.mass)
    assert np.array_equal(rows["modal_stiffness"][0], want.stiffness)
    ratio = want.damping / (2 * np.sqrt(want.mass * want.stiffness))
    assert np.array_equal(rows["modal_damping"][0], want.damping) and ratio == pytest.approx(0.02)
    assert np.array_equal(rows["gyroscopic"], want.gyroscopic)
    stations = np.array(rows["station"])
    assert np.array_equal(stations[:, 0], want.z)
    assert np.array_equal(stations[:, 1:].reshape(-1, 9, 2).swapaxes(0, 1), want.shape)
    for place in (0.03, 0.33, 0.39, 0.1, 0.27, want.body.centre):
        assert np.abs(want.z - place).min() < 1e-9
    with pytest.raises(ValueError, match="0.5 m is not on the shaft"):
        shaft_motion.bending(case.shaft, rest, case.loads, places=[0.5])
    with pytest.raises(ValueError, match="99 modes: the shaft has .* in addition to its kept"):
        shaft_motion.bending(case.shaft, rest, case.loads, modes=99)


def test_no_mode_is_left(rotor):
    with pytest.raises(ValueError, match="needs another kept position or a mode"):
        reduced(rotor, 0, kept=RINGS[:1])


@pytest.mark.parametrize(
    "words, says",
    [
        (["--modes", "-1"], "--modes is -1, must be from 0 to 50"),
        (["--modes", "51"], "--modes is 51, must be from 0 to 50"),
        (["--damping", "1"], "--damping is 1, must be at least 0 and below 1"),
    ],
)
def test_mistakes(tmp_path, capsys, words, says):
    file = tmp_path / "modes"
    assert (
        says in reply(capsys, ["shaft", MOTOR, "--reduced", file, *words], code=1)
        and not file.exists()
    )


@pytest.mark.parametrize("words", [["--modes", "4"], ["--places", "0.1"], ["--damping", "0"]])
def test_words_that_need_the_file(capsys, words):
    assert f"{words[0]} applies to --reduced FILE" in reply(
        capsys, ["shaft", MOTOR, *words], code=1
    )
