# SPDX-License-Identifier: GPL-2.0-or-later
"""Load and speed in the record of a deck with a named bearing: rotation of both rings, rings that
turn without a fix, a load on the outer ring, two bearings of one name."""

import math

import numpy as np
import pytest
import raceway
from host import deck_file, named_bearing, succeed
from raceway.runs.summary import summary
from raceway.runs.tables import RunTables

RAD_S = math.pi / 30
DECK = named_bearing(sides="-0.05 0.05 -0.05 0.05 -0.05 0.25")
END = """
fix cage cage bearing/cage b
fix move all bearing/implicit
fix record all bearing/record pass/40 ${out} overwrite yes
run_bearing settle 3 passes 1
"""
LOAD = "mass 0.2 free loaded load 2000 ramp 3.0e-3"
SPIN = "fix outer outer bearing/ring spin speed -40\n"


def ran(folder, *lines):
    deck = deck_file(folder, DECK + "\n".join(lines) + END)
    succeed(deck, out=folder)
    return folder


def figures(folder, bearing=None):
    return summary(RunTables(folder, bearing=bearing))


@pytest.mark.parametrize("speeds", [(100, -40), (0, 100), (150, 50)])
def test_speed_of_one_ring_against_the_other(tmp_path, speeds):
    """Both formulas of the friction torque and the life take the speed of one ring relative to the
    other."""
    inner, outer = speeds
    found = figures(
        ran(
            tmp_path,
            f"create_bearing b speed {inner} {outer}",
            f"fix inner inner bearing/ring spin speed {inner} {LOAD}",
            f"fix outer outer bearing/ring spin speed {outer}",
        )
    )
    assert found["rpm"] == pytest.approx(abs(inner - outer) / RAD_S, rel=1e-9)
    assert found["rpm_outer"] == pytest.approx(outer / RAD_S, rel=1e-9)
    assert found["load_N"] == 2000
    assert 0 < found["torque_skf_N_m"] < 1


def test_speed_as_set(tmp_path):
    """An outer ring that a fix holds leaves the speed as the deck sets it."""
    found = figures(
        ran(
            tmp_path,
            "create_bearing b speed 100 0",
            f"fix inner inner bearing/ring spin speed 100 {LOAD}",
            "fix outer outer bearing/ring spin speed 0",
        )
    )
    assert found["rpm"] == 954.929658551


def test_a_ring_turns_without_a_fix(tmp_path):
    """An outer ring without fix bearing/ring keeps the spin of create_bearing: the run equals one
    in which a fix imposes this spin, and measures whole ball passes."""
    begin = (
        "create_bearing b speed 100 -40",
        f"fix inner inner bearing/ring spin speed 100 {LOAD}",
    )
    with_fix, without = tmp_path / "with", tmp_path / "without"
    for folder, line in ((with_fix, SPIN), (without, "")):
        folder.mkdir()
        ran(folder, *begin, line)
    one, other = (raceway.open(folder) for folder in (with_fix, without))
    spins = other.tables.record.read(["ring_spin"])["ring_spin"]
    np.testing.assert_allclose(spins, [[100, -40]] * len(spins), rtol=1e-12)
    for name in ("load", "h_min"):
        np.testing.assert_array_equal(one.contacts[name], other.contacts[name])
    # a heavily loaded bearing slips little
    assert float(other.contacts["passes"][-1]) == pytest.approx(1, abs=0.03)


def test_load_on_the_outer_ring(tmp_path):
    """The load on the inner ring has the opposite direction; the displacement is relative to the
    outer ring."""
    found = figures(
        ran(
            tmp_path,
            "create_bearing b speed 100 0",
            "fix inner inner bearing/ring spin speed 100",
            f"fix outer outer bearing/ring {LOAD}",
        )
    )
    assert found["rpm"] == pytest.approx(100 / RAD_S, rel=1e-9)
    assert found["load_N"] == pytest.approx(2000, rel=2e-2)
    assert found["force_y_N"] == pytest.approx(-2000, rel=2e-2)
    assert found["ring_shift_m"] == pytest.approx(24.6e-6, rel=2e-2)
    assert found["load_parameter"] == pytest.approx(0.398, rel=1e-2)


def test_two_bearings_of_one_name(tmp_path):
    """Each bearing has its own load and speed."""
    other = "mass 0.2 free loaded load 500 load_azimuth 0.5 ramp 3.0e-3"
    folder = ran(
        tmp_path,
        "create_bearing b speed 100 0",
        "create_bearing b speed 200 0 centre 0 0 0.2",
        "group first id 19",
        "group second id 39",
        f"fix first first bearing/ring spin speed 100 {LOAD}",
        f"fix second second bearing/ring spin speed 200 {other}",
    )
    for bearing, load, speed, azimuth in ((1, 2000, 100, -math.pi / 2), (2, 500, 200, 0.5)):
        settings = raceway.open(folder).select(bearing).settings
        assert settings["load_N"] == pytest.approx(load, rel=2e-2)
        assert settings["rpm"] == pytest.approx(speed / RAD_S, rel=1e-9)
        assert settings["load_azimuth_rad"] == pytest.approx(azimuth, abs=2e-2)
        assert figures(folder, bearing)["ring_shift_m"] > 1e-5


def test_a_run_after_the_measurement(tmp_path):
    """A record with samples per ball pass ends with the measurement of run_bearing; later runs,
    also with another time step, add nothing."""
    begin = ("create_bearing b speed 100 0", f"fix inner inner bearing/ring spin speed 100 {LOAD}")
    deck = DECK + "\n".join(begin) + END
    records = []
    for name, more in (("alone", ""), ("more", "run 20\ntimestep 1e-5\nrun 20\n")):
        (tmp_path / f"in.{name}").write_text(deck + more)
        succeed(tmp_path / f"in.{name}", out=tmp_path / name)
        records.append((tmp_path / name / "record.nc").read_bytes())
    assert records[0] == records[1]
    assert raceway.open(tmp_path / "more").rings.sizes["time"] == 41
