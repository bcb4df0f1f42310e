# SPDX-License-Identifier: GPL-2.0-or-later
"""Results for four-point contact bearings and double-row bearings are compared with results for
bearings with one groove per ring."""

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from commands import answer, reply
from host import ROOT
from raceway import (
    catalogue,
    inputs,
    life,
    lubrication,
    operating_point,
    ring_response,
    shaft,
    static,
)
from raceway.export import rotor
from raceway.theory.beam import Section, Steel
from raceway.theory.bearing import DoubleRow, Layout
from raceway.theory.small_motion import response

ANGLE, PLAY, RPM = np.radians(35), 20e-6, 1000.0
OF_6208 = inputs.bearing(ROOT / "inputs/bearings/6208")
OIL = inputs.oil(ROOT / "inputs/lubricants/mineral")


def body():
    """Return the bearing with one groove per ring that a four-point contact bearing is equivalent
    to under a thrust."""
    return replace(OF_6208.four_point(ANGLE), layout=Layout())


def thrust():
    """Return (`static.Equilibrium`, films) of `body` under 1 kN along z."""
    spin = RPM * np.pi / 30
    held = {"x": 0.0, "y": 0.0, "rx": 0.0, "ry": 0.0}
    state, _ = lubrication.turning(
        body(), spin, 0.0, 1000.0, held=held, clearance=PLAY, ball_density=7800.0
    )
    return state, lubrication.lubricate(body(), state, OIL, spin, PLAY)


def figures(**options):
    # the contacts of `thrust` have no film in the gap
    common = {
        "models": "paper",
        "held": {"rx": 0.0, "ry": 0.0},
        "clearance": PLAY,
        "four_point": ANGLE,
    }
    return operating_point.figures("6208", "mineral", ROOT / "inputs", **(common | options))


def grooves(found, key):
    """Return the values of `key` as an array (raceway, groove, ball)."""
    balls = [[one[key] for one in ball["contacts"]] for ball in found["balls"]]
    return np.array(balls).T.reshape(2, 2, -1)


@pytest.mark.parametrize("way", [1, -1])
def test_thrust_is_that_of_an_angular_contact(way):
    """A thrust loads only one groove of each ring, so all results equal those of a bearing with
    this groove only."""
    found = figures(axial=way * 1000.0, rpm=RPM)
    state, films = thrust()
    load = grooves(found, "q_N")
    inner, outer = (1, 0) if way > 0 else (0, 1)
    assert not load[0, 1 - inner].any() and not load[1, 1 - outer].any()
    assert load[0, inner] == pytest.approx(state.inner.load, rel=1e-7)
    for key, side, groove, want in (
        ("angle_rad", 1, outer, way * state.outer.angle),
        ("p_Pa", 0, inner, state.inner.pressure),
        ("h_min_m", 1, outer, films.outer.h_min),
        ("lambda", 0, inner, films.inner.ratio),
    ):
        assert grooves(found, key)[side, groove] == pytest.approx(want, rel=1e-7)
    assert found["capacitance_F"] == pytest.approx(films.total, rel=1e-7)
    assert found["stiffness_z_N_m"] == pytest.approx(state.stiffness[2, 2], rel=1e-6)
    beside = ring_response.dampers(body(), state, films, OIL, "paper", clearance=PLAY)
    want = response(state.linear, beside.damping).damping
    assert found["damping_z_N_s_m"] == pytest.approx(want[2, 2], rel=1e-6)
    start = sum(body().groove_gap(side) for side in (0, 1)) * np.sin(ANGLE)
    assert found["shift_z_m"] == pytest.approx(way * (state.shift[2] - start), rel=1e-6)


def test_radial_load_is_carried_by_four_points():
    found = figures(load=2000.0, clearance=0.0, rpm=RPM)
    load, angle, electric = (grooves(found, key) for key in ("q_N", "angle_rad", "capacitance_F"))
    assert (load > 0).all(1).any()
    assert load[:, 0] == pytest.approx(load[:, 1], rel=1e-9)
    azimuth = np.array([ball["azimuth_rad"] for ball in found["balls"]])
    carried = (load[0] * np.cos(angle[0]) * np.cos(azimuth)).sum()
    assert carried == pytest.approx(2000.0, rel=1e-9)
    ring = electric.sum(1)  # the two grooves of a ring are in parallel
    live = ring.min(0) > 0
    ball = np.where(live, ring.prod(0) / np.where(live, ring.sum(0), 1.0), 0.0)
    assert [one["capacitance_F"] for one in found["balls"]] == pytest.approx(ball, rel=1e-9)
    assert found["loaded_balls"] == live.sum()
    assert found["shift_z_m"] == 0 and found["residual_N"] < 1e-6


@pytest.fixture
def stated(tmp_path):
    """Return a four-point contact bearing whose file states its angle and its ratings."""
    text = (ROOT / "inputs/bearings/6208").read_text()
    path = tmp_path / "QJ"
    path.write_text(text + "variable four_point index 35\n")
    assert inputs.ratings(path) is not None
    return str(path)


def test_life_of_a_bearing_that_its_file_rates(stated):
    # these values are for deep groove ball bearings
    assert "life_reference_Mrev" not in figures(axial=1000.0)
    found = operating_point.figures(
        stated, held={"rx": 0.0, "ry": 0.0}, clearance=PLAY, axial=1000.0, rpm=RPM
    )
    state, _ = thrust()
    rated = inputs.ratings(Path(stated))
    dynamic = rated.dynamic / 2**0.7  # rating of one row
    want = life.reference(body(), dynamic, state.inner.load, state.outer.load, ANGLE)
    assert found["life_reference_Mrev"] == pytest.approx(want, rel=1e-6)
    # two equally loaded grooves have twice the failure rate
    both = operating_point.figures(stated, held={"rx": 0.0, "ry": 0.0}, load=2000.0)
    load = grooves(both, "q_N")
    one = life.reference(body(), dynamic, load[0, 0], load[1, 0], ANGLE)
    assert both["life_reference_Mrev"] == pytest.approx(one * 2**-0.9, rel=1e-6)


@pytest.mark.parametrize("name", ["QJ205", "QJ208", "QJ310"])
@pytest.mark.parametrize("loads, factor", [({"axial": 1.0}, 1.07), ({"load": 1.0}, 1.0)])
def test_equivalent_load_of_the_maker(name, loads, factor):
    """SKF (General Catalogue 6000, page 455) states P = F_r for a radial load and P = 1.07 F_a for
    a thrust. The ball loads give factors that are 4 to 9 % smaller, as for angular contact
    bearings. If C were the rating of one row, P would be wrong by a factor of 1.6."""
    rated = inputs.ratings(ROOT / "inputs/bearings" / name)
    given = {key: 0.02 * rated.static * value for key, value in loads.items()}
    found = operating_point.figures(name, None, ROOT / "inputs", held={"rx": 0, "ry": 0}, **given)
    assert found["equivalent_load_N"] == pytest.approx(factor * sum(given.values()), rel=0.09)


def test_ellipse_over_the_middle(stated):
    def warned(load):
        text = figures(load=load, clearance=0.0, four_point=np.radians(10))["warnings"]
        return any("its grooves meet at" in one for one in text)

    assert warned(5000.0) and not warned(50.0)


def test_command(capsys, monkeypatch):
    monkeypatch.chdir(ROOT)
    arguments = ["static", "--axial", "1000", "--four-point", "35"]
    text = reply(capsys, arguments)
    assert "four-point contact angle                  35 °" in text
    rows = text.split("\nBalls\n")[1].splitlines()
    assert len(rows) == 19 and len({len(row) for row in rows}) == 1
    contacts = answer(capsys, arguments)["balls"][0]["contacts"]
    assert [one["raceway"] for one in contacts] == ["inner 0", "inner 1", "outer 0", "outer 1"]


@pytest.mark.parametrize(
    "arguments, said",
    [
        (["--four-point", "80"], "must lie from 5 to 60 degrees"),
        (["--preload", "5e-6"], "apply to two rows; give --double-row"),
        (["--models", "paper", "--spin-law", "slices"], "--spin-law applies only to the friction"),
    ],
)
def test_wrong_command_line(capsys, arguments, said):
    assert said in reply(capsys, ["static", "--axial", "100", *arguments], code=2)


def test_bad_files(stated):
    with pytest.raises(inputs.InputError, match="needs a bearing with contact_angle 0"):
        operating_point.figures("7208", None, ROOT / "inputs", axial=100.0, four_point=ANGLE)
    path = Path(stated)
    with pytest.raises(inputs.InputError, match="a four-point contact bearing; this needs one"):
        inputs.bearing(path, one_groove="this needs one")
    path.write_text(path.read_text().replace("four_point index 35", "four_point index 2"))
    with pytest.raises(inputs.InputError, match="is 2, must be from 5 to 60, or 0"):
        operating_point.figures(stated, axial=100.0)


def test_stiffness_of_two_rows_and_four_points():
    """Rows that are far apart share a radial load and a thrust, whereas a tilt loads the rows in
    opposite directions. Under a thrust, a four-point contact bearing acts like a bearing with one
    groove per ring, also in a table for rotor programs."""
    apart, oil = 0.2, {"lubricant": "vg46", "phases": 2}
    rows = DoubleRow(apart, 0.0, "back_to_back")
    (two,) = rotor.points("6208", 1000.0, 1000.0, double_row=rows, clearance=-5e-6, **oil)
    (half,) = rotor.points("6208", 500.0, 1000.0, clearance=-5e-6, **oil)
    for found, want in zip(two.over.mean, half.over.mean):
        assert np.diag(found)[:3] == pytest.approx(2 * np.diag(want)[:3], rel=1e-6)
        tilt = 2 * (want[1, 1] * (apart / 2) ** 2 + want[3, 3])
        assert found[3, 3] == pytest.approx(tilt, rel=1e-6)
    held = {"clearance": PLAY, "axial": 1000.0, **oil}
    (four,) = rotor.points("6208", 0.0, RPM, four_point=ANGLE, folder=ROOT / "inputs", **held)
    (single,) = rotor.points(body(), 0.0, RPM, **held)
    beside = OF_6208.four_point(ANGLE).layout.inner[0][1]  # m, axial position of the loaded groove
    turn = np.eye(5)
    turn[0, 4], turn[1, 3] = beside, -beside
    for found, want in zip(four.over.mean, single.over.mean):
        assert np.diag(found) == pytest.approx(np.diag(turn.T @ want @ turn), rel=1e-6)


def test_two_rows_live_as_the_standard_says():
    """By ISO 281, C of two rows is 2^0.7 times C of one row. Under twice the load, each row has the
    life of a single row under the single load, and the life of both rows together is 2^-0.9 times
    this life."""
    options = {"held": {"rx": 0.0, "ry": 0.0}, "folder": ROOT / "inputs"}
    one = operating_point.figures("6208", load=1000.0, **options)
    two = operating_point.figures("6208", load=2000.0, double_row=DoubleRow(0.02), **options)
    assert two["q_inner_max_N"] == pytest.approx(one["q_inner_max_N"], rel=1e-6)
    ratio = two["life_reference_Mrev"] / one["life_reference_Mrev"]
    assert ratio == pytest.approx(2**-0.9, rel=1e-6)
    assert len(two["balls"]) == 18 and two["row_spacing_m"] == 0.02


def test_four_points_on_a_shaft():
    """`raceway shaft` accepts the file of a four-point contact bearing. The results for a short
    stiff shaft on one such bearing agree with the statics of the bearing."""
    four = inputs.bearing(catalogue.find("bearings", "QJ208"))
    beam = shaft.Shaft([Section(0.02, 0.2)], Steel(young=2.1e14))
    loads = [shaft.Load(0.01, (500.0, 0.0, 1000.0), (2.0, 1.0))]
    (carried,) = shaft.rest(beam, [shaft.Seat(0.01, four)], loads).bearings
    want = static.equilibrium(four, 500.0, 1000.0, moment=(2.0, 1.0))
    assert carried.place == pytest.approx([*want.shift, *want.tilt], rel=1e-6)
    assert carried.state.inner.load == pytest.approx(want.inner.load, rel=1e-6, abs=1e-6)


def test_heat_command(capsys, monkeypatch):
    """At the steady temperature, the power losses computed by statics equal the cooling power, for
    both kinds of bearing."""
    monkeypatch.chdir(ROOT)
    arguments = ["--bearing", "7208", "--double-row", "0.018", "--preload", "5e-6", "--load", "500"]
    cooling = ["--nodes", "1", "1", "1", "--rpm", "1000", "--json"]
    found = json.loads(reply(capsys, ["heat", *arguments, *cooling]))
    rises = [found[f"temperature_{part}_C"] - 20 for part in ("inner", "outer")]
    assert sum(rises) == pytest.approx(found["power_loss_W"], rel=5e-3)
    assert "--double-row" in reply(capsys, "heat --load 1 --rpm 1000 --preload 5e-6", code=2)
