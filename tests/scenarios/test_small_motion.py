# SPDX-License-Identifier: GPL-2.0-or-later
"""In docs/decks/in.small_motion, the stiffness and damping of a ring in small motion agree with
statics that include films. Friction is small, because statics neglects it."""

import numpy as np
import pytest
import raceway
from bearings import B6208
from host import succeed
from raceway import lubrication, ring_fit, ring_response, small_motion, static
from raceway.inputs import Oil

OIL = Oil(0.03969, 22.57e-9, 2.25, 1e-7)
SPIN, CLEARANCE = 100 * np.pi, 20e-6
# Hz, frequencies in the deck, in the order of the matrices
DRIVEN = {"x": 250.0, "y": 350.0, "z": 150.0, "rx": 450.0, "ry": 550.0}
PERIODS, PERIOD = 4, 0.02  # number of periods; s, common period of all frequencies
STUDENT = 5.84  # 99 % of means of four values are within this many standard errors
MASS = 4 / 3 * np.pi * (6.3e-3) ** 3 * 7800.0  # kg, mass of a ball


@pytest.fixture(scope="module")
def found(tmp_path_factory):
    folder = tmp_path_factory.mktemp("small_motion")
    words = {"friction": "stribeck 0.01 0.005", "steps": PERIODS * 2000}
    succeed("docs/decks/in.small_motion", out=folder, **words)
    run = raceway.open(folder)
    return ring_fit.of_run(run), float(run.bearing.cage_speed.mean()), run


@pytest.fixture(scope="module")
def want(found):
    """Return (stiffness, damping), each (5, 5), from statics; every column is evaluated at its own
    frequency."""
    state = static.equilibrium(
        B6208,
        axial_load=1000.0,
        clearance=CLEARANCE,
        orbital_speed=found[1],
        held=dict.fromkeys(("x", "y", "rx", "ry"), 0.0),
    )
    films = lubrication.lubricate(B6208, state, OIL, SPIN, CLEARANCE)
    columns = []
    for k, hertz in enumerate(DRIVEN.values()):
        rate = 2 * np.pi * hertz
        beside = ring_response.dampers(
            B6208, state, films, OIL, "full", clearance=CLEARANCE, frequency=rate
        )
        one = small_motion.response(
            state.linear, beside.damping, rate, stiffening=beside.stiffening, ball_mass=MASS
        )
        columns.append((one.stiffness[:, k], one.damping[:, k]))
    return np.array(columns).transpose(1, 2, 0)


def test_stiffness(found, want):
    """All entries that symmetry allows agree with statics. The other entries vanish, except for
    those due to the rotation of the balls."""
    stiffness, expected = found[0].stiffness, want[0]
    for row, column in ((0, 0), (1, 1), (2, 2), (0, 4), (1, 3), (3, 1), (4, 0)):
        assert stiffness[row, column] == pytest.approx(expected[row, column], rel=1e-3)
    for tilt in (3, 4):
        assert stiffness[tilt, tilt] == pytest.approx(expected[tilt, tilt], rel=5e-3)
    scale = np.sqrt(np.diag(expected))
    others = np.where(np.abs(expected) > 1.0, 0.0, stiffness) / np.outer(scale, scale)
    assert np.abs(others).max() < 1e-3
    assert np.all(found[0].left < 0.02)


def test_damping(found, want):
    damping, expected = found[0].damping, want[1]
    assert damping[2, 2] == pytest.approx(expected[2, 2], rel=0.01)
    for axis in (0, 1):
        assert damping[axis, axis] == pytest.approx(expected[axis, axis], rel=0.03)
    for row, column in ((0, 4), (1, 3), (3, 1), (4, 0)):
        assert damping[row, column] == pytest.approx(expected[row, column], rel=0.05)
    # friction adds a small contribution to the entries of the tilts
    for tilt in (3, 4):
        assert 1.0 < damping[tilt, tilt] / expected[tilt, tilt] < 1.2


def test_damping_turns_with_the_balls(found):
    """K_xy = C omega_c = -K_yx, within the scatter between the periods, each of which is fitted
    separately."""
    fit, orbit, run = found
    apart = []
    for k in range(PERIODS):
        one = ring_fit.of_run(run, since=k * PERIOD, until=(k + 1) * PERIOD)
        across = (one.stiffness[0, 1] - one.stiffness[1, 0]) / 2
        apart.append(across - (one.damping[0, 0] + one.damping[1, 1]) / 2 * orbit)
    error = np.std(apart, ddof=1) / np.sqrt(PERIODS)
    assert error < 0.015 * fit.damping[0, 0] * orbit
    assert abs(np.mean(apart)) < STUDENT * error
    assert abs(fit.damping[0, 1] - fit.damping[1, 0]) < 0.05 * fit.damping[0, 0]
