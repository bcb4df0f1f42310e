# SPDX-License-Identifier: GPL-2.0-or-later
"""Results of a run do not depend on runs before it in the same deck, nor on the order in which
bearings are defined."""

import math
import re

import numpy as np
import pytest
import raceway
from host import deck_file, frames, named_bearing, succeed
from scipy.io import netcdf_file

BEARING = named_bearing(oil="vg46 temperature 40", neighbor="${{b_skin}} bin")
DECK = (
    BEARING
    + """
create_bearing b speed {speed} 0 phase 0.1
fix rails cage bearing/cage b
fix inner inner bearing/ring free loaded spin speed {speed} load {load} ramp 3.0e-3
fix move all bearing/implicit
{heat}
"""
)
MEASURE = """
fix record all bearing/record pass/40 ${{out}}{folder} overwrite yes
run_bearing settle auto passes 2
unfix record
"""
HEAT = "fix heat all bearing/heat cooling 2"
LAST = """
write_dump all custom ${out}/last.dump id x y z vx vy vz omegax omegay omegaz modify &
  format "%d %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g" sort id
"""


@pytest.mark.parametrize(
    ("before", "speed", "load", "heat"),
    [((500, 2000), 100, 2000, ""), ((300, 2000), 300, 4000, HEAT)],
    ids=["speed", "load of a heated bearing"],
)
def test_a_measurement_after_another(tmp_path, before, speed, load, heat):
    """Starvation follows the speed of the rings, which differs from the speed with which they were
    created; the temperatures follow the losses under the new load."""
    once = DECK.format(speed=speed, load=load, heat=heat) + MEASURE.format(folder="")
    again = DECK.format(speed=before[0], load=before[1], heat=heat) + MEASURE.format(folder="/one")
    again += f"""
unfix inner
fix inner inner bearing/ring free loaded spin speed {speed} load {load} ramp 3.0e-3
"""
    found = []
    for name, text in (("once", once), ("again", again + MEASURE.format(folder=""))):
        succeed(deck_file(tmp_path, text), out=tmp_path / name)
        found.append(raceway.open(tmp_path / name).summary())
    for key in ("friction_torque_N_m", "h_min_m", "cage_speed_rad_s"):
        one, other = (figures[key] for figures in found)
        assert one == pytest.approx(other, rel=5e-3), key


def test_heat_in_two_runs(tmp_path):
    """Temperatures and clearance change in the same way if the run is divided, even if a ball pass
    is not a whole number of steps. The divisions are before, in and after the ramps."""
    deck = DECK.format(speed=800, load=2000, heat=HEAT + " warm_time 30 file ${out}/heat.txt")
    ends = {}
    for name, runs in (("one", [1000]), ("two", [420, 180, 90, 310])):
        (tmp_path / name).mkdir()
        text = deck + "timestep 2e-5\n" + "".join(f"run {steps}\n" for steps in runs) + LAST
        succeed(deck_file(tmp_path, text), out=tmp_path / name)
        ends[name] = (
            list(frames(tmp_path / name / "last.dump").values()),
            (tmp_path / name / "heat.txt").read_text(),
        )
    assert len(ends["one"][1].splitlines()) > 3
    assert ends["one"] == ends["two"]


def test_the_ball_pass_of_bearings_with_different_angles(tmp_path):
    """The ball pass of each bearing is that at its own contact angle, in whichever order they are
    named. The longest ball pass is used, here that of the deep-groove bearing."""
    first = DECK.format(speed=200, load=500, heat="").split("fix rails")[0]
    box = first.replace("create_box 4", "create_box 8").replace("block -0.06", "block -0.2")
    passes = []
    for other in ("a", "c"):
        text = box.replace("units si", f"bearing {other} 7205B types 5 6 7 8\nunits si")
        text = text.replace("* b\n", f"* b\npair_coeff * * {other}\n")
        text += f"""
create_bearing {other} centre -0.1 0 0 speed 200 0 thrust 500
fix rails cage bearing/cage b
fix others cage bearing/cage {other}
fix inner inner bearing/ring free loaded spin speed 200 mass 0.2 load 500 axial 500 ramp 3.0e-3
fix move all bearing/implicit
fix record all bearing/record pass/40 ${{out}} overwrite yes
run_bearing settle 0 passes 1
"""
        succeed(deck_file(tmp_path, text), out=tmp_path / other)
        with netcdf_file(tmp_path / other / "record.nc", mmap=False) as file:
            passes.append(np.ptp(file.variables["time"].data))
    inner, outer, diameter, balls = 24e-3, 36.605e-3, 12.6e-3, 9
    deep_groove = 4 * math.pi / (balls * 200 * (1 - diameter / (inner + outer)))
    assert passes == pytest.approx([deep_groove] * 2, rel=1e-9)


@pytest.mark.parametrize("cage", ["cage", "ring"])
def test_after_a_heated_run(tmp_path, cage):
    """If fix bearing/heat is deleted between two runs, the second run is that of a bearing that is
    not heated: it is the same as in a deck that never had this fix, from the same state."""
    cold = DECK.format(speed=800, load=2000, heat="")
    if cage == "ring":
        cold = cold.replace("clearance 1.0e-5", "clearance 1.0e-5 cage ring")
        cold = cold.replace("rails cage bearing/cage b", "rails cage bearing/cage/ring b")
    warm = cold + HEAT + "\ntimestep 2e-5\nrun 700\nunfix heat\n"
    warm += "write_restart ${out}/half\nrun 100\n"
    (tmp_path / "warm").mkdir()
    succeed(deck_file(tmp_path, warm + LAST), out=tmp_path / "warm")
    again = re.sub(r"(boundary|region|create_box) .*\n", "", cold)
    again = again.replace("neighbor ", f"read_restart {tmp_path}/warm/half\nneighbor ", 1)
    (tmp_path / "again").mkdir()
    succeed(
        deck_file(tmp_path, again + "timestep 2e-5\nrun 800 upto\n" + LAST), out=tmp_path / "again"
    )
    warm, again = (frames(tmp_path / name / "last.dump") for name in ("warm", "again"))
    assert warm == again


def test_another_oil(tmp_path):
    """If pair_coeff gives a bearing another oil, its cage and its capacitors have that oil too."""
    deck = DECK.format(speed=300, load=2000, heat="fix cap balls bearing/capacitance")
    deck = deck.replace("clearance 1.0e-5", "clearance 1.0e-5 cage ring")
    deck = deck.replace("rails cage bearing/cage b", "rails cage bearing/cage/ring b")
    other = "pair_coeff * * b oil pao8 temperature 70\n"
    once = deck.replace("pair_coeff * * b\n", other) + MEASURE.format(folder="")
    again = deck + MEASURE.format(folder="/one") + other + MEASURE.format(folder="")
    found = []
    for name, text in (("once", once), ("again", again)):
        succeed(deck_file(tmp_path, text.replace("${{out}}", "${out}")), out=tmp_path / name)
        found.append(raceway.open(tmp_path / name).summary())
    one, two = found
    assert one["permittivity"] == two["permittivity"] != 2.25
    for key in ("capacitance_F", "friction_torque_N_m", "h_min_m"):
        assert one[key] == pytest.approx(two[key], rel=5e-3), key
    # a cage that has not settled on its orbit shears the oil in its pockets a little differently
    assert one["losses_W"]["cage"] == pytest.approx(two["losses_W"]["cage"], rel=0.05)
