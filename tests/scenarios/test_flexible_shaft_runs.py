# SPDX-License-Identifier: GPL-2.0-or-later
"""fix bearing/shaft flexible: energy is balanced; accelerations are derivatives of velocities."""

import pytest
from flexible_shaft import ACROSS, HELD, LOADED, PRELOAD, modes_file
from shaft_runs import ENERGY, TILTING, WITHIN, rings_follow, swing


@pytest.fixture(scope="module")
def damped(tmp_path_factory):
    return modes_file(tmp_path_factory.mktemp("damped"), damping=0.02)


def test_energy(tmp_path, damped):
    """The work of the loads equals the dissipated heat plus the energy of motion, springs, supports
    and bending."""
    _, energy = swing(
        tmp_path,
        **ENERGY,
        freedoms=f"{TILTING} 200 z free",
        words=f"flexible {damped} {LOADED} {HELD}",
    )
    assert energy["work"] > 1e-3 and energy["dissipated"] > 0.0
    assert abs(energy["lost"]) < 1e-3 * energy["work"]


def test_within_a_step(tmp_path, damped):
    """In samples within long steps, the accelerations of the rings are the derivatives of their
    velocities."""
    swing(tmp_path, **WITHIN, words=f"flexible {damped} {LOADED} {ACROSS}", clearance=PRELOAD)
    rings_follow(tmp_path)
