# SPDX-License-Identifier: GPL-2.0-or-later
"""The hosts do not move atoms that are in the group of no integrator. A run warns of balls, cage
balls and grains that no fix moves or turns, and only fixes of this package move rings."""

import re

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


def test_grains_without_contacts_are_noted(tmp_path):
    text = re.sub("fix vessel .*", "", DECK.format(fixes=f"{BODIES}\n{GRAINS}"))
    found = succeed(deck_file(tmp_path, text)).text
    assert found.count("no fix computes the contacts of grains (1 atoms, the first is 21)") == 1


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


SPACE = {"neighbor": "2.0e-3 bin", "every": 1, "sides": "-0.06 0.06 -0.06 0.06 -0.06 0.2"}
PAIR = (
    named_bearing(clearance="-4.0e-6", **SPACE)
    + """create_bearing b speed 50 0
create_bearing b speed 50 0 centre 0 0 0.1
region low block INF INF INF INF INF 0.05 units box
group low region low
group high subtract all low
fix rails cage bearing/cage b
group first id 19
group second id 39
fix first first bearing/ring mass 0.2 x free y free spin speed 50 force 0 -2000 0
fix second second bearing/ring mass 0.2 x free y free spin speed 50 force 0 -2000 0
{fixes}
timestep 1.0e-6
run 300
"""
)


def ends(tmp_path, name, fixes, host="liggghts"):
    """Return the final state of both bearings."""
    out = tmp_path / name
    deck = PAIR.format(fixes=fixes) + END.format(out)
    text = succeed(deck_file(tmp_path, deck), host=host).text
    assert "integrated more than once" not in text
    return np.loadtxt(out, skiprows=9)


@pytest.mark.parametrize("host", HOSTS)
def test_a_fix_moves_the_balls_of_its_group_only(tmp_path, host):
    """`fix bearing/verlet` per bearing, or on one of them only; also after another fix of this
    ID."""
    low, high = (f"fix {name} {name} bearing/{{}}" for name in ("low", "high"))
    verlet = ends(tmp_path, "all", "fix move all bearing/verlet", host)
    implicit = ends(tmp_path, "implicit", "fix move all bearing/implicit", host)
    each = "\n".join((low, high)).format("verlet", "verlet")
    assert (ends(tmp_path, "each", each, host) == verlet).all()
    again = f"fix low all bearing/verlet\nunfix low\n{each}"
    assert (ends(tmp_path, "again", again, host) == verlet).all()
    mixed = "\n".join((low, high)).format("implicit", "verlet")
    found = ends(tmp_path, "mixed", mixed, host)
    assert (found[:20] == implicit[:20]).all() and (found[20:, 4:] != implicit[20:, 4:]).any()
