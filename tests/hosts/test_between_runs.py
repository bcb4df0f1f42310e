# SPDX-License-Identifier: GPL-2.0-or-later
"""What happens to forces and reports around the boundary of two runs."""

import pytest
from host import ROOT, frames, succeed

BITS = (ROOT / "tests" / "hosts" / "in.bits").read_text()
DRAG = "fix drag balls viscous 5.0\n"


def test_a_fix_defined_between_runs_adds_no_impulse(tmp_path):
    """Forces of the step before are put back after the set-up of every fix, also of one that is younger."""
    deck = tmp_path / "in.drag"
    deck.write_text(BITS.replace("timestep 2.0e-7\n", DRAG + "timestep 2.0e-7\n"))
    succeed(deck, out=tmp_path / "whole")
    deck.write_text(deck.read_text() + "unfix drag\n" + DRAG + "run 200\n")
    succeed(deck, out=tmp_path / "two", first=200)
    assert frames(tmp_path / "two" / "balls.dump")[400] == frames(tmp_path / "whole" / "balls.dump")[400]


def test_report_is_of_the_end_of_the_step(tmp_path):
    """Also when a variable that drives a ring asks for the ring's own report in the middle of the step."""
    deck = tmp_path / "in.report"
    deck.write_text(BITS.replace("timestep 2.0e-7\n", (
        "variable vy_now equal f_inner[5]\n"
        "variable push equal 1.0e-3*v_vy_now\n"  # N, nothing next to the load
        f"fix outer outer bearing/ring force v_push 0 0\n"
        "variable vy equal f_inner[5]\n"
        "variable x equal f_inner[1]\n"
        'fix report all print 20 "${n} ${x} ${vy}" file ${out}/report.txt screen no\n'
        "timestep 2.0e-7\n")))
    succeed(deck, out=tmp_path)
    dumped = frames(tmp_path / "balls.dump")
    rows = [line.split() for line in (tmp_path / "report.txt").read_text().splitlines()[1:]]
    assert len(rows) == 20
    for step, x, vy in rows:
        ring = next(row.split() for row in dumped[int(step)] if row.startswith("19 "))
        assert float(x) == pytest.approx(float(ring[1]), rel=1e-12)  # the ring started at the origin
        assert float(vy) == pytest.approx(float(ring[5]), rel=1e-12)
