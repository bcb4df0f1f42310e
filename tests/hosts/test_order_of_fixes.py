# SPDX-License-Identifier: GPL-2.0-or-later
"""The order of the fixes in a deck has no effect on what they report."""

import re

import pytest
from host import deck_file, succeed
from smallest import SMALLEST

RING = re.search(r"^fix inner .*\n", SMALLEST, re.MULTILINE).group()


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
