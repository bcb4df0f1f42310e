# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of the columns and keywords of the contact law, as defined by the C++ tables."""

import subprocess
import sys

import pytest
from raceway import core

TABLES = core.table("columns")


@pytest.mark.parametrize("section", [name for name in TABLES if name not in ("law", "validity")])
def test_every_column_says_what_it_is(section):
    rows = TABLES[section]
    names = [row["name"] for row in rows]
    assert len(set(names)) == len(names) > 0
    for row in rows:
        assert row["meaning"] and row["absent"] in (0, None)
        assert row["format"] in ("%.12g", "%.0f")


def test_temperatures_are_in_degrees_celsius():
    """Readers of netCDF files take C for the coulomb (UDUNITS, pint)."""
    rows = [row for name in TABLES if name != "law" for row in TABLES[name] if row.get("unit")]
    temperatures = [row["unit"] for row in rows if row["name"].startswith("temperature")]
    assert set(temperatures) == {"degC"}
    assert all("charge" in row["meaning"] for row in rows if row["unit"] == "C")


def test_every_keyword_of_the_law_says_what_it_takes():
    """A keyword that takes a number has a meaning, a range and a default; a keyword that takes a
    word has a list of choices."""
    contact = {row["name"] for row in TABLES["contact"]}
    parts = TABLES["law"]
    assert len({part["name"] for part in parts}) == len(parts) >= 9
    for part in parts:
        assert set(part["columns"]) <= contact and part["states"] >= 0
        for keyword in part["keywords"]:
            for value in keyword["parameters"]:
                assert value["meaning"] and value["initial"]
                assert value["choices"] or value["most"] is None or value["most"] > value["least"]


AT_ONCE = """
from concurrent.futures import ThreadPoolExecutor
from raceway import core
with ThreadPoolExecutor(8) as pool:
    for _ in range(40):
        for name in ("columns", "variables"):
            found = list(pool.map(core.table.__wrapped__, [name] * 8))
            assert found == found[:1] * 8, name
"""


def test_threads_read_a_table_at_once():
    """The library generates the text of each table only once. `raceway.simulate` used to fail if
    two threads generated it at the same time."""
    done = subprocess.run([sys.executable, "-c", AT_ONCE], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
