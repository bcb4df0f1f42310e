# SPDX-License-Identifier: GPL-2.0-or-later
"""Runs with the models `eyring`: their sliding against that of statics, which sums Eyring's stress
over each ellipse."""

import pytest
from host import ROOT, run, succeed
from raceway.runs.summary import summary
from raceway.runs.tables import RunTables
from raceway.theory import steady_heat


def test_sliding_is_that_of_statics(tmp_path):
    """9549 rpm, where balls in the loaded zone roll freely: slip of a run against statics at the
    same temperature. `full` has Coulomb's law with 0.05 in its place."""
    case = steady_heat.Case("6208", "vg46", load=5000.0, rpm=9549.0)
    statics = case.scene().at(94.5, 0.0)["losses_W"]["slip"]
    found = {}
    for models in ("eyring", "full"):
        deck = {"rpm": 9549, "lubricant": "vg46", "temperature": 94.5, "models": models}
        succeed("inputs/in.6208", out=tmp_path / models, **deck)
        found[models] = summary(RunTables(tmp_path / models))["losses_W"]["slip"]
    assert found["eyring"] == pytest.approx(statics, rel=0.15)
    assert found["full"] > 1.8 * found["eyring"]


def test_dry_and_oil_without_the_numbers(tmp_path):
    """Dry it is `full`. An oil without an Eyring stress is refused."""
    short = {"passes": 1, "samples": 20, "rpm": 9549}
    succeed("inputs/in.dry", out=tmp_path / "dry", models="eyring", **short)
    oil = (ROOT / "inputs/lubricants/vg46").read_text()
    less = tmp_path / "less"
    less.write_text("\n".join(line for line in oil.splitlines() if "eyring_stress" not in line))
    done = run("inputs/in.6208", out=tmp_path / "x", models="eyring", lubricant=less, **short)
    assert done.code != 0 and "eyring_stress" in done.text
