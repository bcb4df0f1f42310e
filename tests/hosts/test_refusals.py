# SPDX-License-Identifier: GPL-2.0-or-later
"""Fixes that may change the motion, box or timestep are refused by name; others are allowed."""

import pytest
from host import BOX, run

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
EVERYWHERE, LAMMPS, WHEEL = ("liggghts", "lammps", "wheel"), ("lammps", "wheel"), ("wheel",)
MAY = "which may change their motion"
# words of a fix on the atoms of fix bearing/implicit: (what the error says, hosts with that fix)
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
    "recenter INIT INIT INIT": ("may not change the place of its atoms", LAMMPS),
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


def outcome(tmp_path, deck, host="liggghts", **variables):
    file = tmp_path / "in.refused"
    file.write_text(deck)
    return run(file, host=host, **variables)


@pytest.mark.parametrize(
    "host, words", [(host, words) for words, (_, hosts) in FIXES.items() for host in hosts]
)
def test_fixes_beside_the_implicit_step(tmp_path, host, words):
    """Also one that comes between two runs."""
    message, _ = FIXES[words]
    end = outcome(tmp_path, BEARING + f"run 2\nfix beside bearing {words}\nrun 10\n", host)
    if message:
        assert end.code != 0 and message in end.error and "fix beside" in end.error, end.text
    else:
        assert end.code == 0, end.text
