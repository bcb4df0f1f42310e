# SPDX-License-Identifier: GPL-2.0-or-later
"""in.warm_two: two bearings with different names, each heated by its own fix bearing/heat, share a
thermal clock and do not affect each other's temperatures."""

import re

import numpy as np
import pytest
import raceway
from host import ROOT, columns, deck_file, refuses, succeed

DECK = "tests/scenarios/in.warm_two"
TEMPERATURES = ["temperature_inner", "temperature_balls", "temperature_outer"]


def alone(folder, load):
    """Return the table of a bearing that warms up under a load (N) beside a cold one."""
    succeed(DECK, out=folder, load_a=load, heat_b="no")
    return columns(folder / "a.txt")


def test_equal_bearings_have_equal_temperatures(tmp_path):
    """The balls differ in rounding, and so do light contacts. The mean losses of a ball pass are
    accurate to 1e-3; an error of 1e-3 in one of them changes a temperature by far less than 1e-4
    of its value. The length of a jump is inversely proportional to the losses, so the thermal time
    is accurate to 1e-3 as well."""
    succeed(DECK, out=tmp_path)
    a, b = columns(tmp_path / "a.txt"), columns(tmp_path / "b.txt")
    one = alone(tmp_path / "one", 500)
    assert a["thermal_time"][-1] > 100
    bounds = dict.fromkeys(TEMPERATURES, 1e-4) | {"power": 1e-3, "thermal_time": 1e-3}
    for column, bound in bounds.items():
        assert a[column] == pytest.approx(b[column], rel=bound), column
        assert a[column] == pytest.approx(one[column], rel=bound), column


def test_one_clock_for_different_loads(tmp_path):
    """Steady temperatures are exact to 0.05 K (each run) where the losses stay as they are."""
    succeed(DECK, out=tmp_path, load_b=2000)
    tables = columns(tmp_path / "a.txt"), columns(tmp_path / "b.txt")
    assert np.array_equal(tables[0]["thermal_time"], tables[1]["thermal_time"])
    for table, load in zip(tables, (500, 2000)):
        one = alone(tmp_path / f"{load}", load)
        for column in TEMPERATURES:
            assert table[column][-1] == pytest.approx(one[column][-1], abs=0.1), (load, column)


def test_different_thermal_times_are_refused(tmp_path):
    says = "all bearings share one thermal clock"
    refuses(DECK, says, out=tmp_path, until_a=10, until_b=20)


def test_a_part_of_the_bearings_of_a_name_is_refused(tmp_path):
    """Bearings of one name share their temperatures, so they cannot be heated one by one."""
    text = re.sub(r"^(pair_coeff|bearing) .*\bb\b.*\n", "", (ROOT / DECK).read_text(), flags=re.M)
    text = re.sub(r"^fix (rails|heat|ring)_b .*\n", "", text, flags=re.M)
    text = text.replace("create_bearing b centre", "create_bearing a centre")
    text = text.replace("inner_a bearing", "inner bearing")
    text = text.replace("group of_a type 1 2 3 4", "group of_a id 1:20")
    says = ["fix heat_a bearing/heat", "group of_a has only 9 of the 18 balls of bearing a"]
    refuses(deck_file(tmp_path, text), *says, out=tmp_path, ranks=2)


def own_ambients(folder, **variables):
    """Run a deck in which bearing b is surrounded by warmer air than bearing a, whose table has the
    name that summaries read, and return the summary of each bearing."""
    text = (ROOT / DECK).read_text()
    ambient = "bearing/heat ambient 45 heat"
    for old, new in (("/a.txt", "/heat.txt"), ("bearing/heat heat", ambient)):
        assert old in text
        text = text.replace(old, new)
    succeed(deck_file(folder, text), out=folder, until_a=20, until_b=20, **variables)
    return [raceway.open(folder).select(number).summary() for number in (1, 2)]


def test_summaries_of_bearings_with_their_own_ambient(tmp_path):
    """The clearance is that of the warm parts of the bearing, which has the clearance of its data
    at its own ambient temperature. The table of one bearing does not apply to the other."""
    first, second = own_ambients(tmp_path)
    for name, figures in (("heat", first), ("b", second)):
        table = columns(tmp_path / f"{name}.txt")
        assert figures["clearance_warm_m"] == pytest.approx(table["clearance"][-1], rel=1e-9)
        for part in ("inner", "balls", "outer"):
            warm = table[f"temperature_{part}"][-1]
            assert figures[f"temperature_{part}_C"] == pytest.approx(warm, rel=1e-9)
    assert first["heat_booked_J"] == pytest.approx(
        columns(tmp_path / "heat.txt")["booked"][-1], rel=1e-9
    )
    assert "heat_booked_J" not in second


def test_summaries_of_a_bearing_beside_a_heated_one(tmp_path):
    """A bearing that is not heated has no temperatures, and all its figures are numbers."""
    first, second = own_ambients(tmp_path, heat_b="no")
    assert "thermal_time_s" in first
    assert not {key for key in second if key.startswith(("temperature_i", "clearance_w", "heat"))}
    assert np.isfinite([value for value in second.values() if isinstance(value, float)]).all()
