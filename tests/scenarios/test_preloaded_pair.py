# SPDX-License-Identifier: GPL-2.0-or-later
"""In docs/decks/in.pair, two 7208s mounted back to back under preload agree with statics of a
single bearing."""

import numpy as np
import pytest
from host import succeed
from raceway import catalogue, inputs, static
from raceway.theory.bearing import DoubleRow

BEARING = inputs.bearing(catalogue.find("bearings", "7208"))
SPREAD = 5e-6  # m, displacement of each outer ring
ANGLE = np.radians(40)
FIRST_CONTACT = (0.02 + 0.03) * 11.9e-3 * np.sin(ANGLE)  # m, axial displacement
CAGE = 2 * np.pi * 10 * (1 - 5.95 / 30 * np.cos(ANGLE)) / 2  # rad/s, at 600 rpm


def pull(displacement):
    """Return the axial load (N) of a bearing whose inner ring is displaced by this distance (m)
    beyond the position of first contact."""
    held = dict.fromkeys(static.FREEDOMS, 0.0) | {"z": FIRST_CONTACT + displacement}
    found = static.equilibrium(BEARING, held=held, orbital_speed=CAGE, ball_density=7800.0)
    return -found.force[2]


@pytest.fixture(scope="module")
def line(tmp_path_factory):
    """Return (load in N, displacement in m, axial loads of both bearings in N) while the load is
    ramped up."""
    folder = tmp_path_factory.mktemp("pair")
    succeed("docs/decks/in.pair", out=folder)
    return np.loadtxt(folder / "line.dat").T


def test_preload(line):
    before = line[:, line[0] == 0.0][:, -1]
    assert before[1] == pytest.approx(0.0, abs=1e-10)
    assert -before[2] == pytest.approx(pull(SPREAD), rel=1e-3)
    assert before[3] == pytest.approx(pull(SPREAD), rel=1e-3)


def test_preload_line(line):
    """Each bearing carries the load that corresponds to its own displacement, and the difference
    between the two loads agrees with the applied load within 1 %."""
    load, place, first, second = line[:, (line[0] > 0.0) & (line[1] < 0.8 * SPREAD)]
    want = np.array([[pull(SPREAD + one), pull(SPREAD - one)] for one in place]).T
    assert len(load) > 40 and load[-1] > 1100
    assert -first == pytest.approx(want[0], rel=1e-3)
    assert second == pytest.approx(want[1], rel=0, abs=2e-3 * pull(SPREAD))
    assert load == pytest.approx(want[0] - want[1], rel=1e-2, abs=1.0)


def test_unloading(line):
    """One bearing is unloaded when the other accommodates the whole spread. This happens at 2.8
    times the preload, or slightly later because the contact angle increases."""
    load, place, _, second = line
    at_end = np.interp(SPREAD, place, load)
    assert at_end == pytest.approx(pull(2 * SPREAD), rel=1e-2)
    assert 2.8 < at_end / pull(SPREAD) < 2.9
    # only the centrifugal load remains
    assert np.interp(SPREAD, place, second) < 0.03 * pull(SPREAD)


def test_stiffness(line):
    """Under preload, the pair is twice as stiff as a single bearing until one of the two bearings
    is unloaded."""
    load, place = line[0], line[1]
    start = (load > 0) & (load < 200)
    found = np.polyfit(place[start], load[start], 1)[0]
    one = (pull(SPREAD + 1e-7) - pull(SPREAD - 1e-7)) / 2e-7
    assert found == pytest.approx(2 * one, rel=1e-2)


def test_as_one_double_row_bearing(line):
    """The displacement under a load equals that of a single bearing with two rows."""
    load, place, *_ = line[:, (line[0] > 0.0) & (line[1] < 0.8 * SPREAD)]
    two = BEARING.double_row(DoubleRow(0.018, SPREAD), ANGLE)
    for k in (len(load) // 3, -1):
        rest = static.equilibrium(two, axial_load=load[k], orbital_speed=CAGE)
        assert place[k] == pytest.approx(rest.shift[2], rel=1e-2)


def test_face_to_face(line, tmp_path):
    """In a face-to-face pair, the bearings exchange roles, but the displacement of the pair as a
    function of load is the same."""
    face = {"first": "minus", "second": "plus", "spread": -SPREAD}
    succeed("docs/decks/in.pair", out=tmp_path, **face)
    load, place, first, second = np.loadtxt(tmp_path / "line.dat").T
    assert load == pytest.approx(line[0])
    assert place == pytest.approx(line[1], rel=1e-6, abs=1e-12)
    assert first == pytest.approx(line[3], rel=1e-6, abs=1e-6)
    assert second == pytest.approx(line[2], rel=1e-6, abs=1e-6)
