# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of the results from statics that are given next to those of a run: their operating point,
how far runs deviate from them, and cases in which statics gives no results."""

import json
import math
import re

import numpy as np
import pytest
from commands import reply
from host import ROOT, deck_file, named_bearing, run, succeed
from raceway.runs.statics import statics
from raceway.runs.summary import summary
from raceway.runs.tables import RunTables
from raceway.theory.ball_pass import places

OIL = dict(lubricant="vg46", temperature=60)
POINT = dict(load=3000, axial=1500, rpm=1500, **OIL)
SHORT = dict(passes=1, samples=20)


def beside(folder, bearing=None):
    """Return (results of the run, results of statics, reason why there are no results of
    statics)."""
    tables = RunTables(folder, bearing=bearing)
    figures = summary(tables)
    found = statics(tables, figures)
    return figures, found["statics"], found["statics_absent"]


@pytest.mark.parametrize("azimuth", [-math.pi / 2, 0.7])
def test_the_point_of_the_run(tmp_path, capsys, azimuth):
    """At the same operating point, `raceway static` gives the same results for any direction of the
    load; moment and tilt rotate with the load."""
    moment = 12.0
    words = dict(moment_x=-moment * math.sin(azimuth), moment_y=moment * math.cos(azimuth))
    out = tmp_path / "run"
    succeed("inputs/in.6208", out=out, load_azimuth=azimuth, **POINT, **words, **SHORT)
    _, found, why = beside(out)
    assert why is None
    options = "--load 3000 --axial 1500 --rpm 1500 --lubricant vg46 --temperature 60"
    options += f" --moment 0 {moment} --models paper --exact-circle --json --phase"
    found_there = []
    for phase in places(9, 2).tolist():  # all balls carry load
        found_there.append(json.loads(reply(capsys, ["static", *options.split(), repr(phase)])))

    def mean(key):
        return np.mean([one[key] for one in found_there])

    assert found["cage_speed_rad_s"] == pytest.approx(mean("orbital_speed_rad_s"), rel=1e-12)
    assert found["ring_shift_m"] == pytest.approx(mean("shift_x_m"), rel=1e-9)
    for key in ("capacitance_F", "shift_z_m"):
        assert found[key] == pytest.approx(mean(key), rel=1e-9)
    for key in ("q_inner_max_N", "p_max_outer_Pa"):
        assert found[key] == pytest.approx(max(one[key] for one in found_there), rel=1e-9)
    tilt = np.array([mean("tilt_x_rad"), mean("tilt_y_rad")])
    turn = np.array([[np.cos(azimuth), -np.sin(azimuth)], [np.sin(azimuth), np.cos(azimuth)]])
    own = [found["tilt_x_rad"], found["tilt_y_rad"]]
    np.testing.assert_allclose(own, turn @ tilt, rtol=0, atol=1e-9 * np.abs(tilt).max())
    assert azimuth == 0.7 or own[1] == 0  # not a rounding error


CASES = {
    "radial": dict(load=3000, rpm=1500, clearance=1e-5),
    "thrust": dict(bearing="7208", load=0.1, axial=-2000, rpm=600),
    "combined": dict(bearing="6208", load=3000, axial=2000, rpm=600),
    "held": dict(bearing="7205B", load=1000, rpm=1000),
    "four points": dict(load=2000, rpm=477.5, four_point=35),
    "film": dict(load=1000, rpm=1500, models="film"),
}


@pytest.mark.parametrize("case", CASES)
def test_runs_are_near(tmp_path, case):
    """Loads, films and cage speed of settled runs agree within 1 %. With four positions of the
    balls, the largest load is accurate to 0.7 % and the mean capacitance to 0.5 %. If a ring is
    held along its axis, contact angles vary around the ring, and so do the speeds of the balls;
    statics uses the mean of these speeds, which is 1.2 % higher than the cage speed of the run."""
    words = {"models": "full", **OIL, **CASES[case]}
    settle = 2 if case == "four points" else 20
    succeed("inputs/in.6208", out=tmp_path, settle=settle, passes=1, samples=40, **words)
    own, found, why = beside(tmp_path)
    assert why is None
    keys = {"q_inner_max_N", "q_outer_max_N", "h_min_m", "lambda", "cage_speed_rad_s"}
    keys |= {"capacitance_F", "p_max_inner_Pa"}
    assert keys <= set(found)
    for key in keys:
        apart = 0.015 if (case, key) == ("held", "cage_speed_rad_s") else 0.01
        assert found[key] == pytest.approx(own[key], rel=apart), key
    assert ("friction_torque_N_m" in found) == (case != "film")


@pytest.mark.parametrize("balls", [3, 5])
def test_few_balls(tmp_path, balls):
    """The load is carried by one or two balls, so that the results depend on their positions. With
    four positions in statics, the capacitance would be 3 % too small."""
    bearing = tmp_path / "few"
    text = (ROOT / "inputs/bearings/6208").read_text()
    bearing.write_text(re.sub(r"(variable balls +index) 9", rf"\1 {balls}", text))
    words = dict(OIL, models="film", cage="no", load=1000, rpm=477.5, clearance=2e-5)
    out = tmp_path / "run"
    succeed("inputs/in.6208", out=out, bearing=bearing, settle=4, passes=2, samples=100, **words)
    own, found, why = beside(out)
    assert why is None
    for key in ("ring_shift_m", "capacitance_F"):
        assert found[key] == pytest.approx(own[key], rel=0.01), key


def test_a_shaft_that_turns_backwards(tmp_path):
    """A bearing that is symmetric about the load's plane has the same results, but for the sign of
    the cage's speed, which is that of the shaft's."""
    deck = tmp_path / "in.backwards"
    text = (ROOT / "inputs/in.6208").read_text()
    deck.write_text(text.replace("variable b_omega equal 2*", "variable b_omega equal -2*"))
    both = []
    for name in (ROOT / "inputs/in.6208", deck):
        out = tmp_path / str(len(both))
        succeed(name, out=out, settle=20, models="full", **POINT, **SHORT)
        own, found, why = beside(out)
        assert why is None
        assert found["cage_speed_rad_s"] == pytest.approx(own["cage_speed_rad_s"], rel=0.01)
        both.append(found)
    forth, back = both
    assert forth.pop("cage_speed_rad_s") == pytest.approx(-back.pop("cage_speed_rad_s"), rel=1e-12)
    assert forth == pytest.approx(back, rel=1e-9)


def test_two_bearings_on_a_shaft(tmp_path):
    """Each of two named bearings has its own data and its own oil. Statics holds each ring at the
    position measured in the run, even if the ring slides along the axis."""
    done = run("docs/decks/in.two_bearings", out=tmp_path, models=None, settle=None)
    assert done.code == 0, done.error
    names = []
    for bearing in (1, 2):
        own, found, why = beside(tmp_path, bearing)
        assert why is None
        names.append((own["bearing"], own["lubricant"]))
        for key in ("q_inner_max_N", "cage_speed_rad_s", "h_min_m", "friction_torque_N_m"):
            assert found[key] == pytest.approx(own[key], rel=0.025), key
        assert "shift_z_m" not in found
    assert names == [("6208", "vg46"), ("6306", "grease110")]


PAIR = (
    named_bearing("7205B", clearance=0, sides="-0.06 0.06 -0.06 0.06 -0.05 0.15")
    + """
create_bearing b speed 314.0 0 thrust 300
create_bearing b centre 0 0 0.1 speed 314.0 0 thrust -300
fix rails cage bearing/cage b
group right id 52
fix spring right bearing/ring mass 0.1 z free force 0 0 300 support z 1.0 2000 ramp 3.0e-3
fix shaft inner bearing/shaft mass 1 inertia 1.0e-4 5.0e-3 x free y free z free rx free ry free &
  spin speed 314.0 ramp 3.0e-3 load 0.03 800 0 0 support z 1.0 2000
fix move all bearing/implicit
fix record all bearing/record pass/40 ${out} overwrite yes
run_bearing settle 10 passes 1
"""
)


def test_preloaded_pair(tmp_path):
    """Rings of angular contact bearings start where their balls touch both raceways. Statics counts
    this displacement along the axis once. In the first bearing the balls that carry little load
    have not settled."""
    deck = deck_file(tmp_path, PAIR)
    done = run(deck, out=tmp_path, models=None, settle=None)
    assert done.code == 0, done.error
    for bearing in (1, 2):
        own, found, why = beside(tmp_path, bearing)
        assert why is None
        for key in ("ring_shift_m", "q_inner_max_N", "q_outer_max_N", "p_max_inner_Pa", "h_min_m"):
            assert found[key] == pytest.approx(own[key], rel=0.05), key


NONE = {
    "the load rotates": dict(unbalance=1e-4),
    "raceways or balls have flaws": dict(flaw_inner="wave 8 1e-8 0"),
    "the run has its own data: ball_poisson=0.29": dict(ball_poisson=0.29),
    "statics has no equivalent of -var without drag": dict(models="full", without="drag"),
    "statics has no equivalent of models none": dict(models="none"),
    "temperatures follow the losses of the run": dict(
        models="full", heat="yes", lubricant="vg46", rpm=1910
    ),
}


@pytest.mark.parametrize("why", NONE)
def test_none(tmp_path, why, capsys):
    succeed("inputs/in.6208", out=tmp_path, **{**SHORT, **NONE[why]})
    _, found, said = beside(tmp_path)
    assert not found and said == why
    assert f"not available for this run: {why}" in reply(capsys, ["summary", str(tmp_path)])


def test_speed_that_changes(tmp_path):
    done = run(ROOT / "docs/decks/in.run_up", out=tmp_path, models=None, settle=None, timeout=600)
    assert done.code == 0, done.error
    assert beside(tmp_path)[2] == "the speed changes"
