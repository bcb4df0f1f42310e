# SPDX-License-Identifier: GPL-2.0-or-later
"""The hosts do not move atoms that are in the group of no integrator. A run warns of balls, cage
balls and grains that no fix moves or turns, and only fixes of this package move rings."""

import numpy as np
import pytest
from host import deck_file, named_bearing, refuses, succeed

HOSTS = ["liggghts", "lammps", "wheel"]
DECK = (
    named_bearing(clearance="-4.0e-6", types=5, neighbor="2.0e-3 bin", every=1)
    + """pair_coeff 5 5 grain stiffness 2.0e4 restitution 0.5 friction 0.5
create_bearing b speed 50 0
create_atoms 5 single 0.05 0.05 0 units box
set type 5 diameter 0.005 density 2500
group some id 1 2 3 10 11
group grains type 5
group bodies type 1 2
fix rails cage bearing/cage b
fix vessel grains bearing/grains drum none 0.2 -0.1 0.1 stiffness 2.0e4
{fixes}
timestep 2.0e-7
run 0
run 100
run 100
"""
)
GRAINS, BODIES = "fix turn grains nve/sphere", "fix move all bearing/verlet"
LACKING = {
    BODIES: "no fix moves grains (1 atoms, the first is 21): their group needs fix nve/sphere",
    f"{BODIES}\nfix turn grains nve": "no fix turns grains (1 atoms, the first is 21)",
    GRAINS: "no fix moves balls or cage balls (18 atoms, the first is 1): their group needs fix",
    f"{GRAINS}\nfix move some nve/sphere": "moves balls or cage balls (13 atoms, the first is 4)",
    f"{GRAINS}\nfix move bodies nve": "no fix turns balls (9 atoms, the first is 1)",
}


@pytest.mark.parametrize("host", HOSTS)
@pytest.mark.parametrize("fixes", LACKING)
def test_atoms_that_stay_are_noted(tmp_path, fixes, host):
    found = succeed(deck_file(tmp_path, DECK.format(fixes=fixes)), host=host, ranks=2).text
    assert found.count("WARNING: pair_style bearing") == found.count(LACKING[fixes]) == 1, found


@pytest.mark.parametrize("fixes", [f"{BODIES}\n{GRAINS}", f"fix i all freeze\n{BODIES}\n{GRAINS}"])
def test_atoms_that_move(tmp_path, fixes):
    found = succeed(deck_file(tmp_path, DECK.format(fixes=fixes))).text
    assert "no fix moves" not in found and "no fix turns" not in found


def test_a_state_that_is_only_looked_at(tmp_path):
    """`run 0` needs no integrator."""
    text = DECK.format(fixes="").replace("run 100\n", "")
    assert "no fix moves" not in succeed(deck_file(tmp_path, text)).text


@pytest.mark.parametrize("host", HOSTS)
@pytest.mark.parametrize("style", ["nve/sphere", "nve", "move linear 0 0.1 0"])
def test_a_ring_that_a_fix_of_the_host_moves(tmp_path, style, host):
    """A particle of the host has no axis, and its spin is not that of a ring."""
    deck = DECK.format(fixes=f"{BODIES}\n{GRAINS}\nfix more outer {style}")
    said = f"fix more {style.split()[0]} moves ring atom 20: only fix bearing/ring"
    refuses(deck_file(tmp_path, deck), said, host=host)


END = """
dump end all custom 1 {} id x y z vx vy vz
dump_modify end first yes sort id ${{dump_format}} "%d %.17g %.17g %.17g %.17g %.17g %.17g"
run 0
"""


@pytest.mark.parametrize("mover", ["verlet", "implicit"])
def test_a_ring_without_a_fix_stands_still(tmp_path, mover):
    """A velocity that a command gives to such a ring does not enter its contacts."""
    deck = DECK.format(fixes=f"group whole type 1 2 3 4\nfix move whole bearing/{mover}\n{GRAINS}")
    found = []
    for pushed in ("", "velocity outer set 1 2 3 units box\n"):
        out = tmp_path / f"end{len(found)}"
        succeed(deck_file(tmp_path, deck.replace("run 100", pushed + "run 1000") + END.format(out)))
        found.append(np.loadtxt(out, skiprows=9, max_rows=21))
    assert (found[0][19, 4:] == 0).all() and (found[1] == found[0]).all()
