# SPDX-License-Identifier: GPL-2.0-or-later
"""Decks specify a bearing by name: its data are found, and error messages state how to fix a
mistake."""

import pytest
from host import deck_file, refuses, succeed

DECK = """variable bearing index 6208
variable clearance index 0
bearing b ${bearing} types 1 2 3 4 clearance ${clearance} vars inputs contact_angle four_point cage
print "IS ${b_balls} ${b_ball_diameter} ${b_inner_radius} ${b_inner_groove} ${b_outer_groove}"
print "IS ${b_outer_radius} ${b_box} ${b_inner_mass} ${b_inner_inertia} ${b_cage_ball_diameter}"
"""


# values that earlier decks computed by formulas: number of balls, ball diameter, inner radius,
# inner and outer groove; outer radius, half the width of a box, mass and inertia of the inner ring,
# and diameter of a cage ball
NUMBERS = {
    ("6208", "clearance", "1.1e-5"): (
        "9 12.6e-3 24.0e-3 6.552e-3 6.552e-3",
        "0.0366055 0.04758715 0.2 1.2e-4 8.38e-3",
    ),
    ("6208", "four_point", "35"): (
        "9 12.6e-3 0.0239544263151608 6.552e-3 6.552e-3",
        "0.0366455736848392 0.04758 0.2 1.2e-4 8.38e-3",
    ),
    ("6303", "clearance", "-7e-6"): (
        "7 8.731e-3 0.0116345 0.00454012 0.00462743",
        "0.020362 0.0264706 0.0350439632298763 4.32180638430366e-06 0.00542033977320412",
    ),
    ("7205B", "clearance", "0"): (
        "12 7.938e-3 0.0152438572157896 0.00412776 0.00420714",
        "0.0232747141763156 0.0302571284292103 0.0447434214731118 9.71444183303034e-06"
        " 0.00203251680094397",
    ),
    ("7208", "contact_angle", "25"): (
        "13 11.9e-3 0.0240277012533147 0.006188 0.006307",
        "0.0359834481200279 0.0467784825560363 0.3 0.000162727989553161 0.00246440163063876",
    ),
}


@pytest.mark.parametrize("case", NUMBERS, ids="-".join)
def test_numbers(tmp_path, case):
    bearing, name, value = case
    more = {"inner_mass": "0.3"} if bearing == "7208" else {}
    done = succeed(deck_file(tmp_path, DECK), bearing=bearing, **{name: value}, **more)
    now = [line[3:] for line in done.text.splitlines() if line[:3] == "IS "]
    assert tuple(now) == NUMBERS[case]


@pytest.mark.parametrize(
    ("line", "error"),
    [
        ("bearing b 6208", "bearing: 'types BALLS CAGE INNER OUTER' is missing"),
        ("bearing b 6208 types 1 2 3 3", "balls, cage balls and both rings need their own"),
        ("bearing b 6208 types 1 2 3 4 vars lod", "bearing: vars 'lod', must be one of: inputs,"),
        (
            "variable load index 5\nbearing b 6208 types 1 2 3 4 vars load",
            "bearing: variable load belongs to bearing/ring: leave it out here",
        ),
        (
            "bearing b-1 6208 types 1 2 3 4",
            "the name 'b-1' must consist of letters, digits and '_'",
        ),
    ],
)
def test_errors_of_the_line(tmp_path, line, error):
    refuses(deck_file(tmp_path, line + "\n"), error)
