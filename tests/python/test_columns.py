# SPDX-License-Identifier: GPL-2.0-or-later
"""The columns in Python and on the pages are those of the C++ that was built."""

import json
import math
import subprocess
from pathlib import Path

import pytest
from raceway import columns

ROOT = Path(__file__).resolve().parents[2]
KEPT = Path(columns.__file__).with_name("columns.json")


def test_kept_is_what_the_build_prints():
    """`make columns` was run after the last change of a column."""
    done = subprocess.run([ROOT / "build" / "columns"], capture_output=True, text=True, check=True)
    assert done.stdout == KEPT.read_text(), "run: make columns"


SECTIONS = [name for name in json.loads(KEPT.read_text()) if name not in ("law", "validity")]


@pytest.mark.parametrize("section", SECTIONS)
def test_every_column_says_what_it_is(section):
    rows = json.loads(KEPT.read_text())[section]
    names = [row["name"] for row in rows]
    assert len(set(names)) == len(names) > 0
    for row in rows:
        assert row["meaning"] and row["absent"] in (0, None)
        assert row["format"] in ("%.12g", "%.0f")


def test_tables():
    assert columns.CONTACT["load"].unit == "N" and columns.CONTACT["load"].absent == 0
    assert math.isnan(columns.CONTACT["h_min"].absent)
    assert {"x", "omegaz"} < set(columns.ATOM)
    assert columns.RING["fy"].meaning == "force of balls and cage on the inner ring along y"
    assert columns.BEARING["capacitance"].unit == "F"


def test_every_keyword_of_the_law_says_what_it_takes():
    """A number has a meaning, a range and a default; a word has its choices."""
    contact = {row["name"] for row in json.loads(KEPT.read_text())["contact"]}
    parts = json.loads(KEPT.read_text())["law"]
    assert len({part["name"] for part in parts}) == len(parts) >= 9
    for part in parts:
        assert set(part["columns"]) <= contact and part["states"] >= 0
        for keyword in part["keywords"]:
            for value in keyword["parameters"]:
                assert value["meaning"] and value["initial"]
                assert value["choices"] or value["most"] is None or value["most"] > value["least"]
