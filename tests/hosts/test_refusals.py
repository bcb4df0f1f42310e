# SPDX-License-Identifier: GPL-2.0-or-later
"""Fixes that may change the motion, the box or the timestep are rejected with an error that names
the fix; all other fixes are allowed."""

import pytest
from host import BOX, deck_file, named_bearing, refuses, run, succeed

BEARING = (
    BOX
    + """pair_style bearing/hertz
pair_coeff 1 3 inner 24.0e-3 6.552e-3
pair_coeff 1 4 outer 36.6e-3 6.552e-3
create_bearing 1 none 3 4 balls 9 diameter 12.6e-3
group inner type 3
group bearing type 1 3 4
fix move bearing bearing/implicit
timestep 1.0e-5
"""
)
CAGED = (
    BEARING.split("create_bearing")[0]
    + """pair_coeff 1 2 sphere 210e9 0.3 3.3e9 0.41
create_bearing 1 2 3 4 balls 9 diameter 12.6e-3 cage 8.38e-3 speed 20.0 0
group cage type 2
group free type 1 2
group rings type 3 4
fix rails cage bearing/cage 4 gap {gap}
fix rings rings bearing/ring mass 0.2 spin speed 20.0
fix weight all gravity {weight} vector 0 -1 0
timestep 1e-5
"""
)
EVERYWHERE, LAMMPS, WHEEL = ("liggghts", "lammps", "wheel"), ("lammps", "wheel"), ("wheel",)
MAY = "which may change their motion"
# {words of a fix on the atoms of fix bearing/implicit: (error message, hosts that have this fix)}
FIXES = {
    "nve/sphere": ("which moves them too", EVERYWHERE),
    "addforce 1 0 0": ("which adds forces", EVERYWHERE),
    "momentum 1 linear 1 1 1": (MAY, EVERYWHERE),
    "temp/rescale 1 300 300 0.1 1": (MAY, LAMMPS),
    "temp/berendsen 300 300 0.1": (MAY, LAMMPS),
    "temp/csvr 300 300 0.1 1": (MAY, WHEEL),
    "temp/csld 300 300 0.1 1": (MAY, WHEEL),
    "heat 1 0.1": (MAY, LAMMPS),
    "oneway 1 box -x": (MAY, WHEEL),
    "recenter INIT INIT INIT": ("may not change the positions of its atoms", LAMMPS),
    "deform 1 x final -0.06 0.061 units box": ("may not change the box", EVERYWHERE),
    "dt/reset 1 1e-7 1e-5 0.1": ("may not change the timestep", EVERYWHERE),
    "ave/time 1 1 10 c_thermo_temp": (None, EVERYWHERE),
    "ave/atom 1 1 10 vx": (None, EVERYWHERE),
    "store/state 1 x": (None, EVERYWHERE),
    "store/force": (None, EVERYWHERE),
    "print 10 step": (None, EVERYWHERE),
    "halt 10 tlimit > 1000": (None, LAMMPS),
    "vector 10 c_thermo_temp": (None, LAMMPS),
    "balance 10 1.0 shift x 5 1.1": (None, LAMMPS),
}


@pytest.mark.parametrize(
    "host, words", [(host, words) for words, (_, hosts) in FIXES.items() for host in hosts]
)
def test_fixes_beside_the_implicit_step(tmp_path, host, words):
    """A fix that is added between two runs is rejected too."""
    message, _ = FIXES[words]
    deck = deck_file(tmp_path, BEARING + f"run 2\nfix beside bearing {words}\nrun 10\n")
    if message:
        refuses(deck, message, "fix beside", host=host)
    else:
        succeed(deck, host=host)


@pytest.mark.parametrize("clearance, ends", [(4.5e-4, False), (8e-4, False), (1e-3, True)])
def test_free_play_beyond_the_far_side_of_the_grooves(tmp_path, clearance, ends):
    """A ball on the side opposite the load would have to overlap by 2 (r_c - R_b) = 5.04e-4 m."""
    end = run("inputs/in.6208", out=tmp_path / "run", clearance=clearance, passes=1, samples=20)
    assert (end.code != 0) == ("on the far side of the groove" in end.error) == ends, end.text


@pytest.mark.parametrize("gap, weight, ends", [(0, 0, False), (0, 9.81, True), (1e-3, 0, False)])
@pytest.mark.parametrize("mover", ["bearing/implicit", "nve/sphere"])
def test_cage_that_falls_inwards(tmp_path, mover, gap, weight, ends):
    """At 20 rad/s, the rails cannot carry the weight of the cage, because the gap between them acts
    as play."""
    step, turn = (1e-5, 2500) if mover == "bearing/implicit" else (1e-6, 25000)
    atoms = "all" if mover == "bearing/implicit" else "free"
    deck = CAGED.format(gap=gap, weight=weight) + f"fix move {atoms} {mover}\n"
    deck += f"timestep {step}\nrun {turn}\n"
    end = run(deck_file(tmp_path, deck))
    assert (end.code != 0) == ("it has left its pocket" in end.error) == ends, end.text


@pytest.mark.parametrize("host", EVERYWHERE)
def test_balls_that_no_fix_moves(tmp_path, host):
    deck = BEARING.replace(
        "fix move bearing bearing/implicit", "fix i inner bearing/ring spin speed 9"
    )
    deck = deck_file(tmp_path, deck + "run_bearing settle 1 passes 1\n")
    refuses(deck, "run_bearing: no fix moves ball 1: its group needs", host=host)


@pytest.mark.parametrize("host", EVERYWHERE)
def test_types_that_no_pair_coeff_names(tmp_path, host):
    """There is a single warning for all atoms, even if a second run follows. It is an error
    under `fix bearing/implicit`."""
    grains = "".join(
        f"create_atoms {t} single 0 0 0.0{t} units box\nset type {t} diameter 1e-3 density 1000\n"
        for t in (2, 5)
    )
    deck = BEARING.replace("create_box 4", "create_box 5").replace(
        "group inner", grains + "group inner"
    )
    said = "no pair_coeff names type 2 5: its atoms pass through everything"
    end = succeed(deck_file(tmp_path, deck + "run 1\nrun 1\n"), host=host)
    assert end.text.count(said) == 1, end.text
    more = deck_file(tmp_path, deck.replace("type 1 3 4", "type 1 2 3 4") + "run 1\n")
    refuses(more, "is not a ball, cage ball or ring of a bearing", host=host)


SHORT = {"passes": 1, "samples": 20, "rpm": 20000}


@pytest.mark.parametrize("deck", ["in.6208", "in.many"])
@pytest.mark.parametrize(
    "name, value", [("lubricant", ""), ("step", " "), ("tolerance", "5 kN"), ("phase", "1 rad")]
)
def test_values_of_variables(tmp_path, deck, name, value):
    """An empty value and a number with a unit are rejected."""
    refuses(f"inputs/{deck}", f"-var {name} is ", out=tmp_path / "run", **{name: value})


def test_resume(tmp_path):
    """A run can be resumed neither with fewer passes than it has already made, nor in another
    host."""
    succeed("inputs/in.6208", out=tmp_path, **SHORT | {"passes": 2})
    for host, message in {
        "liggghts": "beyond these passes",
        "lammps": "LIGGGHTS and LAMMPS cannot continue each other's runs",
    }.items():
        refuses("inputs/in.6208", message, host=host, out=tmp_path, resume="yes", **SHORT)


def test_cage_whose_rails_are_taken_away(tmp_path):
    fixes = "fix move all bearing/implicit\nrun 1\nunfix rails\nrun 1\nrun 1\n"
    end = succeed(deck_file(tmp_path, CAGED.format(gap=0, weight=0) + fixes))
    said = "9 cage balls are not in the group of any fix bearing/cage: no rails hold them"
    assert end.text.count(said) == 1, end.text


def test_create_bearing_below_hybrid(tmp_path):
    deck = BEARING.replace("pair_style bearing/hertz", "pair_style hybrid bearing/hertz")
    for pair in ("1 3", "1 4"):
        deck = deck.replace(f"pair_coeff {pair}", f"pair_coeff {pair} bearing/hertz")
    refuses(deck_file(tmp_path, deck + "run 1\n"), "before it, not below hybrid")


@pytest.mark.parametrize("host", EVERYWHERE)
def test_minimize(tmp_path, host):
    deck = deck_file(tmp_path, BEARING + "thermo_style one\nminimize 1e-4 1e-6 10 100\n")
    refuses(deck, "cannot minimize, because its forces depend on speeds", host=host)


@pytest.mark.parametrize("host", EVERYWHERE)
def test_respa(tmp_path, host):
    """Nothing would move, since fixes have other functions for the levels of respa."""
    deck = deck_file(tmp_path, BEARING + "run_style respa 2 2\nrun 10\n")
    refuses(deck, "needs 'run_style verlet'", host=host)


@pytest.mark.parametrize(
    "more, message",
    [
        (
            "fix more cage bearing/cage b",
            "fix more bearing/cage and fix rails bearing/cage both hold cage ball 10",
        ),
        ("fix cap inner bearing/capacitance 1", "fix cap bearing/capacitance: group inner has no"),
    ],
)
def test_groups_that_cannot_be_meant(tmp_path, more, message):
    """Twice the force of the rails, and a capacitance of nothing."""
    deck = (
        named_bearing(neighbor="2.0e-3 bin")
        + """
create_bearing b speed 50 0
fix rails cage bearing/cage b
fix move all bearing/implicit
{}
timestep 1.0e-5
run 1
"""
    )
    succeed(deck_file(tmp_path, deck.format("")))
    refuses(deck_file(tmp_path, deck.format(more)), message, ranks=2)
