# SPDX-License-Identifier: GPL-2.0-or-later
"""A user's deck in which the axis is x, the outer ring turns and carries the load, and the inner
ring is fixed."""

import meshio
import numpy as np
import pytest
import raceway
from commands import reply
from host import deck_file, succeed
from raceway.export import paraview
from raceway.pictures.motion import moving_ring
from raceway.runs.record import CAGE_RING, Record
from raceway.runs.record_tables import ring_place
from raceway.theory.bearing import OUTER

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


def test_the_outer_raceway_moves_in_paraview(run, tmp_path):
    """Its points have turned with the ring, and their centre is that of the ring."""
    paraview.write(run.tables, tmp_path / "vtk", every=10)
    first, last = (meshio.read(tmp_path / f"vtk/outer_raceway_{k:05d}.vtu") for k in (0, 4))
    centres = [mesh.points.astype(float).mean(axis=0) for mesh in (first, last)]
    outer = np.transpose(ring_place(run.tables.record, OUTER, 0, 41)[:3])
    assert np.abs(outer[-1]).max() > 5e-6
    assert centres == pytest.approx(outer[[0, -1]], abs=2e-8)
    ways = [
        mesh.points[:, 0] + 1j * mesh.points[:, 1] - c[0] - 1j * c[1]
        for mesh, c in zip((first, last), centres)
    ]
    turned = np.angle(np.mean(ways[1] / ways[0]))
    assert turned == pytest.approx(157 * float(run.rings["time"][-1]), rel=1e-4)


def test_electric_table_states_the_relative_speed(run, capsys):
    said = reply(capsys, ["electric", run.tables.folder])
    assert "speed of inner relative to outer" in said and "m°" not in said


def test_a_whirl_with_the_cage_has_order_1(tmp_path, monkeypatch):
    """The centre of the cage, which is replaced in what is read, turns with the cage in the box.
    Relative to the outer ring, the cage turns in the opposite direction."""
    deck = DECK.replace("overwrite yes", "overwrite yes content summary")
    deck = deck.replace("pass/40", "pass/10").replace("passes 1", "passes 30")
    succeed(deck_file(tmp_path, deck), out=tmp_path / "run")
    read = Record.read

    def whirling(record, names, start=0, stop=None):
        found = read(record, names, start, stop)
        cage = record.fixed("ring_raceway") == CAGE_RING
        angle = read(record, ["ring_angle"], start, stop)["ring_angle"][:, cage]
        for name, place in (("ring_x", np.cos(angle)), ("ring_y", np.sin(angle))):
            if name in found:
                found[name] = np.where(cage, 1e-4 * place, found[name])
        return found

    monkeypatch.setattr(Record, "read", whirling)
    figures = raceway.open(tmp_path / "run").summary()
    assert figures["cage_whirl"] == "with the cage"
    assert figures["cage_whirl_order"] == pytest.approx(1, abs=0.02)
