# SPDX-License-Identifier: GPL-2.0-or-later
"""Restart files from a different run or a different build are rejected with a message that states
the reason."""

import pytest
from host import refused, refuses, run, succeed
from hosts.test_time import BEARING, BOX, MOVES, READ, RUN

HOSTS = ["liggghts", "lammps", "wheel"]
RISING = "variable rising equal 50*(1+v_share*time)\nvariable share equal v_base\n"
RISING += "variable base index 100\n"
SCENE = MOVES.replace("50*(1+100*time)", "v_rising")
MORE = {
    "as before": "",
    "one value": "variable share equal 100.5\n",
    "the same value now": "variable share equal 100*(1+step-500)\n",
    "an index": "variable base delete\nvariable base index 101\n",
    "not of the run": "variable other equal 7\n",
}
REFUSED = {
    "one value": "variable share = 100.5",
    "the same value now": "variable share = 100*(1+step-500)",
    "an index": "variable base = 101",
}


@pytest.mark.parametrize("host", HOSTS)
def test_formulas(host, tmp_path):
    """A run must be continued with the formulas with which it began. This includes the formulas of
    variables that appear only in other formulas."""
    deck, kept = tmp_path / "in.deck", tmp_path / "kept"
    keep = f"fix keep all bearing/checkpoint 100 {tmp_path}/run"
    deck.write_text(BOX + BEARING + RISING + SCENE + f"{keep}\n{RUN}write_restart {kept}\n")
    succeed(deck, host=host)
    read = READ.format(kept)
    for name, more in MORE.items():
        deck.write_text(read + RISING + more + SCENE + f"{keep} resume yes\n{RUN}")
        if name in REFUSED:
            refuses(deck, "belongs to another run", REFUSED[name], host=host)
        else:
            succeed(deck, host=host)


@pytest.mark.parametrize("host", HOSTS)
def test_builds(host, tmp_path):
    """Restart files contain a number for their layout, which is missing in files written by earlier
    builds."""
    deck, kept = tmp_path / "in.deck", tmp_path / "kept"
    deck.write_text(BOX + BEARING + MOVES + RUN + f"write_restart {kept}\n")
    succeed(deck, host=host)
    whole, mark = kept.read_bytes(), b"Raceway\0"
    assert whole.count(mark) == 1
    at = whole.index(mark)
    number = at + len(mark)
    layout = int.from_bytes(whole[number : number + 4], "little")
    assert layout > 1
    deck.write_text(READ.format(kept))
    for content, cause in (
        (whole[:number] + b"\1" + whole[number + 1 :], "has layout 1 and was written by another"),
        (whole[:at] + whole[number + 4 :], "has no layout number and was written by another build"),
    ):
        kept.write_bytes(content)
        says = f"pair_style bearing: the restart file {cause}"
        refuses(deck, says, f"this program reads layout {layout}", host=host)
    claims = whole[: number + 4] + b"\xff\xff\xff\x7f" + whole[number + 8 :]
    for content in (whole[: number + 8], whole[: number - 2], claims):
        kept.write_bytes(content)
        # the latest release of LAMMPS checks the end of the file before the styles read it
        refused(run(deck, host=host), "is damaged|Incomplete or corrupted")
