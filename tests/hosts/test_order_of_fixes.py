# SPDX-License-Identifier: GPL-2.0-or-later
"""The order of the fixes in a deck is checked where it matters, and has no effect otherwise."""

import re

import pytest
from host import ROOT, deck_file, refuses, succeed
from smallest import SMALLEST

FILM = (ROOT / "docs" / "decks" / "in.ehd").read_text()
RING = re.search(r"^fix inner .*\n", SMALLEST, re.MULTILINE).group()


@pytest.mark.parametrize("first", ["capacitance", "checkpoint"])
def test_a_checkpoint_that_samples_comes_after_the_capacitance(tmp_path, first):
    """In the opposite order, the checkpoint would average the capacitance of the previous
    sample."""
    fixes = {
        "capacitance": "fix cap balls bearing/capacitance 200 permittivity 2.25\n",
        "checkpoint": "variable total equal f_cap\n"
        f"fix keep all bearing/checkpoint 200 {tmp_path}/restart mean v_total\n",
    }
    old = fixes["capacitance"]
    assert FILM.count(old) == 1
    order = sorted(fixes, key=lambda name: name != first)
    deck = FILM.replace(old, "".join(fixes[name] for name in order)).replace("run 40000", "run 400")
    deck = deck_file(tmp_path, deck)
    if first == "capacitance":
        succeed(deck, out=tmp_path / "out")
    else:
        says = (
            "fix cap bearing/capacitance must come before fix keep bearing/checkpoint in the deck"
        )
        refuses(deck, says, out=tmp_path / "out")


@pytest.mark.parametrize("before", [True, False], ids=["before the ring fix", "after it"])
def test_the_report_of_a_ring_holds_contacts_alone(tmp_path, before):
    """A force that another fix adds to a ring is not included in the ball force, regardless of
    where that fix is in the deck."""
    push = "fix push inner addforce 0.0 0.0 7.0\n"
    deck = SMALLEST.replace(RING, push + RING if before else RING + push)
    deck = deck.replace(
        "run 20000\n", 'run 100\nvariable fz equal f_inner[13]\nprint "along ${fz}"\n'
    )
    end = succeed(deck_file(tmp_path, deck), out=tmp_path / "out")
    assert abs(float(re.search(r"^along (\S+)$", end.text, re.MULTILINE).group(1))) < 1e-3
