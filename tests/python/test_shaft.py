# SPDX-License-Identifier: GPL-2.0-or-later
"""Shafts on bearings are compared with closed-form solutions for beams and with the statics of a
single bearing."""

import contextlib
import io
import json
import re

import numpy as np
import pytest
from bearings import B6208
from commands import answer, reply
from host import ROOT
from raceway import beam, catalogue, inputs, shaft, static
from raceway.cli import main
from raceway.commands import shaft as shaft_command
from raceway.errors import NoEquilibrium
from raceway.theory.beam import STEEL, Section
from raceway.theory.shaft import Load, Seat, Shaft

THIN = Section(0.3, 0.04)
BENDING = STEEL.young * beam.second_moment(THIN)
SHEAR = beam.shear_coefficient(THIN, 0.3) * beam.area(THIN) * STEEL.young / 2.6
MOTOR = ROOT / "inputs/shafts/motor"


def clamped(pieces, loads):
    """Return the positions (N, 5) of a beam whose first node is clamped."""
    whole = beam.stiffness(pieces)[5:, 5:]
    return np.linalg.solve(whole, loads[5:]).reshape(-1, 5)


@pytest.mark.parametrize("number", [1, 3])
def test_cantilever(number):
    """The deflection is F L^3/3EI + F L/kAG and the slope F L^2/2EI for any number of elements."""
    pieces = [THIN._replace(length=0.3 / number)] * number
    loads = np.zeros(5 * (number + 1))
    loads[-5:-2] = 700.0, -300.0, 5000.0
    end = clamped(pieces, loads)[-1]
    bend = 0.3**3 / (3 * BENDING) + 0.3 / SHEAR
    assert end[:2] == pytest.approx([700 * bend, -300 * bend], rel=1e-9)
    turn = 0.3**2 / (2 * BENDING)
    assert end[3:] == pytest.approx([300 * turn, 700 * turn], rel=1e-9)
    assert end[2] == pytest.approx(5000 * 0.3 / (STEEL.young * beam.area(THIN)), rel=1e-9)


def test_own_weight():
    """If the end moments of a uniform load are included, the deflection w L^4/8EI + w L^2/2kAG is
    exact at the nodes."""
    pieces = [THIN._replace(length=0.15)] * 2
    end = clamped(pieces, beam.weight(pieces, [0.0, -9.81, 0.0]))[-1]
    w = 9.81 * STEEL.density * beam.area(THIN)
    want = w * 0.3**4 / (8 * BENDING) + w * 0.3**2 / (2 * SHEAR)
    assert end[1] == pytest.approx(-want, rel=1e-6)


@pytest.mark.parametrize("length", [0.1, 0.1 + 4.9e-10, 0.1 - 4.9e-10, 1 / 3, 2 / 3])
def test_nodes_are_places_on_the_shaft(capsys, tmp_path, length):
    sections = [Section(length, 0.04), Section(2 * length, 0.05)]
    z, pieces = beam.divided(sections, [0.0, 3 * length])
    again, same = beam.divided(sections, z)
    assert again.tolist() == z.tolist() and same == pieces and len(pieces) == 2
    parts = ", ".join(f"{{length: {one.length}, diameter: {one.diameter}}}" for one in sections)
    seats = ", ".join(f"{{name: 6208, at: {share * length}}}" for share in (0.5, 3))
    path = tmp_path / "shaft"
    path.write_text(
        f"sections: [{parts}]\nbearings: [{seats}]\nloads: [{{at: {length}, force: [9, 0, 0]}}]"
    )
    assert answer(capsys, ["shaft", path])["z_m"][-1] == pytest.approx(3 * length, abs=1e-9)


def test_rigid_motions_cost_nothing():
    """The energy of a displacement, and of a small rotation about x and y, is zero compared with
    the bending energy."""
    z, pieces = beam.divided([THIN, Section(0.1, 0.02, 0.01)], [0.05])
    whole = beam.stiffness(pieces)
    moves = np.zeros((5, len(z), 5))
    for k in range(3):
        moves[k, :, k] = 1
    moves[3, :, 1], moves[3, :, 3] = -z, 1
    moves[4, :, 0], moves[4, :, 4] = z, 1
    for move in moves.reshape(5, -1):
        assert np.abs(whole @ move).max() < 1e-9 * np.abs(whole).max()


@pytest.mark.parametrize("clearance", [-10e-6, 0.0, 10e-6])
def test_lever_rule(clearance):
    """A shaft with a diameter of 0.2 m is rigid compared with its bearings, so the loads on the
    bearings follow from the lever rule."""
    seats = [Seat(0.1, B6208, clearance), Seat(0.4, B6208, clearance, floating=True)]
    found = shaft.rest(Shaft([Section(0.5, 0.2)]), seats, [Load(0.2, (600.0, -3000.0, 0.0))])
    shares = np.array([one.load[:2] for one in found.bearings])
    assert shares == pytest.approx(np.outer([2 / 3, 1 / 3], [600, -3000]), rel=1e-3)


@pytest.mark.parametrize("speed", [0.0, 157.0])
def test_a_floating_bearing_that_carries_nothing(speed):
    """A bearing with clearance that slides along z carries none of an axial load."""
    seats = [Seat(0.1, B6208, 10e-6, floating=True), Seat(0.4, B6208, 10e-6)]
    pushed = [Load(0.2, (0.0, 0.0, 500.0))]
    idle, one = shaft.rest(Shaft([Section(0.5, 0.2)]), seats, pushed, speed=speed).bearings
    assert np.abs(idle.load).max() == 0 and np.abs(idle.stiffness).max() == 0
    alone = static.equilibrium(B6208, axial_load=500.0, clearance=10e-6, **_centrifugal(speed))
    assert one.load == pytest.approx([0, 0, 500, 0, 0], abs=1e-6)
    assert one.state.inner.load == pytest.approx(alone.inner.load, rel=1e-6)


@pytest.mark.parametrize("misaligned", [0.0, 1e-3])
@pytest.mark.parametrize("load", [100.0, 1000.0])
def test_a_floating_bearing_that_carries_little(load, misaligned):
    """A floating bearing takes up its clearance and carries the part of the load that balances the
    moment about the fixed bearing."""
    offset = (0.0, 0.0, 0.0, misaligned, 0.0)
    seats = [Seat(0.03, B6208, 10e-6), Seat(0.2, B6208, 20e-6, offset, floating=True)]
    pushed = [Load(0.05, (load, 0.0, 100.0))]
    first, second = shaft.rest(Shaft([Section(0.25, 0.05)]), seats, pushed).bearings
    assert first.load[:3] + second.load[:3] == pytest.approx([load, 0, 100], abs=1e-6)
    about_y = first.load[4] + second.load[4] + 0.17 * second.load[0]
    assert second.load[2] == 0 and about_y == pytest.approx(0.02 * load, abs=1e-6)


@pytest.mark.parametrize("speed", [0.0, 600.0])
@pytest.mark.parametrize("place", [0.02, 0.034, 0.21])
def test_a_light_load(place, speed):
    """The bearings carry a load of a few newtons that first moves the shaft through their
    clearances; nothing holds the shaft along its axis except these bearings."""
    seats = [Seat(0.03, B6208, 10e-6), Seat(0.2, B6208, 30e-6, (0, 0, 0, 0, -5e-4), floating=True)]
    load = Load(place, (2.0, -3.0, 0.0))
    found = shaft.rest(Shaft([Section(0.25, 0.05)]), seats, [load], speed=speed).bearings
    carried = sum(one.load for one in found)
    assert carried[:3] == pytest.approx(load.force, abs=1e-6)
    x, y, _ = sum(one.seat.at * one.load[:3] for one in found)
    about = np.array([place * 3.0, place * 2.0])  # N m, of the load about x and y at z = 0
    assert carried[3:] + [-y, x] == pytest.approx(about, abs=1e-6)


@pytest.mark.parametrize("tilt", [0.0, 58e-6, 120e-6])
@pytest.mark.parametrize("shift", [10.5e-6, 11e-6, 11.2e-6, 12e-6])
def test_a_held_ring_that_slides(shift, tilt):
    """A ring that is held in all directions but z slides to where it has no axial load."""
    held = dict(x=shift, y=0.0, rx=0.0, ry=tilt)
    found = static.equilibrium(B6208, held=held, clearance=20e-6)
    assert found.force[0] < 0 and abs(found.force[2]) < 1e-9
    mirrored = static.equilibrium(B6208, held=held | {"ry": -tilt}, clearance=20e-6)
    assert mirrored.shift == pytest.approx(found.shift * [1, 1, -1], rel=1e-6, abs=1e-14)


def _centrifugal(speed):
    return dict(orbital_speed=speed * (1 - B6208.ball_radius / B6208.pitch_radius) / 2)


@pytest.mark.parametrize("speed", ["0", "1500"])
@pytest.mark.parametrize("floating", ["yes", "no"])
def test_a_bearing_without_load_has_no_life(motor, capsys, tmp_path, speed, floating):
    """A bearing with a large clearance changes nothing for the others."""
    text = MOTOR.read_text()
    loose = f"  - {{name: 6208, at: 0.18, clearance: 1.0e-4, floating: {floating}}}\n"
    path = tmp_path / "shaft"
    path.write_text(text.replace("bearings:\n", f"bearings:\n{loose}"))
    idle, *others = answer(capsys, ["shaft", path, "--rpm", speed])["bearings"]
    assert idle["load_x_N"] == 0 and "life_reference_Mrev" not in idle
    for one, before in zip(others, answer(capsys, ["shaft", MOTOR, "--rpm", speed])["bearings"]):
        assert one["life_reference_Mrev"] == pytest.approx(before["life_reference_Mrev"], rel=1e-6)
    assert "6208" in reply(capsys, ["shaft", path, "--rpm", speed])


def test_simply_supported():
    """If the bearings can tilt freely, the deflection between them is F L^3/48EI + F L/4kAG, and
    the slope is F L^2/16EI."""
    seats = [Seat(0.0, B6208, 20e-6), Seat(0.3, B6208, 20e-6, floating=True)]
    found = shaft.rest(Shaft([THIN]), seats, [Load(0.15, (0.0, -3000.0, 0.0))])
    assert found.z == pytest.approx([0, 0.15, 0.3])
    down = found.place[:, 1]
    bend = 3000 * 0.3**3 / (48 * BENDING) + 3000 * 0.3 / (4 * SHEAR)
    held = abs(found.bearings[0].load[3]) / (3000 * 0.3 / 8)  # fraction of clamped-end moment
    assert held < 2e-3
    assert (down[0] + down[2]) / 2 - down[1] == pytest.approx(bend, rel=1e-3 + held)
    # with clamped ends the slope would be zero
    assert found.place[0, 3] == pytest.approx(3000 * 0.3**2 / (16 * BENDING), rel=1e-3 + 2 * held)


def test_a_bearing_stiffens_its_own_slope():
    slope = []
    for clearance in (20e-6, -20e-6):
        seats = [Seat(0.0, B6208, clearance), Seat(0.3, B6208, clearance, floating=True)]
        found = shaft.rest(Shaft([THIN]), seats, [Load(0.15, (0.0, -3000.0, 0.0))])
        slope.append(abs(found.place[0, 3]))
        turned = found.bearings[0].load[3] * found.place[0, 3]
        assert turned > 0  # the shaft tilts the bearing and does work on it
    assert slope[1] < slope[0]


def left_over(found, loads):
    """Return the sums of the forces, and of the moments about x and y through the origin, of
    `loads` and bearings."""
    force, moment = np.zeros(3), np.zeros(2)
    for at, push, couple in (
        *((one.seat.at, -one.load[:3], -one.load[3:]) for one in found.bearings),
        *((load.at, np.array(load.force), np.array(load.moment)) for load in loads),
    ):
        force += push
        moment += couple + [-at * push[1], at * push[0]]
    return force, moment


def test_everything_balances():
    """The forces of the loads, of gravity and of the bearings balance, and so do their moments
    about the origin."""
    sections = [Section(0.2, 0.05), Section(0.3, 0.03, 0.01)]
    seats = [
        Seat(0.05, B6208, 5e-6),
        Seat(0.3, B6208, 5e-6),
        Seat(0.45, B6208, 5e-6, floating=True),
    ]
    loads = [Load(0.2, (500.0, -2000.0, 300.0)), Load(0.5, (0.0, 400.0, 0.0), (5.0, -8.0))]
    found = shaft.rest(Shaft(sections, gravity=(0.0, -9.81, 0.0)), seats, loads, speed=300.0)
    force, moment = left_over(found, loads)
    start = 0.0
    for one in sections:
        heavy = 9.81 * STEEL.density * beam.area(one) * one.length
        force[1] -= heavy
        moment[0] += (start + one.length / 2) * heavy
        start += one.length
    assert force == pytest.approx(np.zeros(3), abs=1e-5)
    assert moment == pytest.approx(np.zeros(2), abs=1e-5)


def own(name, at, **more):
    return Seat(at, inputs.bearing(catalogue.find("bearings", name, ROOT / "inputs")), **more)


# section, seats, loads, speed
HARD = {
    "13 mm apart, one floats, overhung load": (
        Section(0.334, 0.036),
        [
            own("7208B", 0.2076, phase=0.374, offset=(0, 0, -8.72e-6, 6.04e-5, -1.78e-4)),
            own("7208B", 0.2205, phase=0.271, offset=(0, 0, 2e-6, 1.6e-4, -8e-5), floating=True),
        ],
        [Load(0.3159, (1340.0, 1560.0, 372.0))],
        106.0,
    ),
    "7 mm apart": (
        Section(0.238, 0.0593),
        [own("7208B", 0.1077, phase=0.0183), own("7208B", 0.1143, phase=0.0487)],
        [Load(0.03265, (291.0, 1710.0, 19.0))],
        520.0,
    ),
    "floating four-point bearing on a tilted seat": (
        Section(0.458, 0.0386),
        [
            own(
                "QJ210",
                0.04077,
                clearance=26.3e-6,
                phase=0.153,
                offset=(4.87e-6, 3.81e-6, -5.44e-6, -3.35e-4, -3.08e-4),
                floating=True,
            ),
            own("6210", 0.1542, clearance=24.5e-6, phase=0.228, spring=-361.0),
            own("6306", 0.2129, clearance=26.1e-6, phase=0.0996),
        ],
        [Load(0.2549, (1340.0, 1970.0, 0.0)), Load(0.271, (-1190.0, 60.7, 330.0))],
        361.0,
    ),
}


@pytest.mark.parametrize("scene", HARD.values(), ids=HARD)
def test_no_valid_scene_is_refused(scene):
    """On the way to these equilibria, balls lie beyond the edges of their grooves, or a floating
    bearing loses all of its load."""
    section, seats, loads, speed = scene
    found = shaft.rest(Shaft([section]), seats, loads, speed=speed)
    size = sum(np.linalg.norm(load.force) for load in loads)
    for left in left_over(found, loads):
        assert left == pytest.approx(np.zeros(len(left)), abs=1e-8 * size)


def test_one_bearing_is_its_statics():
    """A short stiff shaft on a tilted seat, with all loads in the plane of the balls, gives the
    same results as the statics of its bearing."""
    tilt = 5e-4
    seat = Seat(0.05, B6208, 10e-6, offset=(0.0, 0.0, 0.0, tilt, 0.0))
    short = Shaft([Section(0.1, 0.3)])
    found = shaft.rest(short, [seat], [Load(0.05, (2000.0, 0.0, 500.0), (3.0, 2.0))])
    want = static.equilibrium(B6208, 2000.0, 500.0, moment=(3.0, 2.0), clearance=10e-6)
    assert found.bearings[0].place[:3] == pytest.approx(want.shift, rel=1e-6, abs=1e-12)
    assert found.bearings[0].place[3:] == pytest.approx(want.tilt, rel=1e-6)
    assert found.place[1, 3] == pytest.approx(want.tilt[0] + tilt, rel=1e-6)
    assert found.bearings[0].state.inner.load == pytest.approx(want.inner.load, abs=1e-3)


@pytest.mark.parametrize("density", [3200, 7800])
def test_density_of_the_balls(capsys, tmp_path, density):
    """At a high speed, the stiffness depends on the density of the balls in the bearing's file. It
    is the same from statics, on a shaft and in a table for rotors."""
    file, beam_of_one, out = (tmp_path / name for name in ("mine", "shaft", "table.json"))
    text = (ROOT / "inputs/bearings/6208").read_text()
    file.write_text(re.sub(r"(ball_density +index) \S+", rf"\1 {density}", text))
    beam_of_one.write_text(
        "rpm: 12000\nsections: [{length: 0.1, diameter: 0.3}]\n"
        f"bearings: [{{name: {file}, at: 0.05}}]\nloads: [{{at: 0.05, force: [1000, 0, 0]}}]\n"
    )
    point = ["--bearing", file, "--load", "1000", "--rpm", "12000"]
    alone = answer(capsys, ["static", *point])["stiffness"]
    (carried,) = answer(capsys, ["shaft", beam_of_one])["bearings"]
    reply(capsys, ["stiffness", *point, "--phases", "1", "--out", out])
    (row,) = json.loads(out.read_text())["points"]
    for found in (carried["stiffness"], row["stiffness"]):
        assert np.diag(found) == pytest.approx(np.diag(alone), rel=2e-3)


def test_preload_by_a_spacer():
    """Two bearings that are preloaded against each other through their outer rings each support the
    other's axial load."""
    seats = [
        Seat(0.1, B6208, 20e-6, offset=(0, 0, -120e-6, 0, 0)),
        Seat(0.3, B6208, 20e-6, offset=(0, 0, 120e-6, 0, 0)),
    ]
    found = shaft.rest(Shaft([Section(0.4, 0.1)]), seats, [Load(0.2, (0.0, -1.0, 0.0))])
    pushes = [one.load[2] for one in found.bearings]
    assert pushes[0] > 100 and pushes[0] == pytest.approx(-pushes[1], rel=1e-6)


@pytest.mark.parametrize("push", [-300.0, 300.0])
def test_preload_by_a_spring(push):
    """The force of the spring is transmitted through both bearings, and the sliding bearing is in
    equilibrium under its load."""
    seats = [Seat(0.1, B6208, 20e-6), Seat(0.3, B6208, 20e-6, spring=push)]
    found = shaft.rest(Shaft([Section(0.4, 0.2)]), seats, [Load(0.2, (0.0, -1.0, 0.0))])
    assert [one.load[2] for one in found.bearings] == pytest.approx([push, -push], rel=1e-6)
    alone = static.equilibrium(B6208, 0.0, -push, clearance=20e-6)
    state = found.bearings[1].state
    assert state.inner.load.max() == pytest.approx(alone.inner.load.max(), rel=5e-3)
    # the shaft needs no other load
    assert shaft.rest(Shaft([Section(0.4, 0.2)]), seats, []).residual <= shaft.EXACT


def test_mistakes():
    seats = [Seat(0.1, B6208), Seat(0.3, B6208, floating=True)]
    with pytest.raises(ValueError, match="0.5 m is not on the shaft"):
        shaft.rest(Shaft([THIN]), seats, [Load(0.5, (1.0, 0.0, 0.0))])
    with pytest.raises(NoEquilibrium, match="needs bearings and a load"):
        shaft.rest(Shaft([THIN]), seats, [])
    loose = [Seat(0.1, B6208, floating=True), Seat(0.3, B6208, floating=True)]
    with pytest.raises(NoEquilibrium, match="do not hold the shaft"):
        shaft.rest(Shaft([THIN]), loose, [Load(0.2, (500.0, 0.0, 100.0))])


# ---- the command


@pytest.fixture(scope="module")
def motor():
    """Return what `raceway shaft` prints for the motor with --json."""
    out = io.StringIO()
    with contextlib.redirect_stdout(out):
        assert main(["shaft", str(MOTOR), "--json"]) == 0
    return out.getvalue()


def test_command(motor, capsys, tmp_path):
    found = json.loads(motor)
    first, second = found["bearings"]
    assert first["load_z_N"] == 0.0 and second["load_z_N"] == pytest.approx(400.0, rel=1e-6)
    # moments about the second bearing, with lever arms of 0.06 m (belt) and 0.3 m; the tilts
    # account for 9 N m
    held = first["moment_y_N_m"] + second["moment_y_N_m"]
    assert first["load_x_N"] == pytest.approx((held - 1500 * 0.06) / 0.3, rel=1e-6)
    assert second["life_reference_h"] > 0 and second["tilt_rad"] < 1e-3
    said = reply(capsys, ["shaft", MOTOR, "--out", tmp_path / "x.png"])
    assert "6208" in said and "tilt" in said
    assert (tmp_path / "x.png").stat().st_size > 10_000


def test_a_dry_shaft_is_one_without_lubricant(tmp_path, capsys):
    text, found = MOTOR.read_text(), []
    for line in ("lubricant: dry", ""):
        path = tmp_path / "shaft"
        path.write_text(text.replace("lubricant: vg46", line, 1))
        found.append(json.loads(reply(capsys, ["shaft", path, "--json"])))
    assert found[0].pop("lubricant") == "dry" and found[1].pop("lubricant") is None
    assert found[0] == found[1]


def test_own_bearing(motor, capsys, tmp_path):
    """A bearing that is given by its path is shown by its name, as in other commands."""
    (tmp_path / "mine").write_text((ROOT / "inputs/bearings/6208").read_text())
    text = MOTOR.read_text().replace("name: 6208", f"name: {tmp_path / 'mine'}", 1)
    (tmp_path / "shaft").write_text(text)
    found = answer(capsys, ["shaft", tmp_path / "shaft"])
    assert [one.pop("bearing") for one in found["bearings"]] == ["mine", "6208"]
    want = json.loads(motor)["bearings"]
    assert found["bearings"] == [{k: v for k, v in one.items() if k != "bearing"} for one in want]


def test_several_speeds(motor, capsys):
    """Each entry equals the result of a run at that speed alone; results below the accuracy of the
    equilibrium are 0."""
    speeds = ["1500", "9000"]
    both = answer(capsys, ["shaft", MOTOR, "--rpm", *speeds])
    assert both[0] == json.loads(motor)
    assert [one["rpm"] for one in both] == [1500.0, 9000.0]
    said = shaft_command.over_speed(both).splitlines()
    assert len(said) == 3 and said[2].split()[0] == "9000"
    both[0]["bearings"][0].update(load_x_N=1e-7, moment_x_N_m=-1e-10)
    row = shaft_command.table(both[0]).splitlines()[2].split()
    assert row[0] == "6208" and row[3] == "0" and "0" in row[6:9]


@pytest.mark.parametrize(
    "old, new, says",
    [
        ("rpm: 1500", "rpm: -3", "rpm is -3, must be from 0 to 100000"),
        ("rpm: 1500", "speed: 3", "unknown 'speed'; known: rpm, gravity, steel"),
        (
            "diameter: 0.090",
            "diameter: wide",
            "diameter is wide, must be a number without a unit, from 0.0001 to",
        ),
        ("length: 0.24, ", "", "sections 2: needs length"),
        ("name: 6208, at: 0.03,", "at: 0.03,", "bearings 1: needs a name"),
        ("name: 6208, at: 0.03,", "name: 9999, at: 0.03,", "there is no ball bearing '9999'"),
        ("name: 6208, at: 0.03,", "name: 7208, at: 0.03,", "clearance 1e-05 m must be 0"),
        ("clearance: 10.0e-6", "clearance: -0.9e-3", "clearance -0.0009 m must be from"),
        ("force: [1500, 0, 0]", "force: [1500, 0]", "loads 1: force must be a list of 3 numbers"),
        ("at: 0.39", "at: 3.9", "3.9 m is not on the shaft"),
        ("{length: 0.06, diameter: 0.036}", "{length: 0.06, diameter: 0.036, bore: 0.04}", "bore"),
        ("loads:", "load:", "unknown 'load'"),
        ("rpm: 1500", "steel: {young: 1e7}", "steel: young is 1e7, must be from 1e+08 to 1e+13"),
        ("lubricant: vg46", "lubricant: [vg46]", "lubricant must be one name"),
    ],
)
def test_files_with_mistakes(tmp_path, capsys, old, new, says):
    text = MOTOR.read_text()
    assert old in text
    path = tmp_path / "shaft"
    path.write_text(text.replace(old, new, 1))
    assert says in reply(capsys, ["shaft", path, "--inputs", ROOT / "inputs"], code=1)


def test_no_file(capsys):
    assert "cannot read nowhere" in reply(capsys, "shaft nowhere", code=1)
