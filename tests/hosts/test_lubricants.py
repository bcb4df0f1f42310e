# SPDX-License-Identifier: GPL-2.0-or-later
"""A lubricant in a deck: bearing_derive gives what `raceway.inputs` gives."""

import subprocess
from pathlib import Path

import pytest
from raceway import inputs

ROOT = Path(__file__).resolve().parents[2]
OILS = ROOT / "inputs/lubricants"
PHYSICAL = ["vg32", "vg46", "vg68", "vg100", "pao8", "grease110"]
TEMPERATURES = [-20.0, 70.0]

DECK = """\
variable inputs index inputs
bearing_input ${inputs}/lubricants ${lubricant}
"""


def deck(host, name, *options):
    """The deck's variables of a lubricant as the host has them."""
    text = DECK + "".join(
        f'print "{field} ${{{key}}}"\n'
        for field, key in {**inputs.FLUID, "temperature": "temperature"}.items()
    )
    options = ("-var", "lubricant", name, *options)
    return subprocess.run(
        [str(ROOT / "build" / host), "-log", "none", *options],
        input=text,
        cwd=ROOT,
        capture_output=True,
        text=True,
        errors="replace",
    )


@pytest.mark.parametrize("host", ["liggghts", "lammps"])
@pytest.mark.parametrize("name", PHYSICAL)
def test_a_deck_has_the_same_fluid(host, name):
    for warm in TEMPERATURES:
        ran = deck(host, name, "-var", "temperature", str(warm))
        said = dict(line.split() for line in ran.stdout.splitlines() if len(line.split()) == 2)
        for field, value in inputs.fluid(OILS / name, warm)._asdict().items():
            assert float(said[field]) == pytest.approx(value, rel=1e-14), field


def test_a_deck_refuses_a_temperature():
    ran = deck("liggghts", "mineral", "-var", "temperature", "70")
    assert ran.returncode and "mineral has values for 40 C only: take vg46" in ran.stdout
    ran = deck("liggghts", "vg46", "-var", "temperature", "250")
    assert ran.returncode and "temperature is 250, must be from -40 to 200" in ran.stdout


def test_a_deck_takes_what_is_given_outright():
    ran = deck("liggghts", "vg46", "-var", "viscosity", "0.05")
    assert "viscosity 0.05\n" in ran.stdout
