# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of the verdicts on the statements of the paper."""

from types import SimpleNamespace

import numpy as np
import pytest
from host import ROOT
from raceway import inputs
from raceway.errors import RacewayError
from raceway.paper import press, reading, statements
from raceway.paper.quantities import formulas
from raceway.paper.quantity import Quantity
from raceway.paper.statements import AGREE, DIFFER, SAME, UNKNOWN, Statement


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
    """Statements with rules for the total capacitance are judged by these rules. For the other
    statements, the usual rules are applied to the new values. If there are no new values, the
    verdict does not change."""
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


def test_verdicts_that_are_stated():
    """Every statement has an entry in each column. If there is no rule, the verdict is unknown."""
    verdicts = {AGREE, DIFFER, UNKNOWN}
    for one in statements.read():
        assert one.found[0] in verdicts and set(one.found[1:]) <= verdicts | {SAME}
        assert (one.found[0] == UNKNOWN) == (not one.rules), one.says


def test_known_formulas():
    """The printed formulas for the stiffness are evaluated from the data of the bearing alone
    (docs/errata)."""
    book = SimpleNamespace(
        bearing=inputs.bearing(ROOT / "inputs/bearings/6208"),
        oils={name: inputs.oil(ROOT / "inputs/lubricants" / name) for name in ("mineral", "pao48")},
        entrainment=lambda rpm: rpm * np.pi / 30 * 30.3e-3 * (1 - (6.3 / 30.3) ** 2) / 2,
    )
    printed, corrected = (formulas.measure(book, how) for how in (True, False))
    found = [printed["stiffness_inner"], printed["stiffness_outer"]]
    assert found == pytest.approx([1.316, 1.324], abs=5e-4)
    assert printed["sphere_stiffness"] == pytest.approx(1.43, abs=5e-3)
    assert corrected["stiffness_inner"] == corrected["stiffness_outer"] == 1.0


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


def test_markup():
    assert statements.markup("$h_{min}$ over |x|*") == r":math:`h_{min}` over \|x\|\*"
    assert statements.plain("$h_{min}$ over x") == "h_min over x"


def test_no_half_written_file(tmp_path):
    (tmp_path / "taken").mkdir()
    with pytest.raises(RacewayError, match="cannot write"):
        press._text(tmp_path / "taken", "text")
    assert [path.name for path in tmp_path.iterdir()] == ["taken"]
