# SPDX-License-Identifier: GPL-2.0-or-later
"""`raceway static` gives the same results as the library. Its tables, messages, exit codes and data
files are tested."""

import numpy as np
import pytest
from commands import answer, reply
from host import ROOT
from raceway import catalogue, inputs, static
from raceway.theory.lubrication import lubricate, turning

FULL = (
    "--load 2000 --axial 1000 --moment 10 -4e0 --rpm 477.5 --lubricant mineral --clearance -5e-6"
).split()


pytestmark = pytest.mark.usefixtures("in_the_tree")


def figures(capsys, *arguments):
    return answer(capsys, ["static", *arguments])


def test_figures_are_the_library_s(capsys):
    found = figures(capsys, *FULL, "--models", "paper")
    bearing, oil = (
        inputs.bearing(ROOT / "inputs/bearings/6208"),
        inputs.oil(ROOT / "inputs/lubricants/mineral"),
    )
    spin = 477.5 * np.pi / 30
    state, orbit = turning(bearing, spin, 2000.0, 1000.0, moment=(10.0, -4.0), clearance=-5e-6)
    films = lubricate(bearing, state, oil, spin, -5e-6)
    assert [found["shift_x_m"], found["shift_y_m"], found["shift_z_m"]] == pytest.approx(
        state.shift.tolist(), rel=1e-12
    )
    assert [found["tilt_x_rad"], found["tilt_y_rad"]] == pytest.approx(
        state.tilt.tolist(), rel=1e-12
    )
    assert [ball["q_inner_N"] for ball in found["balls"]] == state.inner.load.tolist()
    assert [ball["h_min_outer_m"] for ball in found["balls"]] == films.outer.h_min.tolist()
    assert found["capacitance_F"] == films.total and found["orbital_speed_rad_s"] == orbit
    assert np.array(found["stiffness"]).shape == (5, 5)
    assert found["support_x_N"] is None


def test_tilt_units_and_hold(capsys):
    arcmin = figures(capsys, "--load", "2000", "--tilt", "0", "20arcmin")
    assert arcmin["tilt_y_rad"] == pytest.approx(20 / 60 * np.pi / 180)
    assert figures(capsys, "--load", "2000", "--tilt", "0", f"{20 / 60}deg")[
        "tilt_y_rad"
    ] == pytest.approx(arcmin["tilt_y_rad"])
    bearing = inputs.bearing(ROOT / "inputs/bearings/6208")
    held = figures(capsys, "--load", "100", "--hold", "x=2e-5", "--hold", "rx=-1mrad")
    place = {"x": 2e-5, "z": 0.0, "rx": -1e-3, "ry": 0.0}
    state = static.equilibrium(bearing, 100.0, held=place)
    assert held["support_x_N"] == pytest.approx(-100 - state.force[0], rel=1e-9)
    assert held["support_rx_N_m"] == pytest.approx(-state.moment[0], rel=1e-9)
    assert held["support_z_N"] == 0


ANGULAR = ("--bearing", "7205B", "--load", "1000", "--rpm", "3000")


def test_ring_held_along_its_axis(capsys):
    """If there is no axial load, an angular contact bearing is held at the position at which its
    balls make contact, as in a deck. If the force that holds it is applied as an axial load
    instead, the results are the same."""
    held = figures(capsys, *ANGULAR)
    assert held["clearance_m"] == pytest.approx(2 * 0.05 * 7.938e-3 * (1 - np.cos(np.radians(40))))
    assert held["load_parameter"] is None and held["loaded_balls"] == 12
    free = figures(capsys, *ANGULAR, "--axial", repr(held["support_z_N"]))
    assert free["support_z_N"] is None
    for name in ("shift_x_m", "shift_z_m", "q_inner_max_N", "life_reference_Mrev"):
        assert free[name] == pytest.approx(held[name], rel=1e-9)
    assert "must be 0: it follows from the contact angle" in reply(
        capsys, ["static", *ANGULAR, "--clearance", "1e-5"], code=1
    )


def test_balls_that_slide_under_their_gyroscopic_moment(capsys):
    """In runs with a coefficient of friction of 0.05 in the film, the balls of a 7205B at 8000 rpm
    slide under a thrust of 100 N and roll under a thrust of 150 N. Without a contact angle, there
    is no gyroscopic moment."""
    words = ["--bearing", "7205B", "--rpm", "8000", "--lubricant", "vg46", "--temperature", "70"]
    words += ["--models", "full", "--axial"]
    below, above = figures(capsys, *words, "150"), figures(capsys, *words, "100")
    assert below["gyroscopic_friction"] < 0.05 < above["gyroscopic_friction"]
    assert "the friction of 12 balls is below the coefficient" in above["warnings"][0]
    radial = figures(capsys, "--load", "100", "--rpm", "9000", "--lubricant", "vg46", *words[6:8],
                     "--models", "full")  # fmt: skip
    assert radial["gyroscopic_friction"] is None


@pytest.mark.parametrize("axial", [300, 500, 600])
def test_balls_without_load_have_no_contact_angle(capsys, axial):
    """Balls that barely touch the inner ring are at the edge of its groove, at more than 60
    degrees; the contact angle of every ball with more than 1 % of the largest load is below the
    nominal angle."""
    found = figures(capsys, *ANGULAR, "--axial", str(axial))
    angles = [(ball["angle_inner_rad"], ball["q_inner_N"]) for ball in found["balls"]]
    loaded = [angle for angle, load in angles if load > 0.01 * found["q_inner_max_N"]]
    assert found["angle_max_rad"] == pytest.approx(max(loaded), rel=0.01)
    assert found["angle_max_rad"] < np.radians(40)
    assert all("their cage" in one for one in found["warnings"])
    assert max(angles)[0] > np.radians(60) or axial == 300


@pytest.mark.parametrize("words", ["", " --lubricant vg46", " --C 30kN", " --bearing QJ208"])
def test_a_ring_held_without_load_has_no_life(capsys, words):
    """At a speed, the centrifugal loads of the balls load the outer raceway alone."""
    held = "static --hold x=0 --hold y=0 --hold z=0 --clearance 10um --rpm 1000" + words
    found = answer(capsys, held)
    assert found["q_inner_max_N"] == 0 < found["q_outer_max_N"]
    assert not any(key.startswith("life_") for key in found)
    assert "largest load, outer raceway" in reply(capsys, held)


def test_table(capsys):
    text = reply(capsys, ["static", *FULL])
    balls = text.split("\nBalls\n")[1].split("\n\n")[0].splitlines()
    # a heading and nine balls, aligned in columns
    assert len(balls) == 10 and len({len(line) for line in balls}) == 1


def test_the_moment_on_a_held_tilt_stands_once(capsys):
    """It is that of the restraint if the tilt is held, and the load otherwise."""
    for words in ([], ["--moment", "3", "0"], ["--tilt", "1e-4", "0"]):
        text = reply(capsys, ["static", "--load", "1000", "--axial", "300", *words])
        assert text.count("moment about x") == text.count("moment about y") == 1


def test_files_are_shown_by_their_names(capsys, tmp_path):
    own = {}
    for kind, name in (("bearing", "6208"), ("lubricant", "vg46")):
        own[kind] = tmp_path / f"my{name}"
        own[kind].write_text((ROOT / f"inputs/{kind}s" / name).read_text())
    words = [word for kind, path in own.items() for word in (f"--{kind}", path)]
    for command in ("static", "electric", "heat"):
        found = answer(capsys, [command, "--load", "1000", "--rpm", "900", *words])
        assert (found["bearing"], found["lubricant"]) == ("my6208", "myvg46")


def test_dry_lubricant_has_no_film(capsys):
    assert "h_min_m" not in figures(capsys, "--load", "100", "--lubricant", "dry")


def test_own_bearing_from_elsewhere(capsys, tmp_path, monkeypatch):
    text = (ROOT / "inputs/bearings/6208").read_text()
    (tmp_path / "mine").write_text(
        text.replace("variable balls              index 9", "variable balls index 8")
    )
    monkeypatch.chdir(tmp_path)
    assert len(figures(capsys, "--load", "5000", "--bearing", "./mine")["balls"]) == 8
    # names are found in the source tree from which this package is installed, or in the folder of
    # --inputs
    assert len(figures(capsys, "--load", "5000")["balls"]) == 9
    assert (
        len(
            figures(
                capsys, "--load", "5000", "--bearing", "6306", "--inputs", str(ROOT / "inputs")
            )["balls"]
        )
        == 8
    )


def test_folder_here_comes_first(tmp_path, monkeypatch):
    for kind in catalogue.KINDS:
        (tmp_path / "inputs" / kind).mkdir(parents=True)
    below = tmp_path / "a" / "b"
    below.mkdir(parents=True)
    monkeypatch.chdir(below)
    assert catalogue.folder() == tmp_path / "inputs"


@pytest.mark.parametrize(
    "arguments, said",
    [
        ([], "position of a ring that is not preloaded is indeterminate"),
        (["--load", "1000", "--hold", "x=0", "--hold", "y=0"], "no ball carries"),
        (["--axial", "1e6"], "out of the inner groove"),
        (["--load", "10", "--bearing", "6299"], "there is no ball bearing '6299' in "),
        (["--load", "10", "--bearing", "./none"], "there is no file ./none"),
        (["--load", "10", "--lubricant", "oil", "--rpm", "1"], "there is no lubricant 'oil' in "),
        (["--load", "10", "--inputs", "/none"], "there is no folder /none"),
    ],
)
def test_cannot(capsys, arguments, said):
    printed = reply(capsys, ["static", *arguments], code=1)
    assert printed.startswith("raceway: ") and said in printed


def test_a_ring_held_in_the_middle_has_no_load_parameter(capsys):
    held = ["--load", "100", "--hold", "x=0", "--hold", "y=0", "--clearance=-20e-6"]
    found = answer(capsys, ["static", *held])
    assert found["load_parameter"] is None and found["loaded_balls"] == 9


def test_broken_data_file(capsys, tmp_path):
    path = tmp_path / "mine"
    path.write_text("variable balls index nine\n")
    assert str(path) in reply(capsys, ["static", "--load", "10", "--bearing", path], code=1)


@pytest.mark.parametrize(
    "arguments, said",
    [
        (["--load", "-5"], "-5 is out of range: must lie from 0 to 1e+06 N"),
        (["--load", "many"], "'many' is not a number"),
        (["--clearance", "1"], "must lie from -0.001 to 0.001 m"),
        (["--moment", "nan", "0"], "nan is out of range"),
        (["--tilt", "1", "0"], "must lie from -0.2 to 0.2 rad"),
        (["--tilt", "20min", "0"], "'20min' is not a number in rad"),
        (["--hold", "w=3"], "'w=3' is not NAME=VALUE with NAME one of x, y, z, rx, ry"),
        (["--hold", "x=far"], "'far' is not a number"),
        (["--hold", "x=1e-6", "--hold", "x=2e-6"], "--hold: x is given twice"),
        (["--load", "10", "--lubricant", "mineral"], "a film needs a speed; give --rpm"),
        (["--load", "10", "--moment", "0", "0", "--tilt", "0", "0"], "--moment and --tilt"),
        (["--load", "10", "--cage", "ring"], "--cage applies to the friction torque of oil"),
        (["--load", "10", "--cage-play", "2e-4"], "--cage-play applies to a cage ring"),
    ],
)
def test_wrong_command_line(capsys, arguments, said):
    assert said in reply(capsys, ["static", *arguments], code=2)


def test_full_models(capsys):
    common = ("--load", "5000", "--rpm", "1910", "--lubricant", "vg46", "--temperature", "70")
    paper, full = figures(capsys, *common, "--models", "paper"), figures(capsys, *common)
    assert (paper["models"], full["models"]) == ("paper", "full")
    assert paper["temperature_C"] == full["temperature_C"] == 70
    assert paper["friction_torque_N_m"] is None and paper["losses_W"] is None
    assert set(paper["absent"].values()) == {"not in models paper"} and full["absent"] == {}
    assert {key for key, value in paper.items() if value is None} >= set(paper["absent"])
    assert "of the inner ring               not in models paper" in reply(
        capsys, ["static", *common, "--models", "paper"]
    )
    oil = inputs.oil(ROOT / "inputs/lubricants/vg46", 70.0)
    assert paper["viscosity_Pa_s"] == oil.viscosity == full["viscosity_Pa_s"]
    assert full["shift_x_m"] < paper["shift_x_m"]
    assert set(full["losses_W"]) == {"rolling", "slip", "spin", "hysteresis", "drag", "cage"}
    assert full["friction_torque_N_m"] * 1910 * np.pi / 30 == pytest.approx(
        sum(full["losses_W"].values())
    )
    assert full["torque_skf_N_m"] > 0 and full["torque_palmgren_N_m"] > 0
    thrust = figures(capsys, *common, "--axial", "1000")
    assert thrust["torque_skf_N_m"] > full["torque_skf_N_m"]
    assert thrust["torque_palmgren_N_m"] is None
    assert thrust["absent"] == {"torque_palmgren_N_m": "the formula is for radial loads"}
    held = figures(capsys, *common, "--bearing", "7208B")  # its balls push it along its axis
    assert held["axial_N"] == 0 < held["support_z_N"] and held["torque_palmgren_N_m"] is None
    assert held["torque_skf_N_m"] > 0
    four = figures(capsys, *common, "--bearing", "QJ208")
    assert set(four["absent"]) == {"torque_skf_N_m", "torque_palmgren_N_m"}


def test_temperature_needs_a_lubricant(capsys):
    assert "--temperature applies to the lubricant; give --lubricant" in reply(
        capsys, "static --load 1 --temperature 70", code=2
    )
