# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of the limits of the formulas: bounds defined in C++, and ellipses that reach the shoulder
of their groove."""

import math

import numpy as np
import pytest
from commands import answer, reply
from raceway import catalogue, inputs, operating_point
from raceway.inputs import InputError
from raceway.theory.bearing import Bearing
from raceway.theory.validity import RULES, Shoulders, doubts, past_shoulder

GROOVE = 6.552e-3
BEARING = Bearing(9, 12.6e-3, 24e-3, 36.6e-3, GROOVE, GROOVE)


@pytest.mark.parametrize("name", RULES)
def test_a_rule_holds_up_to_its_bound(name):
    rule = RULES[name]
    outside = rule.bound * (0.999 if rule.below else 1.001)
    assert doubts({name: rule.bound}) == [] == doubts({name: None}) == doubts({name: math.nan})
    (text,) = doubts({name: outside})
    assert text.startswith(rule.value) and rule.limit in text
    assert ("down to" in text) == rule.below


def test_reach_of_an_ellipse():
    """A groove whose depth is half its radius ends at 60 degrees, because cos 60 = 1 - 0.5."""
    shoulders = Shoulders(2 * (24e-3 + GROOVE / 2), 2 * (36.6e-3 - GROOVE / 2))
    a = np.array([GROOVE * math.sin(math.radians(20))])  # this extends 20 degrees to either side

    def judged(inner, outer):
        angles = tuple(np.radians([value]) for value in (inner, outer))
        return past_shoulder(BEARING, shoulders, angles, (a, a))

    assert judged(39.9, -39.9) == []
    (inner,) = judged(40.1, 0)
    assert inner == "the contact ellipse of the inner raceway reaches 60.1° up the groove; " + (
        "its shoulder is at 60.0°"
    )
    (outer,) = judged(0, -41)
    assert "outer raceway reaches 61.0°" in outer
    assert past_shoulder(BEARING, Shoulders(), (np.array([1.5]),) * 2, (a, a)) == []
    assert past_shoulder(BEARING, shoulders, (np.array([]),) * 2, (np.array([]),) * 2) == []


def test_statics_warns(tmp_path):
    assert operating_point.figures("6208", load=5000)["warnings"] == []
    found = operating_point.figures("6208", "mineral", load=5000, rpm=48)
    (conducts,) = found["warnings"]
    assert "beside a capacitance is down to 0.29" in conducts
    assert conducts in operating_point.table(found)
    high = operating_point.figures("6208", load=1000, axial=40e3)["warnings"]
    assert any("inner raceway reaches" in text for text in high)
    (pressure,) = operating_point.figures("6208", load=30e3)["warnings"]
    assert pressure.startswith("Hertz pressure is up to 4.6")


def test_a_shoulder_that_is_none(tmp_path):
    own = tmp_path / "own"

    text = catalogue.find("bearings", "6208", None).read_text()
    for value in ("47e-3", "70e-3"):
        own.write_text(
            text.replace(
                "inner_shoulder_diameter index 52.6e-3", f"inner_shoulder_diameter index {value}"
            )
        )
        with pytest.raises(InputError, match="inner_shoulder_diameter = .* must be between 0.048"):
            inputs.shoulders(own)


@pytest.mark.parametrize("name", ["static", "electric", "heat"])
def test_a_ring_held_along_its_axis(name, capsys):
    """For an angular contact bearing under a purely radial load, the text and JSON output of every
    command state the force that holds the ring. If this force is applied as an axial load, the ring
    is in equilibrium and there is no warning. For a deep groove ball bearing, there is no such
    force."""

    def said(*more):
        point = ["--rpm", "3000", "--lubricant", "vg46", "--load", "1000"]
        text = reply(capsys, [name, *point, *more])
        warnings = answer(capsys, [name, *point, *more])["warnings"]
        assert all(one in text for one in warnings)
        return [one for one in warnings if one.startswith("the balls push the inner ring along")]

    angular = ["--bearing", "7205B"]
    (text,) = said(*angular)
    force = {"N": 1.0, "kN": 1e3}[text.split()[11].strip(",")] * float(text.split()[10])
    # by the usual rule, the induced force is e F_r, with e of ISO 281 at 40 degrees
    assert 900 < force < 1.14e3
    assert said(*angular, "--axial", str(force)) == said() == []
