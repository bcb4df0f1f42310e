# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of the three cage options for a bearing: a chain of balls, a single rigid ring, or no
cage."""

import numpy as np
import pytest
from host import BOX, deck_file, refuses, succeed
from raceway.runs.run import Run
from raceway.runs.settings import deck_words

SHORT = {"passes": 1, "settle": 1, "samples": 20, "record": "all"}
# (variables of the main deck, cage that the run then has)
CAGES = [
    ({}, "chain"),
    ({"models": "full"}, "ring"),
    ({"models": "film"}, "chain"),
    ({"models": "full", "lubricant": "dry"}, "chain"),
    ({"models": "full", "integrator": "verlet"}, "chain"),
    ({"models": "full", "pocket_play": 3e-5}, "chain"),
    ({"models": "full", "cage": "chain"}, "chain"),
    ({"models": "paper", "cage": "chain"}, "chain"),
    ({"models": "paper", "cage": "ring"}, "ring"),
    ({"models": "full", "cage": "ring"}, "ring"),
    ({"models": "full", "cage": "no"}, "no"),
]


def cage_of(folder):
    """Return the type of cage (ring, chain or no), determined from the bodies in a record."""
    record = Run(folder).tables.record
    if 2 in record.fixed("ring_raceway"):
        return "ring"
    return "chain" if "cage_x" in record.variables else "no"


@pytest.mark.parametrize(
    "words, cage", CAGES, ids=lambda value: value if isinstance(value, str) else "-".join(value)
)
def test_main_deck(tmp_path, words, cage):
    """The record states the type of cage, so that a repeated run has the same cage."""
    succeed("inputs/in.6208", out=tmp_path, **{**SHORT, **words})
    assert cage_of(tmp_path) == cage
    assert deck_words(Run(tmp_path).settings)["cage"] == cage


DECK = "variable bearing index 6208\n{}\nprint 'IS ${{b_cage_style}} ${{b_inner_atom}}'\n"
LINES = {
    "bearing b ${bearing} types 1 2 3 4": "cage 19",
    "bearing b ${bearing} types 1 2 3 4 cage chain": "cage 19",
    "bearing b ${bearing} types 1 2 3 4 cage ring": "cage/ring 10",
    "bearing b ${bearing} types 1 2 3 4 cage no": "cage 10",
}


@pytest.mark.parametrize("line", LINES)
def test_command(tmp_path, line):
    deck = deck_file(tmp_path, DECK.format(line))
    assert f"IS {LINES[line]}" in succeed(deck).text


@pytest.mark.parametrize(
    "words, says",
    [
        (
            {"cage": "ring", "cage_ball_diameter": 8e-3},
            "cage_ball_diameter belongs to a cage of balls",
        ),
        (
            {"cage": "ring", "bearing": "6303", "pocket_play": 1e-4},
            "pocket_play belongs to a cage of balls",
        ),
        ({"cage": "chain", "cage_play": 1e-4}, "cage_play belongs to bearing/cage/ring"),
        ({"models": "paper", "cage_play": 1e-4}, "cage_play belongs to bearing/cage/ring"),
        ({"cage": "no", "cage_mass": 0.01}, "cage_mass belongs to bearing/cage/ring"),
        ({"cage_guide": "outer"}, "cage_guide outer needs cage_land"),
        ({"cage_guide": "inner", "cage_land": 26e-3}, "cage_guide inner needs cage_clearance"),
    ],
    ids=lambda value: "" if isinstance(value, str) else "-".join(value),
)
def test_data_of_another_cage(tmp_path, words, says):
    words = {**SHORT, "models": "full", **words}
    refuses("inputs/in.6208", says, out=tmp_path / "run", **words)
    assert not (tmp_path / "run" / "record.nc").exists()


NAMED = """bearing b 6208 types 1 2 3 4 {}
{}
pair_style bearing oil mineral models full
pair_coeff * * b
create_bearing b speed 50 0
fix cage cage bearing/cage b
"""


def test_a_chain_for_a_ring_is_refused(tmp_path):
    succeed(deck_file(tmp_path, NAMED.format("", BOX)))
    deck = deck_file(tmp_path, NAMED.format("cage ring", BOX))
    refuses(deck, "is a ring: use fix bearing/${NAME_cage_style}")


def test_first_balls_of_many_bearings(tmp_path):
    """In a grid of bearings, every cage starts with a pocket at the first ball of its bearing. A
    ball starts in the middle of its pocket and does not cross half the play (0.16 mm) within 2
    ms, so without a squeeze film there is no force."""
    words = {
        "bearings": 5,
        "columns": 3,
        "time": 2e-3,
        "record": "all",
        "phase": 0.2,
        "cage": "ring",
        "cage_without": "film",
    }
    succeed("inputs/in.many", out=tmp_path, **words)
    whole = Run(tmp_path)
    for number in whole.bearing_numbers:
        figures = whole.select(number).tables.record
        force = figures.read(["ball_pocket_force"])["ball_pocket_force"]
        assert (force == 0.0).all()


def test_a_first_ball_elsewhere_goes_on(tmp_path):
    """In a continued run, the pockets are at the same positions as in the first run."""
    words = {**SHORT, "models": "full", "cage": "ring", "phase": 0.3, "resume": "yes"}
    for folder, passes in (("whole", (2,)), ("parts", (1, 2))):
        for number in passes:
            succeed("inputs/in.6208", out=tmp_path / folder, **{**words, "passes": number})
    one, other = (Run(tmp_path / name).tables.record for name in ("whole", "parts"))
    for name in ("ring_angle", "ring_x", "ball_x", "ball_pocket_force"):
        np.testing.assert_array_equal(one.read([name])[name], other.read([name])[name])
