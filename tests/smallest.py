# SPDX-License-Identifier: GPL-2.0-or-later
"""Run docs/decks/in.smallest with other commands at its end."""

from host import ROOT, deck_file, liggghts

SMALLEST = (ROOT / "docs" / "decks" / "in.smallest").read_text()
IMPLICIT = (
    SMALLEST.replace(
        "fix move balls nve/sphere",
        "group all_of_it type 1 2 3\nfix move all_of_it bearing/implicit",
    )
    .replace("exceed stop", "exceed ignore")
    .replace("timestep 1.0e-6", "timestep 1.0e-5")
)
RUN = "run 20000\n"


def outcome(tmp_path, deck, commands, **kwargs):
    """Return the outcome of `deck` with its last run replaced by `commands`."""
    assert deck.count(RUN) == 1
    file = deck_file(tmp_path, deck.replace(RUN, commands))
    return liggghts(file, **kwargs)
