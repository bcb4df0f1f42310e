# SPDX-License-Identifier: GPL-2.0-or-later
"""A user's deck in which the axis is x, the outer ring turns and carries the load, and the inner
ring is fixed."""

import numpy as np
import pytest
import raceway
from commands import reply
from host import deck_file, succeed
from raceway.pictures.motion import moving_ring

DECK = """
bearing b 6205 types 1 2 3 4 clearance 10e-6 cage ring
units si
atom_style sphere
atom_modify map array sort 0 0.0
newton off
boundary f f f
region box block -0.05 0.05 -0.05 0.05 -0.05 0.05 units box
create_box 4 box
neighbor ${b_skin} nsq
neigh_modify delay 0 every 1 check yes
pair_style bearing axis x oil vg46 temperature 60 models full
pair_coeff * * b
create_bearing b speed 0 157
fix cage cage bearing/cage/ring b
fix outer outer bearing/ring mass 0.1 y free z free spin speed 157 force 0 -1000 0 ramp 3.0e-3
fix move all bearing/implicit
fix cap balls bearing/capacitance
fix record all bearing/record pass/40 ${out} overwrite yes
run_bearing settle 1 passes 1
"""


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    folder = tmp_path_factory.mktemp("outer")
    succeed(deck_file(folder, DECK), out=folder / "run")
    return raceway.open(folder / "run")


def test_summary_and_cage(run):
    """x of the bearing is y of the box, along which the load acts."""
    assert run.summary()["force_x_N"] == pytest.approx(-1000, rel=0.05)
    ring, cage = run.rings, run.cage
    assert not ring.x.values.any() and cage.x.values.any()
    assert np.median(cage.spin) == pytest.approx(np.median(run.bearing.cage_speed), rel=0.01)


def test_the_ring_that_moves_is_drawn(run, capsys, tmp_path):
    name, ring = moving_ring(run.tables)
    assert name == "outer"
    shift = -ring["x"][ring["sample"] > 0].mean()  # a summary omits the start
    assert shift == pytest.approx(run.summary()["ring_shift_m"], rel=1e-6)
    reply(capsys, ["plot", run.tables.folder, "--kind", "motion", "--out", tmp_path / "a.png"])


def test_electric_table_states_the_relative_speed(run, capsys):
    said = reply(capsys, ["electric", run.tables.folder])
    assert "speed of inner relative to outer" in said and "m°" not in said
