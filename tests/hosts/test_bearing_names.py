# SPDX-License-Identifier: GPL-2.0-or-later
"""A bearing with a name: the same numbers as the deck's data modules, and errors that help."""

import pytest
from host import run

OLD = """variable clearance index 0
variable four_point index 0
variable inputs index inputs
include ${inputs}/modules/bearing_data
variable contact_angle index 0
variable b_outer_raceway equal ${outer_radius}+0.5*${clearance}
variable b_half equal 1.3*${b_outer_raceway}
bearing_derive four_point
print "IS ${balls} ${ball_diameter} ${b_inner_raceway} ${inner_groove} ${outer_groove}"
print "IS ${b_outer_raceway} ${b_half} ${inner_mass} ${inner_inertia} ${cage_ball_diameter}"
"""
NEW = """variable bearing index 6208
variable clearance index 0
bearing b ${bearing} types 1 2 3 4 clearance ${clearance} vars inputs contact_angle four_point cage
print "IS ${b_balls} ${b_ball_diameter} ${b_inner_radius} ${b_inner_groove} ${b_outer_groove}"
print "IS ${b_outer_radius} ${b_box} ${b_inner_mass} ${b_inner_inertia} ${b_cage_ball_diameter}"
"""


def said(tmp_path, deck, **values):
    path = tmp_path / "in.deck"
    path.write_text(deck)
    done = run(path, **values)
    return done, [line for line in done.text.splitlines() if line[:3] == "IS "]


@pytest.mark.parametrize(
    "values",
    [
        {"bearing": "6208", "clearance": "1.1e-5"},
        {"bearing": "6208", "four_point": "35"},
        {"bearing": "6303", "clearance": "-7e-6"},
        {"bearing": "7205B"},
        {"bearing": "7208", "contact_angle": "25", "inner_mass": "0.3"},
    ],
    ids=lambda values: "-".join(values.values()),
)
def test_numbers_are_those_of_the_modules(tmp_path, values):
    old, before = said(tmp_path, OLD, **values)
    new, now = said(tmp_path, NEW, **values)
    assert old.code == new.code == 0, old.text[-500:] + new.text[-500:]
    assert len(now) == 2
    assert now == before


@pytest.mark.parametrize(
    ("values", "error"),
    [
        ({"bearing": "6280"}, "bearing: there is no '6280' in folder inputs/bearings"),
        ({"clearence": "1e-5"}, "-var clearence: the deck has no such variable, nearest is 'clear"),
        ({"clearance": "1"}, "bearing: clearance (m) is 1, must be from -0.001 to 0.001"),
        ({"clearance": "1e-5m"}, "'1e-5m'"),
        ({"four_point": "3"}, "four_point (degrees) is 3, must be from 5 to 60, or 0"),
        ({"contact_angle": "20"}, "contact_angle is 20, must be 0"),
        ({"bearing": "7208", "clearance": "1e-5"}, "clearance is 1e-05, must be from 0 to 0"),
        ({"ball_diameter": "12"}, "ball_diameter (m) is 12, must be from 0.0001 to 0.3"),
        ({"cage": "maybe"}, "cage is 'maybe', must be one of yes, no"),
    ],
    ids=lambda value: "" if isinstance(value, str) else "-".join(value),
)
def test_errors(tmp_path, values, error):
    done, _ = said(tmp_path, NEW, **values)
    assert done.code != 0
    assert error in done.text


@pytest.mark.parametrize(
    ("line", "error"),
    [
        ("bearing b 6208", "bearing: 'types BALLS CAGE INNER OUTER' is missing"),
        ("bearing b 6208 types 1 2 3 3", "balls, cage balls and both rings need their own"),
        ("bearing b 6208 types 1 2 3 4 vars load", "bearing: vars 'load', must be of: inputs,"),
        ("bearing b-1 6208 types 1 2 3 4", "the name 'b-1' must be of letters, digits and '_'"),
    ],
)
def test_errors_of_the_line(tmp_path, line, error):
    done, _ = said(tmp_path, line + "\n")
    assert done.code != 0
    assert error in done.text
