# SPDX-License-Identifier: GPL-2.0-or-later
"""A run that is stopped while it settles can be continued from any step with bitwise identical
results. Decisions are due at the ends of ball passes, so steps next to them are the hard cases."""

import re

import pytest
from host import ROOT, deck_file, same_files, succeed
from recorded_runs import differ

from scenarios.test_run_bearing import DECK, IMPLICIT, TURNS, numbers

WITHIN = 10  # samples per host step
TIMES = {"processor_s", "wall_s"}  # attributes that no two runs share
MAIN = "inputs/in.6208"
WARM = {"heat": "yes", "models": "full", "rpm": 3000, "lubricant": "vg46", "passes": 1}
WARM |= {"dumps": "yes", "within": WITHIN}
DUMPS = ("contacts.dump", "balls.dump", "rings.dat")
SCENES = {
    "auto": (DECK, {**IMPLICIT, "settle": "auto"}),
    "orbit": (DECK, {**TURNS, "settle": "orbit", "more": "limit 5"}),
    "number": (DECK, {**IMPLICIT, "settle": 3}),
    "heat": (MAIN, {**WARM, "settle": 1}),
    "heat, auto": (MAIN, {**WARM, "settle": "auto"}),
}


@pytest.mark.parametrize("name", SCENES)
def test_bits(name, tmp_path):
    deck, scene = SCENES[name]
    end = "/restart balance inner"
    text = (ROOT / deck).read_text().replace(end, f"{end} last ${{last}}")
    deck = deck_file(tmp_path, "variable last index yes\n" + text)
    whole = tmp_path / "whole"
    text = succeed(deck, out=whole, **scene).text
    *settling, measured = (int(steps) for steps in re.findall(r" for (\d+) steps with", text))
    ends = [sum(settling[: k + 1]) for k in range(len(settling))]
    stops = {end + more for end in ends[-3:] for more in (-1, 0, 1)}
    # the only multiple of such a step at which a restart file is written is the step itself
    alone = [step for step in stops if max(ends[-1] / 2, measured) < step <= ends[-1]]
    assert len(alone) >= 2
    for step in alone:
        out = tmp_path / str(step)
        stopped = {**scene, "keep": step * WITHIN}
        succeed(deck, out=out, last="no", **stopped)
        for result in ("record.nc", "run.yaml"):
            (out / result).unlink(missing_ok=True)
        text = succeed(deck, out=out, resume="yes", **stopped).text
        assert "Continuing from" in text
        assert differ(whole, out) == [], step
        same_files(out, whole, *(DUMPS if "dumps" in scene else ()))
        one, other = numbers(whole), numbers(out)
        assert {k for k, v in one.items() if v != other[k]} <= TIMES, step
