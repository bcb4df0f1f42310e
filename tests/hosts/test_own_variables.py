# SPDX-License-Identifier: GPL-2.0-or-later
"""A deck that includes the main deck may define variables with any names, because the names of
variables that belong to the main deck and its bearing begin with b_."""

import re

import pytest
from host import QUICK, ROOT, deck_file, same_files, succeed

OWN = """x y z vx vy vz fx fy fz mx my mz n every dt new half omega spin pitch skin wanted now
format step_length capacitance settings steps row types loaded""".split()
SHORT = {**QUICK, "passes": 1, "samples": 20, "rpm": 20000, "dumps": "yes"}


@pytest.mark.parametrize("host", ["liggghts", "lammps"])
@pytest.mark.parametrize("integrator", ["implicit", "verlet"])
def test_deck_with_variables_of_its_own(tmp_path, host, integrator):
    deck = deck_file(
        tmp_path,
        "".join(f"variable {name} index mine_{name}\n" for name in OWN)
        + "include inputs/in.6208\n"
        + "".join(f'print "OWN ${{{name}}}"\n' for name in OWN),
    )
    end = succeed(deck, host=host, out=tmp_path / "run", integrator=integrator, **SHORT)
    assert re.findall(r"^OWN (\w+)$", end.text, re.M) == [f"mine_{name}" for name in OWN]
    plain = tmp_path / "plain"
    succeed("inputs/in.6208", host=host, out=plain, integrator=integrator, **SHORT)
    same_files(plain, tmp_path / "run", "contacts.dump", "balls.dump", "rings.dat")


def test_prefix():
    """All variables that the main deck sets itself have names that begin with b_, so they never
    clash with a -var."""
    own = re.findall(
        r"^variable (\w+) +(?! |index)", (ROOT / "inputs" / "in.6208").read_text(), re.M
    )
    assert own and all(name.startswith("b_") for name in own)
