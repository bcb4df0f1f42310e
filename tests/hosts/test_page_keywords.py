# SPDX-License-Identifier: GPL-2.0-or-later
"""The syntax section on the page of a command names every keyword that the command accepts. An
unknown keyword makes a command print the list of those that it accepts."""

import re

import pytest
from host import ROOT, deck_file, named_bearing, run

SCENE = named_bearing() + "create_bearing b speed 100 0\n"
FILMS = SCENE + "fix cap balls bearing/capacitance 1 permittivity 2.2\n"
TOTALS = SCENE + "compute total all bearing/total\n"
# {page: the beginning of the deck, and the command without its keywords}
COMMANDS = {
    "bearing": ("", "bearing b 6208 types 1 2 3 4"),
    "create_bearing": (SCENE.split("create_bearing")[0], "create_bearing 1 2 3 4"),
    "fix_bearing_cage": (SCENE, "fix own cage bearing/cage 4"),
    "fix_bearing_cage_ring": (SCENE, "fix own cage bearing/cage/ring 1"),
    "fix_bearing_capacitance": (SCENE, "fix own balls bearing/capacitance 1"),
    "fix_bearing_checkpoint": (SCENE, "fix own all bearing/checkpoint 1 restart"),
    "fix_bearing_circuit": (FILMS, "fix own balls bearing/circuit 1 cap floating 1"),
    "fix_bearing_grains": (SCENE, "fix own all bearing/grains"),
    "fix_bearing_implicit": (SCENE, "fix own all bearing/vibration"),
    "fix_bearing_progress": (TOTALS, "fix own all bearing/progress 1 total"),
    "fix_bearing_record": (SCENE, "fix own all bearing/record 1 folder"),
    "fix_bearing_ring": (SCENE, "fix own inner bearing/ring"),
    "fix_bearing_shaft": (SCENE, "fix own inner bearing/shaft"),
    "fix_bearing_timestep": (SCENE, "fix own all bearing/timestep 1"),
    "run_bearing": (SCENE, "run_bearing"),
}


@pytest.mark.parametrize("page", COMMANDS)
def test_syntax_names_every_keyword(tmp_path, page):
    before, command = COMMANDS[page]
    outcome = run(deck_file(tmp_path, f"{before}{command} no_such_keyword 1\n"))
    known = re.search(r"'no_such_keyword'; known: (.*?) \(", outcome.error)[1].split(", ")
    text = (ROOT / "docs" / f"{page}.rst").read_text()
    syntax = re.search(r"\nSyntax\n-+\n(.*?)\n(?:Examples|Usage)\n-", text, re.DOTALL)[1]
    assert [word for word in known if not re.search(rf"\b{word}\b", syntax)] == []
