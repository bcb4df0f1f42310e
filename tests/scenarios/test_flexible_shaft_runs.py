# SPDX-License-Identifier: GPL-2.0-or-later
"""fix bearing/shaft flexible: energy is balanced, accelerations are derivatives of velocities, and
results are bitwise identical in all hosts, on any number of ranks and after restarts."""

import pytest
from flexible_shaft import ACROSS, HELD, LOADED, PRELOAD, modes_file, reduced
from host import refuses, succeed
from shaft_runs import BITS, DECK, ENERGY, TILTING, WITHIN, data_of, rings_follow, rows_of, swing


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


@pytest.fixture(scope="module")
def whole(tmp_path_factory, damped):
    """Return (folder, variables) of a run on a single rank."""
    folder = tmp_path_factory.mktemp("whole")
    variables = {**BITS, "every": 10, "words": f"flexible {damped} {LOADED} {HELD}"}
    succeed(DECK, out=folder, **variables, steps=60)
    return folder, variables


def test_scene_is_worth_comparing(whole):
    data = {key: value[-1] for key, value in data_of(whole[0]).items()}
    rigid = data["y"] - (0.2 - reduced().body.centre) * data["rx"]
    assert abs(data["y2"] - rigid) > 1e-7 and data["f2y"] > 100 and abs(data["z"]) > 1e-7


@pytest.mark.parametrize("host, ranks", [("liggghts", 4), ("lammps", 2)])
def test_same_bits(whole, host, ranks, tmp_path):
    folder, variables = whole
    succeed(DECK, host=host, ranks=ranks, out=tmp_path, **variables, steps=60)
    assert rows_of(tmp_path)[-6:] == rows_of(folder)[-6:]


@pytest.fixture(scope="module")
def half(whole, tmp_path_factory):
    """Return the restart file that the run writes half-way."""
    folder = tmp_path_factory.mktemp("half")
    succeed(DECK, out=folder, **whole[1], steps=30, keep=30)
    return folder / "restart.30"


def test_restart(whole, half, tmp_path):
    folder, variables = whole
    extra = {**variables, "from": half}
    succeed(DECK, ranks=2, out=tmp_path, begin="resume", **extra, steps=30)
    assert rows_of(tmp_path)[-3:] == rows_of(folder)[-3:]


def test_restart_with_other_modes(whole, half, tmp_path):
    words = f"mass 4 inertia 2e-3 2e-2 {LOADED}"
    extra = {**whole[1], "from": half, "words": words}
    says = "the restart file has 8 modes of the shaft, but the deck has 0"
    refuses(DECK, says, out=tmp_path, begin="resume", **extra, steps=1)
