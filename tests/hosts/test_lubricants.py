# SPDX-License-Identifier: GPL-2.0-or-later
"""A lubricant in a deck: pair_style bearing takes what `raceway.inputs` gives."""

import re

import pytest
import raceway
from host import ROOT, run
from raceway import inputs

OILS = ROOT / "inputs/lubricants"
PHYSICAL = ["vg32", "vg46", "vg68", "vg100", "pao8", "grease110"]
TEMPERATURES = [-20.0, 70.0]

DECK = """\
variable out index nowhere
variable lubricant index vg46
variable temperature index 40
bearing b 6208 types 1 2 3 4
units si
atom_style sphere
atom_modify map array
boundary f f f
newton off
region box block -1 1 -1 1 -1 1 units box
create_box 4 box
pair_style bearing oil ${lubricant} temperature ${temperature} models full vars inputs
pair_coeff * * b
create_bearing b speed 50 0
fix inner inner bearing/ring spin speed 50
fix outer outer bearing/ring
fix cage cage bearing/cage b
fix cap balls bearing/capacitance
fix move all bearing/implicit
fix record all bearing/record pass/20 ${out} overwrite yes
run_bearing settle 0 passes 1
"""


def deck(tmp_path, host, name, **given):
    """The run of a deck with a lubricant."""
    path = tmp_path / "in.deck"
    path.write_text(DECK)
    return run(path, host=host, lubricant=name, out=tmp_path / "run", **given)


@pytest.mark.parametrize("host", ["liggghts", "lammps"])
@pytest.mark.parametrize("name", PHYSICAL)
def test_a_deck_has_the_same_fluid(tmp_path, host, name):
    for warm in TEMPERATURES:
        ran = deck(tmp_path, host, name, temperature=warm)
        assert ran.code == 0, ran.text[-1000:]
        commands = raceway.open(tmp_path / "run").tables.record.attrs["pair_commands"]
        fluid = inputs.fluid(OILS / name, warm)
        viscosity, pressure = re.search(r" lubricant (\S+) (\S+)", commands).groups()
        thins, conducts = re.search(r" inlet_shear murch (\S+) (\S+)", commands).groups()
        density = re.search(r" drag (\S+)", commands)[1]
        for said, field in (
            (viscosity, "viscosity"),
            (pressure, "pressure_viscosity"),
            (thins, "temperature_viscosity"),
            (conducts, "conductivity"),
            (density, "density"),
        ):
            assert float(said) == pytest.approx(getattr(fluid, field), rel=1e-14), field


def test_a_deck_refuses_a_temperature(tmp_path):
    ran = deck(tmp_path, "liggghts", "mineral", temperature=70)
    assert ran.code and "has values for 40 C only, not for 70 C" in ran.error
    ran = deck(tmp_path, "liggghts", "vg46", temperature=250)
    assert ran.code and "temperature (C) is 250, must be from -40 to 200" in ran.error


def test_a_deck_takes_what_is_given_outright(tmp_path):
    ran = deck(tmp_path, "liggghts", "vg46", viscosity=0.05)
    assert ran.code == 0, ran.text[-1000:]
    assert raceway.open(tmp_path / "run").settings["viscosity_Pa_s"] == 0.05
