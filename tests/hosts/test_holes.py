# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of decks that change the input of an existing fix: groups that gain members, and rings that
belong to two fixes."""

import re

import pytest
from host import refused
from smallest import IMPLICIT, SMALLEST, outcome

INTEGRATORS = {"verlet": SMALLEST, "implicit": IMPLICIT}


@pytest.fixture(params=INTEGRATORS)
def deck(request):
    return INTEGRATORS[request.param]


@pytest.mark.parametrize("ranks", [1, 2])
def test_two_fixes_on_one_ring_are_refused(tmp_path, deck, ranks):
    """Under `fix bearing/implicit`, the second fix once silently replaced the first, and loads and
    displacements were wrong."""
    end = outcome(
        tmp_path, deck, "fix again inner bearing/ring spin speed 50\nrun 100\n", ranks=ranks
    )
    refused(end, r"fix again bearing/ring and fix inner bearing/ring both move ring atom 10")


def test_one_fix_after_another_on_one_ring(tmp_path, deck):
    end = outcome(
        tmp_path,
        deck,
        "run 20\nunfix inner\nfix again inner bearing/ring spin speed 50\n"
        "thermo_style custom step f_again[9]\nrun 20\n",
    )
    assert end.code == 0, end.text[-2000:]


@pytest.mark.parametrize("when", ["before the first run", "between two runs"])
def test_balls_may_not_join_the_group_of_a_ring_fix(tmp_path, deck, when):
    """Formerly, all atoms of such a group were assigned the mass of the ring, and the values
    reported for the ring were those of a ball."""
    first = "run 20\n" if when == "between two runs" else ""
    end = outcome(tmp_path, deck, first + "group inner type 1\nrun 100\n")
    refused(
        end,
        r"fix inner bearing/ring: atom \d of group inner is of type 1, which no pair_coeff names as"
        r" a ring",
    )


@pytest.mark.parametrize("ranks", [1, 2])
def test_a_ring_that_joins_the_group_is_reported(tmp_path, deck, ranks):
    """Formerly, the report had only as many rows as there were rings when the fix was created, and
    the fix wrote beyond the last row.

    In this test, the inner and outer rings form one group; the outer ring has a separate row, and
    moves.
    """
    end = outcome(
        tmp_path,
        deck,
        "group inner type 3\nrun 200\n"
        "variable a equal f_inner[1][9]\nvariable b equal f_inner[2][9]\n"
        "variable fa equal f_inner[1][12]\nvariable fb equal f_inner[2][12]\n"
        'print "spins ${a} ${b} forces ${fa} ${fb}"\n',
        ranks=ranks,
    )
    assert end.code == 0, end.text[-2000:]
    found = re.search(r"^spins (\S+) (\S+) forces (\S+) (\S+)$", end.text, re.MULTILINE)
    assert [float(s) for s in found.groups()[:2]] == pytest.approx([50.0, 50.0], rel=1e-9)
    inner, outer = (float(f) for f in found.groups()[2:])
    assert inner != outer


def test_a_second_bearing_joins_the_group(tmp_path, deck):
    """A second bearing is created after the fix, and its inner ring is added to the group."""
    wide = deck.replace("block -0.05 0.05", "block -0.05 0.3")
    second = (
        "create_bearing 1 none 2 3 balls 9 diameter 12.6e-3 speed 50.0 0 centre 0.2 0 0\n"
        "group inner type 2\ngroup balls type 1\n"
    )
    if "all_of_it" in wide:
        second += "group all_of_it type 1 2 3\n"
    end = outcome(
        tmp_path,
        wide,
        second + "run 200\nvariable a equal f_inner[1][12]\nvariable b equal f_inner[2][12]\n"
        'print "forces ${a} ${b}"\n',
        sanitized=False,
    )
    assert end.code == 0, end.text[-2000:]
    found = re.search(r"^forces (\S+) (\S+)$", end.text, re.MULTILINE)
    a, b = (float(f) for f in found.groups())
    assert a == pytest.approx(b, rel=1e-6) and a != 0.0


def test_rows_of_a_group_that_grew_wait_for_the_next_run(tmp_path, deck):
    """Until the next run begins, the report still describes the rings of the previous run."""
    end = outcome(
        tmp_path,
        deck,
        "run 20\nvariable a equal f_inner[1][9]\ngroup inner type 3\n"
        'print "spin ${a}"\nrun 20\nvariable b equal f_inner[2][9]\nprint "outer ${b}"\n',
    )
    assert end.code == 0, end.text[-2000:]
    assert re.search(r"^spin 50(\.0*)?$", end.text, re.MULTILINE)
    assert re.search(r"^outer 50(\.0*)?$", end.text, re.MULTILINE)
