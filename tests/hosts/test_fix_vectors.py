# SPDX-License-Identifier: GPL-2.0-or-later
"""The vector of every fix ends with the last value of the table of values (C++ tables of columns)
that its page shows."""

import pytest
from host import ROOT, deck_file, named_bearing, refuses, succeed
from raceway import core

VECTORS = {k[4:]: len(rows) for k, rows in core.table("columns").items() if k.startswith("fix_")}
FIXES = {
    "cage": "fix cage cage bearing/cage b",
    "ring": "fix ring inner bearing/ring free loaded spin speed 100 load 1000 ramp 3.0e-3",
    "implicit": "fix implicit all bearing/implicit",
    "capacitance": "fix capacitance balls bearing/capacitance 1",
    "circuit": "fix circuit balls bearing/circuit 1 capacitance floating 9",
    "heat": "fix heat all bearing/heat cooling 2",
    "timestep": "fix timestep all bearing/timestep 100 exceed ignore",
}
DECK = "\n".join([named_bearing(), "create_bearing b speed 100 0", *FIXES.values(), "run 0\n"])
DRUM = (ROOT / "docs" / "decks" / "in.drum").read_text()


@pytest.mark.parametrize("name", VECTORS)
def test_vectors_and_pages(tmp_path, name):
    page = (ROOT / "docs" / f"fix_bearing_{name}.rst").read_text()
    assert f".. columns:: fix_{name}\n   :numbered:\n" in page
    deck, variables = (DECK, {}) if name in FIXES else (DRUM, {"rows": 2, "steps": 0})
    probe = f"variable value equal f_{name}[{{}}]\nprint ${{{{value}}}}\n"
    last, beyond = (deck + probe.format(VECTORS[name] + more) for more in (0, 1))
    succeed(deck_file(tmp_path, last), out=tmp_path / "drum", **variables)
    refuses(deck_file(tmp_path, beyond), "out-of-range", out=tmp_path / "drum", **variables)
