# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of `raceway heat` and its functions: heat balances, limits, messages and exit codes."""

import re
from dataclasses import replace

import numpy as np
import pytest
from commands import answer, reply
from host import ROOT
from raceway import contact_friction, film, heat, heat_scene, hertz, inputs, steady_heat
from raceway.core import laws
from raceway.errors import NoEquilibrium
from raceway.theory.bearing import INNER, DoubleRow
from raceway.theory.cage_drag import CageRing

pytestmark = pytest.mark.usefixtures("in_the_tree")


def scene(load=5000.0, rpm=1910.0, oil="vg46", **laws):
    path, data = ROOT / "inputs/bearings/6208", ROOT / "inputs/lubricants" / oil
    return heat_scene.Scene(
        inputs.bearing(path),
        inputs.lubricant(data),
        1e-7,
        load,
        0.0,
        rpm,
        size=inputs.size(path),
        **laws,
    )


def test_one_node_balances():
    found = heat_scene.one_node(scene(), 2.17, 20.0, 0.0)
    carried = 2.17 * (found["temperature_C"] - 20)
    assert found["power_loss_W"] == pytest.approx(carried, abs=0.05)
    assert sum(found["losses_W"].values()) == pytest.approx(found["power_loss_W"], rel=1e-12)
    parts = sum(found["sides"]) + found["cage"]
    assert parts == pytest.approx(found["power_loss_W"], rel=1e-12)


def test_three_nodes_balance_and_tend_to_one():
    one = heat_scene.one_node(scene(), 3.0, 20.0, 0.0)
    tight = heat_scene.three_nodes(scene(), heat_scene.Nodes(1.0, 2.0, 1e6), 20.0, 0.0)
    assert tight["temperature_C"] == pytest.approx(one["temperature_C"], abs=0.05)
    # at equal temperatures, thermal expansion does not change a clearance of zero
    assert tight["clearance_warm_m"] == pytest.approx(0, abs=5e-9)
    found = heat_scene.three_nodes(scene(), heat_scene.Nodes(0.5, 2.0, 1.0), 20.0, 20e-6)
    inner, outer = found["temperature_inner_C"], found["temperature_outer_C"]
    carried = 0.5 * (inner - 20) + 2.0 * (outer - 20)
    assert found["power_loss_W"] == pytest.approx(carried, abs=0.1)
    assert inner > outer and found["clearance_warm_m"] < 20e-6
    rises = (found[f"temperature_{part}_C"] - 20 for part in ("inner", "balls", "outer"))
    warm = 20e-6 + heat.clearance_change(scene().bearing, *rises)
    assert found["clearance_warm_m"] == pytest.approx(warm, abs=2e-9)


@pytest.mark.parametrize(
    "words",
    [
        "--load 2000 --rpm 1500",
        "--load 1000 --axial 1000 --bearing QJ208 --rpm 3000",
        "--axial 1000 --bearing 7208 --rpm 3000",
        "--load 1500 --axial 1000 --rpm 3000 --clearance 30e-6",
        "--rpm 1500 --clearance -10e-6",
        "--load 1000 --bearing 7208 --double-row 18e-3 --preload 5e-6 --rpm 1500",
    ],
)
def test_the_same_as_statics_at_that_temperature(capsys, words):
    """With a ball on the load line, as in statics, films are the same, and so are the warnings, on
    which the temperature depends as the friction torque does."""
    words += " --lubricant vg46"
    hot = answer(capsys, f"heat {words}")
    statics = answer(capsys, f"static {words} --temperature {hot['temperature_C']!r}")
    assert hot["warnings"] == statics["warnings"]
    bearing = ("four_point_rad", "row_spacing_m", "row_preload_m", "arrangement", "clearance_m")
    assert [hot.get(key) for key in bearing] == [statics.get(key) for key in bearing]
    for key in ("h_min_m", "h_c_m", "lambda", "viscosity_Pa_s"):
        assert hot[key] == pytest.approx(statics[key], rel=1e-6)
    assert hot["friction_torque_N_m"] == pytest.approx(statics["friction_torque_N_m"], rel=0.03)


@pytest.mark.parametrize(("rpm", "ratio"), [(48.0, 2.3), (477.5, 1.95), (1910.0, 1.1),
                                            (9549.0, 0.22)])  # fmt: skip
def test_film_by_the_bearing_s_own_temperature(bearing, rpm, ratio, monkeypatch):
    """The ratio is that of two central film thicknesses: with VG 46 oil, at an ambient temperature
    of 20 C and with cooling by ISO 15312, and with 0.04 Pa s and 22/GPa. Neither includes inlet
    shear. Inlets are flooded, as in the printed row."""

    def flooded(body, size, fluid, ring, models, supply):
        starved = laws.skf_starvation(
            40.0, 80.0, fluid.kinematic, abs(ring) * 30 / np.pi, 3e-8, 3.1
        )
        return contact_friction.Surfaces(
            film=None, starvation=float(starved), loss=0.01, oil_share=0.1
        )

    monkeypatch.setattr(contact_friction, "surfaces", flooded)
    found = heat_scene.one_node(scene(rpm=rpm, models="eyring"), 2.17, 20.0, 0.0)
    r_x, r_y = bearing.effective_radii(INNER)
    kappa, modulus = hertz.exact(r_x, r_y).kappa, bearing.effective_modulus
    fluid = inputs.fluid(ROOT / "inputs/lubricants/vg46", found["temperature_C"])
    speed = 0.724764 * rpm / 477.5
    thick = [
        film.h_c(r_x, film.group(eta, xi, modulus, r_x, kappa, speed, 2436.2))
        for eta, xi in ((fluid.viscosity, fluid.pressure_viscosity), (0.04, 22e-9))
    ]
    # the friction model differs from the one used for the printed row
    assert thick[0] / thick[1] == pytest.approx(ratio, rel=0.12)


def test_no_steady_state():
    with pytest.raises(NoEquilibrium, match="no steady temperature: power loss"):
        heat_scene.one_node(scene(rpm=9549.0), 0.05, 20.0, 0.0)


@pytest.mark.parametrize("spin_law", ["closed", "slices"])
@pytest.mark.parametrize("axial", [100.0, 300.0, 2000.0])
def test_every_loss_under_thrust_is_a_loss(axial, spin_law):
    """Also that of balls whose spin far exceeds their differential slip, and which drive a cage."""
    point = dict(axial=axial, rpm=3000.0, spin_law=spin_law, cage=CageRing())
    found = steady_heat.figures("7206B", "vg46", ROOT / "inputs", **point)
    assert min(found["losses_W"].values()) > 0


@pytest.mark.parametrize("command", ["heat", "electric", "static"])
def test_lines_of_several_points_name_their_axial_load(capsys, command):
    """Without an axial load the tables of heat and electric have no such column."""
    words = [command, "--load", "900", "--rpm", "2000", "--lubricant", "vg46", "--axial"]
    head, *rows = reply(capsys, [*words, "100", "300"]).splitlines()
    assert head.split("  ")[:2] == ["load N", "axial N"]
    assert [row.split()[:2] for row in rows[:2]] == [["900", "100"], ["900", "300"]]
    head = reply(capsys, [*words, "0", "--clearance", "0", "20um"]).splitlines()[0]
    assert ("axial N" in head) == (command == "static")
    assert ("cold P_d" in head) == (command == "heat")


def test_command(capsys):
    found = answer(capsys, "heat --load 5000 --rpm 1910")
    assert found["conductance_W_K"] == pytest.approx(2.17, abs=0.005)
    assert found["power_loss_W"] == pytest.approx(
        found["conductance_W_K"] * (found["temperature_C"] - 20), abs=0.05
    )
    assert found["reference_speed_rpm"] == pytest.approx(18000, rel=0.3)
    speeds = [f"reference_speed_{name}rpm" for name in ("", "dry_", "catalogue_")]
    for words in ("--double-row 18mm", "--four-point 35"):  # they are those of one row
        other = answer(capsys, f"heat --load 500 --rpm 1910 {words}")
        assert all(found[name] and other[name] is None for name in speeds)
    cold, hot = answer(capsys, "heat --load 500 5000 --rpm 1000")
    assert hot["temperature_C"] > cold["temperature_C"]
    assert len(reply(capsys, "heat --load 500 --rpm 500 1000").splitlines()) == 3


@pytest.mark.parametrize(
    ("arguments", "code", "message"),
    [
        (["--load", "1", "--rpm", "1", "--lubricant", "mineral"], 1, "has no physical data"),
        (
            ["--load", "1", "--rpm", "1", "--bearing", "harris209"],
            1,
            "no bearing_width, bore_diameter, outside_diameter",
        ),
        (["--load", "1"], 2, "give --rpm"),
        (
            ["--load", "2000", "--rpm", "1500", "--nodes", *["1e-320"] * 3],
            1,
            "no steady temperature up to 200 C",
        ),
        (["--rpm", "100"], 2, "a load or a preload is needed"),
        (["--load", "1", "--rpm", "0"], 2, "must lie from 1 to 100000 rpm"),
        (["--rpm", "9", "--nodes", "1", "1", "1", "--conductance", "1"], 2, "not allowed with"),
    ],
)
def test_messages(capsys, arguments, code, message):
    assert message in reply(capsys, ["heat", *arguments], code)


def test_an_angular_contact_bearing_is_cooled_as_one_of_its_size():
    """ISO 15312 needs only the bore, the outside diameter and the width to compute the cooling."""
    angular, deep = (steady_heat.Case(name, "vg46", rpm=1000.0) for name in ("7208", "6208"))
    assert angular.cooling() == deep.cooling()
    assert angular.steady(angular.scene())["temperature_C"] > 20


@pytest.mark.parametrize("name", ["reference_speed", "ball_density", "bore_diameter"])
def test_a_word_for_a_number_names_its_variable(capsys, tmp_path, name):
    text = (ROOT / "inputs/bearings/6208").read_text()
    words = re.sub(rf"^(variable {name} +index) \S+", r"\1 quick", text, flags=re.M)
    (tmp_path / "mine").write_text(words)
    assert f"mine: {name} = quick is not a number" in reply(
        capsys, ["heat", "--bearing", tmp_path / "mine", "--load", "9", "--rpm", "900"], code=1
    )


@pytest.mark.parametrize("spacing", [18e-3, 12.5e-3])
def test_width_of_two_rows(spacing):
    """Two bearings side by side, 18 mm wide, have twice the seats of one bearing (ISO 15312) and
    twice the surfaces in circulating oil. Closer rows have less."""
    one = steady_heat.Case("7208", "vg46", axial=500.0, rpm=3000.0, oil_flow=1e-5)
    two = replace(one, double_row=DoubleRow(spacing))
    assert two.cooling() == pytest.approx((1 + spacing / 18e-3) * one.cooling(), rel=1e-12)
    assert two.cooling() == pytest.approx(16e3 / 50 * np.pi * (18e-3 + spacing) * 0.12, rel=1e-12)
    fluid = inputs.lubricant("vg46").at(40.0)
    of_one, of_two = (
        heat.oil_flow(of.bearing, of.oil_flow.width, fluid, flow=17.0, inlet=20.0, orbit=130.0)
        for of in (one.scene(), two.scene())
    )
    wider = np.array([1 + spacing / 18e-3, 2.0, 1 + spacing / 18e-3])
    assert of_two.wetted == pytest.approx(wider * of_one.wetted, rel=1e-12)
