# SPDX-License-Identifier: GPL-2.0-or-later
"""The options of an operating point accept one or more values in every command."""

import itertools

import pytest
from commands import answer, reply

OF = {
    "static": ["--lubricant", "vg46", "--bearing", "7208B"],
    "heat": [],
    "electric": ["--bearing", "6205"],
}
VALUES = {"load": ("200", "0.9kN"), "axial": ("300",), "rpm": ("900", "12000")}


@pytest.mark.parametrize("command", OF)
def test_several_values_are_the_points_one_by_one(capsys, command):
    """A command computes every combination of values in the order of the options. For a single
    point, the result is an object instead of a list."""
    given = [word for name, values in VALUES.items() for word in (f"--{name}", *values)]
    together = answer(capsys, [command, *OF[command], *given])
    options = [f"--{name}" for name in VALUES]
    points = (
        itertools.chain(*zip(options, point)) for point in itertools.product(*VALUES.values())
    )
    assert together == [answer(capsys, [command, *OF[command], *point]) for point in points]


def test_a_line_for_each_point(capsys):
    lines = reply(capsys, "static --load 200 0.9kN --rpm 900 12000").splitlines()
    assert [[*line.split()[:1], line.split()[2]] for line in lines[1:]] == [
        ["200", "900"],
        ["200", "12000"],
        ["900", "900"],
        ["900", "12000"],
    ]
