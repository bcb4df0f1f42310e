# SPDX-License-Identifier: GPL-2.0-or-later
"""A load along a degree of freedom that is not free has no effect on the motion. A warning says so,
once, whether the load is a number or a variable."""

import pytest
from host import deck_file, named_bearing, succeed

DECK = (
    named_bearing(neighbor="2.0e-3 bin")
    + """create_bearing b speed 50 0
fix rails cage bearing/cage b
variable late equal 500*(time>1.5e-5)
variable zero equal 1.0e-9*cos(time)
variable own atom 300
variable axial equal 1000
fix move all bearing/{mover}
fix inner inner bearing/{ring} spin speed 50 {load}
timestep 1.0e-6
run 10
run 20
"""
)
HELD, SHAFT = "ring mass 0.2 x free", "shaft mass 2 inertia 1.0e-3 2.0e-3 x free y free z free"
IDLE = {
    (HELD, "force 9 -70 0"): "force of -70 N along y has no effect, because y is not free",
    (HELD, "force 9 0 v_late"): "force of 500 N along z has no effect, because z is not free",
    (HELD, "force 9 v_own 0"): "force of 300 N along y has no effect, because y is not free",
    (HELD, "moment 5 0 0"): "moment of 5 N m about x has no effect, because rx is not free",
    (HELD, "moment 0 v_late 0"): "moment of 500 N m about y has no effect, because ry is not free",
    (HELD, "moment 0 0 5"): "moment of 5 N m about z has no effect, because spin is not free",
    ("ring", "rotating 100 50 0"): "rotating force of 100 N has no effect, because neither x nor y",
    ("ring", "unbalance 0.01 0"): "unbalance of 0.01 kg m has no effect, because neither x nor y",
    (SHAFT, "moment v_late 0 0"): "moment of 500 N m about x has no effect, because rx is not free",
    ("shaft mass 2 x free y free", "load 0 5 0 v_axial"): "load of 1000 N along z has no effect",
}
FELT = [
    (HELD, "force 9 v_zero 0 moment v_zero 0 0"),
    (HELD, "rotating 100 50 0"),
    (HELD, "unbalance 1.0e-3 0"),
    ("ring", "unbalance 0 0"),
    (SHAFT, "load 0.01 5 5 v_late"),
    (HELD + " inertia 1.0e-4 1.0e-4 rx free", "moment v_late 0 0"),
]


@pytest.mark.parametrize("mover", ["implicit", "verlet"])
@pytest.mark.parametrize("ring, load", IDLE)
def test_a_load_that_moves_nothing(tmp_path, ring, load, mover):
    deck = deck_file(tmp_path, DECK.format(ring=ring, load=load, mover=mover))
    found = succeed(deck, ranks=2).text
    said = IDLE[ring, load]
    assert found.count("has no effect") == found.count(said) == 1, found


@pytest.mark.parametrize("ring, load", FELT)
def test_a_load_that_moves_the_ring(tmp_path, ring, load):
    deck = deck_file(tmp_path, DECK.format(ring=ring, load=load, mover="implicit"))
    assert "has no effect" not in succeed(deck).text
