# SPDX-License-Identifier: GPL-2.0-or-later
"""A deck that includes the main deck has its own variables: what modules define for themselves
carries the prefix b_."""

import re

import pytest
from host import ROOT, succeed
from raceway import data_table, inputs

INPUTS = ROOT / "inputs"
OWN = """x y z vx vy vz fx fy fz mx my mz n every dt new half omega spin pitch skin wanted now
format step_length capacitance settings steps row types loaded""".split()
SHORT = {"passes": 1, "samples": 20, "rpm": 20000, "dumps": "yes"}


@pytest.mark.parametrize("host", ["liggghts", "lammps"])
@pytest.mark.parametrize("integrator", ["implicit", "verlet"])
def test_deck_with_variables_of_its_own(tmp_path, host, integrator):
    deck = tmp_path / "in.mine"
    deck.write_text(
        "".join(f"variable {name} index mine_{name}\n" for name in OWN)
        + "include inputs/in.6208\n"
        + "".join(f'print "OWN ${{{name}}}"\n' for name in OWN)
    )
    end = succeed(deck, host=host, out=tmp_path / "run", integrator=integrator, **SHORT)
    assert re.findall(r"^OWN (\w+)$", end.text, re.M) == [f"mine_{name}" for name in OWN]
    plain = tmp_path / "plain"
    succeed("inputs/in.6208", host=host, out=plain, integrator=integrator, **SHORT)
    for name in ("contacts.dump", "balls.dump", "rings.dat"):
        assert (plain / name).read_bytes() == (tmp_path / "run" / name).read_bytes()


def variables(folder):
    """{name: styles} of the `variable` commands in the files of a folder and in the rows that
    stand for files."""
    found = {}
    for path in data_table.names(INPUTS / folder):
        for name, style in re.findall(
            r"variable (\w+)\s+(\w+)", inputs.text(INPUTS / folder / path)
        ):
            found.setdefault(name, set()).add(style)
    return found


def test_prefix():
    """Without it stand what a user may give with -var, and numbers of bearings and lubricants that
    follow from other data."""
    page = (ROOT / "docs" / "main_deck.rst").read_text()
    data = set(variables("bearings")) | set(variables("lubricants"))
    for folder in ("modules", "integrators"):
        for name, styles in variables(folder).items():
            if name.startswith("b_") or name in variables("models"):
                continue
            assert styles == {"index"}, name
            assert name in data or f"``{name}``" in page, name
