# SPDX-License-Identifier: GPL-2.0-or-later
"""Every deck in inputs and docs/decks runs; decks with the variable `models` run with both the
value paper and the value full. The structure of the decks is checked, too."""

import re

import pytest
from host import ROOT, succeed
from raceway.sweeps.points import TableError, deck_variables

DECKS = [
    str(path.relative_to(ROOT))
    for folder in ("inputs", "inputs/paper", "docs/decks")
    for path in sorted((ROOT / folder).glob("in.*"))
]
SHORT = {"passes": 1, "settle": 0, "samples": 40, "bearings": 2, "time": "1e-3", "rpm": 3000}
DRUM = {"rows": 4, "bottom": -0.0915, "steps": 600}  # the run in docs/gallery.rst is longer
ALONE = [deck for deck in DECKS if not re.search("partition|restart_2_read", deck)]


def takes(deck):
    try:
        return deck_variables(ROOT / deck)
    except TableError:  # the deck has no variables
        return {}


@pytest.mark.parametrize(
    ("deck", "models"),
    [
        (deck, models)
        for deck in ALONE
        for models in (("paper", "full") if "models" in takes(deck) else (None,))
    ],
)
def test_runs(tmp_path, deck, models):
    short = DRUM if deck.endswith("in.drum") else SHORT
    words = {name: value for name, value in short.items() if name in takes(deck)}
    out = {"out": tmp_path / "run"} if "out" in takes(deck) else {}
    succeed(deck, models=models, **out, **words)


def test_include_files():
    """Decks include only other decks, and use conditions only to choose between a new box and a
    restart file."""
    for deck in DECKS:
        text = (ROOT / deck).read_text()
        included = re.findall(r"^include (\S+)", text, re.M)
        assert all(re.search(r"/in\.[^/]*$", name) for name in included), (deck, included)
        if deck.startswith("inputs/") and "if " in text:
            conditions = re.findall(r'^if "(.*?)"', text, re.M)
            assert len(conditions) <= 1 or deck == "inputs/in.many", (deck, conditions)


def test_number_of_commands():
    """The package adds at most six commands in addition to the styles."""
    text = (ROOT / "src-package/host/bearing_styles.h").read_text()
    assert len(re.findall(r"add\.template command<", text)) <= 6
