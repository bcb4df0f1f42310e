# SPDX-License-Identifier: GPL-2.0-or-later
"""Run short versions of the main deck and of decks in docs/decks, i.e. scenes that every reader of
records must handle."""

from host import ROOT, succeed

RECORD = "fix record all bearing/record {} ${{out}} overwrite yes\nrun {}"
SPEED = "2*PI*1500/60"
OUTER = "fix outer outer bearing/ring mass 2 x free"
TURNING = [
    (SPEED, "{0}\nvariable other equal {1}"),
    ("speed ${speed} 0", "speed ${speed} ${other}"),
    (OUTER, OUTER.replace("mass 2", "mass 2 spin speed ${other}")),
    ("run 2000", "run 500"),
]
FLOODED = {"surroundings": "flooded", "record": "all"}
RING = {"cage": "ring", "models": "full", "record": "all"}


def _turning(inner, outer):
    """Return changes to the text of in.spall that set other ring speeds, in rad/s."""
    return [(old, new.format(inner, outer) if "{0}" in new else new) for old, new in TURNING]


SCENES = {  # deck, and changes to its text or its variables
    "radial": ("in.6208", {"passes": 3, "samples": 60, "load": 3000, "record": "all"}),
    "combined": ("in.combined", [("run 2000", "run 600")]),
    "whirl": ("in.unbalance", [("run 2000", "run 500")]),
    "ramp": ("in.run_up", [("run 15000", "run 1600"), (" content summary", "")]),
    "reversed": ("in.spall", _turning(-157, 0)),
    "outer": ("in.spall", _turning(0, 157)),
    "rows": ("in.double_row", [("run 1000", "run 700\n" + RECORD.format(5, 300))]),
    "circuit": ("in.6208", {"passes": 1, "samples": 150, "rpm": 1500} | FLOODED),
    "both": ("in.spall", _turning(150, -60)),
    "arch": ("in.four_point", [("run 1600", RECORD.format(8, 1600))]),
    "caged": ("in.6208", {"passes": 1, "samples": 60, "axial": 500, "moment_x": 2} | RING),
}


def run(name, folder):
    """Run the scene `name` in `folder`, unless this has already been done, and return the
    folder."""
    deck, changes = SCENES[name]
    if isinstance(changes, dict):
        succeed(f"inputs/{deck}", out=folder, **changes)
        return folder
    own = folder.with_suffix(".deck")
    own.write_text(changed(deck, changes))
    succeed(own, out=folder)
    return folder


def changed(deck, changes):
    """Return the text of a deck in docs/decks after all changes (old, new) have been made."""
    text = (ROOT / "docs" / "decks" / deck).read_text()
    for old, new in changes:
        assert old in text, (deck, old)
        text = text.replace(old, new)
    return text
