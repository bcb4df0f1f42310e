# SPDX-License-Identifier: GPL-2.0-or-later
"""The JSON keys of every command with --json contain their units."""

import argparse
import json
import re

import pytest
import test_compare
from raceway.cli import _parser, main

twin = test_compare.run  # this run is long enough for an envelope

UNITS = "m m2 kg s h rad deg rpm Hz N Pa F V A J W K C ohm Mrev order"
# the entries of these matrices have different units (docs/static)
MATRIX = "^(stiffness|damping|place)(_|$)"
# a unit at the end of the key, or the last part of a compound unit such as _N_m_rad or _kg_m2
NAMED = re.compile(f"_(per_)?({'|'.join(UNITS.split())})$|^rpm(_|$)|{MATRIX}")
# numbers without a unit: counts, fractions, ratios and factors
PLAIN = set(
    """passes load_parameter lambda lambda_inner lambda_outer permittivity loaded_balls
    loaded_balls_mean real_time_factor
    evaluations asperity_share settled_torque settled_load settled_cage_speed settled_cage_orbit
    remaining_torque remaining_load remaining_cage_speed
    cage_slip slip ridge
    static_safety viscosity_ratio life_factor film_factor gyroscopic_friction plates_factor
    metallic_contacts metallic_share samples bearing_voltage_ratio bearing_voltage_ratio_min
    bearing_voltage_ratio_max bearing_voltage_ratio_mean floor_share discharges discharges_per_s
    full_discharges failed_inner failed_outer balls harmonic order difference prominence values
    share revolutions_share damage_share clipped_share
    kurtosis chi_squared idle_balls residual""".split()
)
READINGS = """bearing: 6205
lubricant: vg68
known: {load: 10, temperature: 40}
unknown: {clearance: 0 15e-6, axial: 20 200}
readings:
  - {rpm: 1797, BPFO: 3.5972, within: 2e-4}
"""


@pytest.fixture
def words(folder, tmp_path, twin):
    """Return lists of arguments for each command that has --json."""
    (tmp_path / "readings.yaml").write_text(READINGS)
    duties = tmp_path / "duties.csv"
    duties.write_text("load,axial,rpm,share\n900,300,3000,1\n")
    path, rate = test_compare.write(tmp_path, twin)
    run, file = str(folder), [str(path), "--rpm", "477.5", "--rate", str(rate)]
    motor = "--motor 50e-12 1e-9 --common-mode 560 300 50 0.8 --strength 30e6 --arc 5".split()
    point = ["--load", "900", "--axial", "300", "--rpm", "3000"]
    return {
        "summary": [[run]],
        "spectrum": [[run], [str(twin.tables.folder), "--envelope"]],
        "static": [[*point, "--lubricant", "vg46"], ["--load", "900"], ["--spectrum", str(duties)]],
        "heat": [point],
        "shaft": [["inputs/shafts/motor"]],
        "catalogue": [["6208", "--clearances"]],
        "electric": [[*point, "--voltage", "5", "--frequency", "1e4"], [run]],
        "circuit": [[run, *motor]],
        "measured": [file],
        "compare": [[str(twin.tables.folder), *file, "--signal", "shift", "--ring", "inner"]],
        "identify": [[str(tmp_path / "readings.yaml")]],
    }


def numbers(value, keys=(), beside=()):
    """Yield the keys that lead to a number or a list of numbers, and the siblings of the last
    key."""
    if isinstance(value, dict):
        for key, one in value.items():
            yield from numbers(one, (*keys, key), value.keys())
    elif isinstance(value, list) and any(isinstance(one, dict | list) for one in value):
        for one in value:
            yield from numbers(one, keys, beside)
    elif isinstance(value, list) and all(isinstance(one, str) for one in value):
        pass
    elif not isinstance(value, bool | str | None):
        yield keys, beside


def named(keys, beside):
    """Return True if the last key, or one of its siblings, contains the unit."""
    return (
        any(key in PLAIN for key in keys)
        or "unit" in beside
        or f"{keys[-1]}_unit" in beside
        or any(NAMED.search(key) for key in keys)
    )


def commands():
    (sub,) = (one for one in _parser()._actions if isinstance(one, argparse._SubParsersAction))
    return {
        name
        for name, parser in sub.choices.items()
        if any("--json" in one.option_strings for one in parser._actions)
    }


def test_units(words, capsys, tmp_path):
    assert commands() == set(words)
    said = {}
    for command, calls in words.items():
        for k, call in enumerate(calls):
            assert main([command, *call, "--json"]) == 0, (command, capsys.readouterr().err)
            said[f"{command} {k}"] = capsys.readouterr().out
    out = tmp_path / "matrices.json"
    oil = "--load 900 --rpm 900 --lubricant vg46".split()
    assert main(["stiffness", *oil, "--out", str(out)]) == 0
    said["stiffness"] = out.read_text()
    found = {
        f"{command}: {'/'.join(keys)}"
        for command, text in said.items()
        for keys, beside in numbers(json.loads(text))
        if not named(keys, beside)
    }
    assert not found
