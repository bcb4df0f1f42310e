# SPDX-License-Identifier: GPL-2.0-or-later
"""Run the deck of every scenario in scenarios.yaml, and compare its summary with closed-form
solutions and reference values."""

from pathlib import Path

import pytest
import yaml
from host import succeed
from raceway.runs.summary import summary
from raceway.runs.tables import RunTables

from scenarios import closed_forms

SCENARIOS = yaml.safe_load((Path(__file__).parent / "scenarios.yaml").read_text())


@pytest.mark.parametrize("name", SCENARIOS)
def test_scenario(name, tmp_path):
    scenario = SCENARIOS[name]
    succeed(scenario["deck"], out=tmp_path, **scenario.get("variables", {}))
    run = RunTables(tmp_path)
    figures = summary(run)
    for key, want in scenario["expect"].items():
        value = (
            want["value"] if "value" in want else getattr(closed_forms, want["form"])(run, figures)
        )
        allowed = want["within"] if "within" in want else want["tolerance"] * abs(value)
        assert abs(figures[key] - value) <= allowed, (
            f"{key} is {figures[key]}, but should be {value} within {allowed} ({want['why']})"
        )
