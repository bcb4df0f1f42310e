# SPDX-License-Identifier: GPL-2.0-or-later
"""Verdicts on the paper's statements, and the record of them in docs/paper."""

from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pandas as pd
import pytest
from raceway import inputs
from raceway.errors import RacewayError
from raceway.paper import press, reading, shown, statements
from raceway.paper.quantities import formulas
from raceway.paper.quantity import Quantity
from raceway.paper.statements import AGREE, DIFFER, SAME, UNKNOWN, Statement

ROOT = Path(__file__).resolve().parents[2]
RECORD = ROOT / "docs/paper"


def recorded():
    """{formulas: {name: Quantity}} of docs/paper."""
    table = pd.read_csv(RECORD / "quantities.csv", keep_default_na=False)
    return {
        form: {row.quantity: Quantity(row.value, row.unit, row.label) for row in rows.itertuples()}
        for form, rows in table.groupby("formulas")
    }


@pytest.mark.parametrize(
    ("rule", "expected"),
    [
        ("a > 1", True),
        ("a > 2", False),
        ("a < b", True),
        ("b < a", False),
        ("a = 2.1 within 0.11", True),
        ("a = 2.1 within 0.09", False),
        ("a = b within 1.01", True),
        ("b < -1.0e-3", False),
    ],
)
def test_rules(rule, expected):
    assert statements.holds(rule, {"a": 2.0, "b": 3.0}) is expected


@pytest.mark.parametrize("rule", ["a", "a = 1", "a > 1 within 2", "a >= 1"])
def test_not_a_rule(rule):
    with pytest.raises(ValueError, match="not a rule"):
        statements.holds(rule, {"a": 1.0})


def test_judge():
    corrected = {"a": Quantity(1.0, "m", "length"), "b": Quantity(2.0, "", "number")}
    statement = Statement("1", "...", "", ("a < 2",), ("a", "b"), "is {b}")
    judged = statements.judge(statement, corrected, {})
    assert (judged.corrected, judged.printed, judged.why) == (AGREE, SAME, "is 2")
    assert judged.corrected_numbers == "length: 1 m; number: 2"
    judged = statements.judge(statement, corrected, {"a": Quantity(3.0, "m", "length")})
    assert (judged.corrected, judged.printed, judged.printed_numbers) == (
        AGREE,
        DIFFER,
        "length: 3 m; number: 2",
    )
    judged = statements.judge(
        statement._replace(about="print"), corrected, {"a": Quantity(3.0, "m", "length")}
    )
    assert (judged.corrected, judged.printed) == (DIFFER, DIFFER)
    assert statements.judge(statement._replace(rules=()), corrected, {}).corrected == UNKNOWN


def test_judged_with_all_of_the_capacitance():
    """Own rules where the statement has them, else the same with other numbers; untouched without
    any."""
    corrected = {"a": Quantity(1.0, "F", "plates"), "b": Quantity(5.0, "", "number")}
    whole = {"a": Quantity(3.0, "F", "all"), "c": Quantity(2.0, "F", "around")}
    same = Statement("1", "...", "", ("a < 2",), ("a",), "")
    judged = statements.judge(same, corrected, {}, whole)
    assert (judged.corrected, judged.whole, judged.whole_numbers) == (AGREE, DIFFER, "all: 3 F")
    own = same._replace(whole={"rules": ["c > 1"], "show": ["c"], "why": "{c} more"})
    judged = statements.judge(own, corrected, {}, whole)
    assert (judged.whole, judged.whole_numbers, judged.whole_why) == (
        AGREE,
        "around: 2 F",
        "2 F more",
    )
    other = same._replace(rules=("b > 1",), show=("b",))
    judged = statements.judge(other, corrected, {}, whole)
    assert (judged.whole, judged.whole_numbers, judged.whole_why) == (SAME, "", "")
    assert statements.judge(own, corrected, {}).whole == SAME


def test_the_record_follows_from_its_numbers():
    numbers = recorded()
    table = pd.read_csv(RECORD / "statements.csv", keep_default_na=False)
    judged = [
        statements.judge(one, numbers["corrected"], numbers["printed"], numbers["whole"])
        for one in statements.read()
    ]
    assert [one.corrected for one in judged] == list(table["corrected"])
    assert [one.printed for one in judged] == list(table["printed"])
    assert [one.whole for one in judged] == list(table["whole"])
    assert [shown.plain(one.says) for one in judged] == list(table["says"])


@pytest.mark.parametrize("printed", [False, True])
def test_recorded_formulas(printed):
    book = SimpleNamespace(
        bearing=inputs.bearing(ROOT / "inputs/bearings/6208"),
        oils={name: inputs.oil(ROOT / "inputs/lubricants" / name) for name in ("mineral", "pao48")},
        entrainment=lambda rpm: rpm * np.pi / 30 * 30.3e-3 * (1 - (6.3 / 30.3) ** 2) / 2,
    )
    before = recorded()["printed" if printed else "corrected"]
    for name, one in formulas.measure(book, printed).items():
        # seven digits are kept
        assert one.value == pytest.approx(before[name].value, rel=1e-5, abs=1e-12), name


def test_known_numbers():
    """Numbers of the record that are known from elsewhere (PHYSICS, docs/errata)."""
    numbers = {
        form: {name: one.value for name, one in some.items()} for form, some in recorded().items()
    }
    corrected, printed = numbers["corrected"], numbers["printed"]
    assert (printed["stiffness_inner"], printed["stiffness_outer"]) == pytest.approx(
        (1.316, 1.324), abs=5e-4
    )
    assert printed["sphere_stiffness"] == pytest.approx(1.43, abs=5e-3)
    assert (corrected["p_inner"], corrected["p_outer"]) == pytest.approx((2571e6, 2123e6), rel=1e-3)
    assert [
        corrected[f"epsilon_{key}"] for key in ("minus_45", "minus_35", "plus_35", "plus_45")
    ] == pytest.approx([1.699, 1.317, 0.319, 0.292], abs=3e-3)
    assert [
        printed[f"epsilon_{key}"] for key in ("minus_45", "minus_35", "plus_35", "plus_45")
    ] == pytest.approx([2.09, 1.58, 0.30, 0.27], abs=5e-3)


def test_gridded():
    psi = np.arange(-60.0, 60.1, 0.25)
    values = reading.gridded(psi, np.cos(np.radians(psi)))
    inside = np.abs(reading.GRID) <= 60
    assert values[inside] == pytest.approx(np.cos(np.radians(reading.GRID[inside])), rel=1e-12)
    assert not values[~inside].any()


@pytest.mark.parametrize(
    ("value", "unit", "text"),
    [
        (-0.0004, "%", "−0.04 %"),
        (4.41e-5, "m", "44.1 µm"),
        (2.5713e9, "Pa", "2.571 GPa"),
        (270.05, "rpm", "270.1 rpm"),
        (12.006, "°", "12.01°"),
        (0.31904, "", "0.319"),
    ],
)
def test_quantity_text(value, unit, text):
    assert Quantity(value, unit, "").text == text


def test_shown_table():
    table = pd.DataFrame(
        {
            "property": ["viscosity_Pa_s", "pressure_viscosity_per_Pa"],
            "value": [0.04, 22e-9],
            "inner_film_m": [9.58e-8, np.nan],
            "angle_deg": [12.0, -1.5],
        }
    )
    cells = [line.strip(" *-") for line in shown.table(table).splitlines() if "- " in line]
    assert cells == [
        "property",
        "value",
        "inner film",
        "angle",
        "viscosity",
        "40 mPa s",
        "95.8 nm",
        "12°",
        "pressure viscosity",
        "22 /GPa",
        "",
        "−1.5°",
    ]


def test_markup():
    assert shown.markup("$h_{min}$ over |x|*") == r":math:`h_{min}` over \|x\|\*"
    assert shown.plain("$h_{min}$ over x") == "h_min over x"


def test_no_half_written_file(tmp_path):
    (tmp_path / "taken").mkdir()
    with pytest.raises(RacewayError, match="cannot write"):
        press._text(tmp_path / "taken", "text")
    assert [path.name for path in tmp_path.iterdir()] == ["taken"]
