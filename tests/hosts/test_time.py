# SPDX-License-Identifier: GPL-2.0-or-later
"""Simulated time, and formulas that depend on it, continue across restarts and reset_timestep."""

import re

import numpy as np
import pytest
from host import BOX, deck_file, refuses, succeed
from recorded_runs import small
from smallest import SMALLEST

STEP = 1e-6
PAIR = """
pair_style bearing/hertz friction constant 0.1
pair_coeff 1 3 inner 24.0e-3 6.552e-3
pair_coeff 1 4 outer 36.6e-3 6.552e-3
"""
BEARING = f"""{PAIR}
create_bearing 1 none 3 4 balls 9 diameter 12.6e-3 speed 50.0 0
"""
MOVES = """
group balls type 1
group inner type 3
group outer type 4
variable w equal 50*(1+100*time)
variable sway equal 5.0e-6*sin(4000*time)
fix move balls nve/sphere
fix outer outer bearing/ring x position v_sway
fix inner inner bearing/ring mass 0.2 x free y free spin speed v_w force 0 -5000 0 ramp 3.0e-4
thermo 0
timestep 1.0e-6
"""
RUN = "run 500\n"
TELL = """
run 0
print "END $(time) $(f_outer[1]) $(f_inner[1]) $(f_inner[2]) $(f_inner[9]) $(x[4]) $(y[4])"
"""
READ = """
atom_style sphere
atom_modify map array sort 0 0.0
newton off
read_restart {}
neighbor 2.0e-3 bin
neigh_modify delay 0 every 20
"""


def end(tmp_path, host, *parts):
    """Return the time, the positions of the rings, and the position of a ball at the end of the
    deck."""
    deck = deck_file(tmp_path, "".join(parts) + TELL)
    line = next(x for x in succeed(deck, host=host).text.splitlines() if x.startswith("END "))
    return np.array(line.split()[1:], float)


@pytest.mark.parametrize("host", ["liggghts", "lammps", "wheel"])
def test_time_goes_on(host, tmp_path):
    begin = BOX + BEARING + MOVES + RUN
    whole = end(tmp_path, host, begin, RUN)
    near = {"rtol": 1e-12, "atol": 1e-16}  # the time is rounded where the step number is reset
    assert whole[0] == pytest.approx(1000 * STEP, rel=1e-12)
    assert whole[4] == pytest.approx(50 * (1 + 100 * whole[0]), rel=1e-9)
    for seam in ("reset_timestep 0\n", "reset_timestep 40000\n"):
        np.testing.assert_allclose(end(tmp_path, host, begin, seam, RUN), whole, **near)
    end(tmp_path, host, begin, f"write_restart {tmp_path}/kept\n")
    read = READ.format(tmp_path / "kept")
    np.testing.assert_array_equal(end(tmp_path, host, read, MOVES, RUN), whole)
    found = end(tmp_path, host, read, MOVES, "reset_timestep 0\n", RUN)
    np.testing.assert_allclose(found, whole, **near)


@pytest.mark.parametrize("host", ["liggghts", "lammps", "wheel"])
def test_step_numbers_do_not_change_the_motion(host, tmp_path):
    """Forces of the last step are restored after reset_timestep, too."""
    moves = MOVES.replace("50*(1+100*time)", "50").replace("5.0e-6*sin(4000*time)", "0")
    begin = BOX + BEARING + moves + RUN
    whole = end(tmp_path, host, begin, RUN)
    found = end(tmp_path, host, begin, "reset_timestep 7\n", RUN)
    np.testing.assert_array_equal(found[1:], whole[1:])


@pytest.mark.parametrize("host", ["liggghts", "lammps", "wheel"])
@pytest.mark.parametrize("again", ["", PAIR], ids=["pair style read", "pair style given"])
def test_a_restart_within_a_run_keeps_the_bits_of_the_time(again, host, tmp_path):
    """404 steps of 1e-6 s after a time of 500 such steps end 1 ulp later than 904 steps."""
    assert 500 * STEP + 404 * STEP != 904 * STEP
    tell = "variable after equal 1.0e20*(time-9.04e-4)\nrun 0\nprint 'END $(v_after)'\n"
    kept = f"restart 500 {tmp_path}/kept.*\nrun 904\n"
    times = []
    for text in (
        BOX + BEARING + MOVES + kept,
        READ.format(tmp_path / "kept.500") + again + MOVES + "run 904 upto\n",
    ):
        done = succeed(deck_file(tmp_path, text + tell), host=host)
        times.append(re.search(r"^END (.*)$", done.text, re.M)[1])
    assert times[0] == times[1]


@pytest.mark.parametrize("host", ["liggghts", "lammps", "wheel"])
def test_several_runs_keep_the_bits_of_the_time(host, tmp_path):
    """The hosts add up the durations of runs, so the time after several runs may differ from that
    after a single run in its last bit."""
    tell = "variable after equal 1.0e20*(time-9.04e-4)\nrun 0\nprint 'END $(v_after)'\n"
    times = set()
    begin = BOX + BEARING + MOVES
    read = READ.format(tmp_path / "kept")
    for text in (
        f"{begin}run 904\n",
        f"{begin}run 500\nrun 404\n",
        f"{begin}run 500\ntimestep 1.0e-6\nwrite_restart {tmp_path}/kept\nrun 404\n",
        f"{read}{MOVES}run 404\n",
        f"{read}{PAIR}{MOVES}run 100\nrun 304\n",
    ):
        done = succeed(deck_file(tmp_path, text + tell), host=host)
        times.add(re.search(r"^END (.*)$", done.text, re.M)[1])
    assert len(times) == 1


@pytest.mark.parametrize("mode, size", [("x", 4e-5), ("ry", 1e-3)])
@pytest.mark.parametrize("mover", ["nve/sphere", "bearing/implicit"])
def test_a_driven_ring_that_jumps(mode, size, mover, tmp_path):
    deck = tmp_path / "in.jump"
    start, sway = 2.0015e-4, "variable sway equal 5.0e-6*sin(4000*time)"
    jump = sway + f"+{size}*(time>{start})"
    text = (
        (BOX + BEARING + MOVES + RUN)
        .replace(sway, jump)
        .replace("outer bearing/ring x", f"outer bearing/ring {mode}")
    )
    if mover == "bearing/implicit":
        text = text.replace("fix move balls nve/sphere\n", "").replace(
            "thermo 0", "fix move all bearing/implicit\nthermo 0"
        )
    deck.write_text(text)
    says = f"fix outer bearing/ring: the position along {mode} jumps by "
    refuses(deck, says, "in step 201, with")
    deck.write_text(text.replace(jump, sway + f"+{size}*(time>{start})*(time-{start})/2.0e-4"))
    succeed(deck)  # the same change, applied gradually


@pytest.mark.parametrize("mover", ["nve/sphere", "bearing/implicit"])
def test_a_driven_ring_whose_speed_jumps(mover, tmp_path):
    deck = tmp_path / "in.jump"
    start, speed = 2.0015e-4, "variable w equal 50*(1+100*time)"
    text = BOX + BEARING + MOVES + RUN
    if mover == "bearing/implicit":
        text = text.replace("fix move balls nve/sphere\n", "fix move all bearing/implicit\n")
    deck.write_text(text.replace(speed, f"{speed}-5*(time>{start})"))
    says = "fix inner bearing/ring: the spin speed jumps by "
    refuses(deck, says + "4.99", "in step 201, with")
    deck.write_text(text.replace(speed, f"{speed}-5*(time>{start})*(time-{start})/2.0e-4"))
    succeed(deck)  # the same change, applied gradually
    deck.write_text(text + f"write_restart {tmp_path}/kept\n")
    succeed(deck)
    other = text[text.index("group balls") :].replace("50*(1", "60*(1")
    deck.write_text(READ.format(tmp_path / "kept") + other)
    refuses(deck, says + "10.5")  # the speed changes at the restart


@pytest.mark.parametrize("to", [0, 5000])
def test_a_record_has_no_gap(to, tmp_path):
    text = SMALLEST.replace("run 20000", f"run 1000\nreset_timestep {to}\nrun 1000")
    says = f"fix rec bearing/record: step {to} comes after step 1000"
    refuses(small(tmp_path, deck=text), says)


@pytest.mark.parametrize("integrator", ["damping", "vibration"])
def test_free_tilts_resume_to_the_same_bits(integrator, tmp_path):
    scene = {"integrator": integrator, "moment_x": 5, "models": "full", "record": "summary"}
    succeed(out=tmp_path / "whole", passes=2, deck="inputs/in.6208", **scene)
    succeed(out=tmp_path / "parts", passes=1, deck="inputs/in.6208", **scene)
    succeed(out=tmp_path / "parts", passes=2, deck="inputs/in.6208", resume="yes", **scene)
    whole, parts = (tmp_path / name / "record.nc" for name in ("whole", "parts"))
    assert whole.read_bytes() == parts.read_bytes()
