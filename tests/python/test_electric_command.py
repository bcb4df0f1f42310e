# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of `raceway electric` and its functions: agreement of the results with each other and with
statics, films inferred from measured values, pictures, messages and exit codes."""

import csv
import json
import math
import re

import numpy as np
import pytest
from commands import answer, drawn, reply
from host import ROOT
from raceway import electric_point, film_reading, film_voltage, operating_point
from raceway.cli import main
from raceway.theory import asperity
from raceway.theory.bearing import DoubleRow
from raceway.theory.capacitors import Filling
from raceway.theory.electric_point import Ask
from raceway.theory.static import STRAIGHT
from raceway.theory.validity import Shoulders

pytestmark = pytest.mark.usefixtures("in_the_tree")


@pytest.fixture(scope="module")
def point():
    return electric_point.solve("6208", "vg46", ROOT / "inputs", load=3000.0, rpm=1500.0)


def printed(capsys, *arguments):
    return reply(capsys, ["electric", *arguments])


GROOVES = [{}, {"four_point": math.radians(35)}, {"double_row": DoubleRow(20e-3, 5e-6)}]


@pytest.mark.parametrize("grooves", GROOVES)
def test_parts_add_up(grooves):
    point = electric_point.solve("6208", "vg46", load=3000.0, rpm=1500.0, phase=0.1, **grooves)
    found = electric_point.figures(point)
    parts = ("capacitance_F", "capacitance_surroundings_F", "capacitance_unloaded_F")
    assert sum(found[part] for part in parts) == pytest.approx(found["capacitance_total_F"])
    assert sum(ball["capacitance_F"] for ball in found["balls"]) == pytest.approx(
        found["capacitance_total_F"]
    )
    assert found["plates_factor"] == found["capacitance_total_F"] / found["capacitance_F"]
    for ball in found["balls"]:
        one, other = ball["capacitance_inner_F"], ball["capacitance_outer_F"]
        assert ball["capacitance_F"] == pytest.approx(one * other / (one + other))


@pytest.mark.parametrize("grooves", GROOVES)
@pytest.mark.parametrize("models", ["paper", "full"])
@pytest.mark.parametrize("axial", [0.0, 700.0])
def test_plates_are_those_of_statics(models, grooves, axial):
    same = dict(load=1000.0, axial=axial, rpm=3000.0, clearance=10e-6, temperature=60.0)
    same |= grooves | dict(phase=0.2, models=models)
    found = electric_point.figures(electric_point.solve("6306", "vg68", **same))
    held = STRAIGHT if axial else None
    statics = operating_point.figures("6306", "vg68", held=held, **same)
    for key in ("capacitance_F", "h_c_m", "lambda"):
        assert found[key] == pytest.approx(statics[key], rel=1e-9)


def test_grooves_are_shown(capsys):
    words = "--bearing 7208 --load 1000 --rpm 900 --double-row 18e-3 --preload 5e-6"
    for command in (f"electric {words}", f"heat {words}", f"static {words}"):
        text = reply(capsys, command)
        assert re.search(r"distance of the rows +18 mm\n +preload of each row +5 µm\n", text)
        assert "back_to_back" in text
    for command in ("electric", "heat", "static"):
        text = reply(capsys, f"{command} --bearing QJ208 --load 1000 --rpm 900")
        assert re.search(r"four-point contact angle +35 °  \(of centred balls\)", text)


def test_a_preload_replaces_a_load(capsys):
    """Balls that a negative clearance loads equally have equal films."""
    found = answer(capsys, "electric --rpm 1500 --clearance -10e-6")
    statics = answer(capsys, "static --rpm 1500 --clearance -10e-6 --lubricant vg46")
    for key in ("capacitance_F", "h_c_m", "lambda"):
        assert found[key] == pytest.approx(statics[key], rel=1e-9)
    assert np.ptp([ball["q_inner_N"] for ball in found["balls"]]) < 1e-6


def test_two_rows_are_two_bearings_that_share_the_load():
    deep = dict(rpm=1500.0, models="paper")
    one = electric_point.solve("6208", "vg46", load=1500.0, **deep)
    two = electric_point.solve("6208", "vg46", load=3000.0, double_row=DoubleRow(20e-3), **deep)
    assert two.total() == pytest.approx(2 * one.total(), rel=1e-6)


def test_shoulders_are_the_file_s_unless_given(point):
    assert point.filling.shoulders == Shoulders(52.6e-3, 67.4e-3)
    deep = Filling(shoulders=Shoulders(inner=53.5e-3))
    other = electric_point.solve("6208", "vg46", load=3000.0, rpm=1500.0, filling=deep)
    assert other.filling.shoulders == Shoulders(53.5e-3, 67.4e-3)
    inner = [one.capacitors().inner.outside for one in (point, other)]
    assert np.all(inner[1] > inner[0])


def test_threshold_is_where_the_field_is_the_strength(point):
    """At the threshold voltage, the largest field equals the dielectric strength. A rough film
    fails at a lower voltage."""
    found = electric_point.figures(point, Ask(strength=20e6))
    at = electric_point.figures(point, Ask(voltage=found["threshold_V"]))
    assert at["field_V_m"] == pytest.approx(20e6)
    assert found["threshold_peaks_V"] < found["threshold_V"]
    assert found["stored_energy_J"] == pytest.approx(
        film_voltage.stored_energy(found["capacitance_total_F"], found["threshold_V"])
    )
    motor = electric_point.figures(point, Ask(strength=20e6, motor=(50e-12, 1e-9)))
    everything = 50e-12 / motor["bearing_voltage_ratio"]  # on the shaft, with two bearings
    assert motor["stored_energy_J"] == pytest.approx(
        film_voltage.stored_energy(everything, found["threshold_V"])
    )
    rough = electric_point.figures(point, Ask(voltage=found["threshold_peaks_V"], strength=20e6))
    assert rough["field_peaks_V_m"] == pytest.approx(20e6)


def test_warnings():
    """There is a warning if an ellipse extends beyond the shoulder, and if surfaces touch."""
    heavy = electric_point.solve("6208", "vg46", axial=20e3, clearance=20e-6, rpm=1500.0)
    assert any("reaches" in one for one in electric_point.figures(heavy)["warnings"])
    slow = electric_point.solve("6208", "vg46", load=3000.0, rpm=1.0)
    found = electric_point.figures(slow)
    assert any("conduct" in one for one in found["warnings"]) and found["metallic_contacts"] > 5
    light = electric_point.solve("6208", "vg46", load=500.0, rpm=5000.0)
    assert electric_point.figures(light)["warnings"] == []


def test_metallic_where_friction_is_mixed():
    """A contact is metallic if the asperities that cause its friction in statics carry more than
    0.01 of its load."""
    seen = set()
    for rpm in np.geomspace(100.0, 3000.0, 12):
        point = electric_point.solve("6208", "vg46", load=3000.0, rpm=rpm)
        top = max(electric_point.figures(point)["balls"], key=lambda ball: ball["q_inner_N"])
        mixed = operating_point.figures("6208", "vg46", load=3000.0, rpm=rpm, held=STRAIGHT)
        assert top["metallic_inner"] == (mixed["asperity_share"] > asperity.CONDUCTS)
        seen.add(top["metallic_inner"])
    assert seen == {False, True}


def test_impedance_and_leak(point):
    """At a high frequency, the impedance is capacitive; at a low frequency, it equals the leakage
    resistance."""
    capacitance = electric_point.figures(point)["capacitance_total_F"]
    fast = electric_point.figures(point, Ask(frequency=1e7, resistivity=1e9))
    assert fast["impedance_ohm"] == pytest.approx(1 / (2e7 * np.pi * capacitance), rel=1e-6)
    assert fast["phase_deg"] == pytest.approx(-90, abs=1e-3)
    slow = electric_point.figures(point, Ask(frequency=1e-3, resistivity=1e9))
    assert slow["impedance_ohm"] == pytest.approx(slow["leak_ohm"], rel=1e-6)
    assert electric_point.figures(point)["leak_ohm"] is None


def test_dry_gaps_without_load_leak_nothing():
    dry = electric_point.solve("6208", "vg46", load=3000.0, rpm=1500.0, filling=Filling("dry"))
    found = electric_point.figures(dry, Ask(frequency=1e4, resistivity=1e9))
    assert 0 < found["leak_ohm"] < np.inf and -90 < found["phase_deg"] < -89


def test_measured_capacitance_gives_the_film_back(point):
    """The capacitance that the model gives for a film thickness is converted back to that
    thickness. If only the plates are considered, the resulting film is too thin."""
    for scale in (0.3, 1.0, 2.5):
        measured = point.total(scale)
        found = electric_point.figures(point, Ask(measured=measured))
        assert found["measured_h_c_m"] == pytest.approx(scale * found["h_c_m"], rel=1e-9)
        assert found["measured_plates_m"] < found["measured_h_c_m"]


def test_reading_curve(point):
    curve = film_reading.curve(point, np.array([0.1, 0.5, 1.0, 4.0]))
    at = electric_point.figures(point, Ask(measured=curve.capacitance[1]))
    assert curve.by_plates[1] == pytest.approx(at["measured_plates_m"])
    assert film_reading.corrected(curve, curve.by_plates) == pytest.approx(curve.h_c)
    assert np.all(np.diff(curve.by_plates) > 0) and np.all(curve.by_plates < curve.h_c)
    assert curve.less_constant[2] == pytest.approx(curve.h_c[2])
    assert np.isnan(film_reading.corrected(curve, 1.0))


def test_command(capsys):
    more = "--c-wr 50e-12 --c-rf 1e-9 --frequency 1e4 --resistivity 1e9 --voltage 5"
    found = answer(capsys, f"electric --load 1000 --rpm 3000 {more}")
    both = 2 * found["capacitance_total_F"]
    assert found["bearing_voltage_ratio"] == pytest.approx(50e-12 / (1050e-12 + both))
    text = printed(capsys, "--load", "1000", "--rpm", "3000", "--measured", "3e-10")
    assert "from the whole model" in text and len(text.splitlines()) > 30
    two = printed(capsys, "--load", "500", "1000", "--rpm", "1000", "2000")
    assert len(two.splitlines()) == 5
    warm = answer(capsys, "electric --load 900 --rpm 900 --temperature 40 80")
    assert warm[1]["capacitance_total_F"] > warm[0]["capacitance_total_F"]


def test_measured_impedance_is_the_same_as_its_capacitance(capsys):
    point = "electric --load 1000 --rpm 3000"
    one = answer(capsys, f"{point} --measured 2e-10")
    ohm = 1 / (2 * np.pi * 1e4 * 2e-10)
    other = answer(capsys, f"{point} --measured-impedance {ohm:.12g} -90 --frequency 1e4")
    assert other["measured_h_c_m"] == pytest.approx(one["measured_h_c_m"], rel=1e-9)


@pytest.mark.parametrize(
    ("kind", "arguments"),
    [
        ("parts", ["--load", "1000", "--rpm", "100", "1000", "10000"]),
        ("parts", ["--load", "1000", "--rpm", "900", "--clearance", "-5e-6", "0", "2e-5"]),
        ("field", ["--load", "1000", "--rpm", "900", "--voltage", "5"]),
        ("bode", ["--load", "1000", "--rpm", "900", "--resistivity", "1e9"]),
        ("reading", ["--load", "1000", "--rpm", "900"]),
    ],
)
def test_pictures(capsys, tmp_path, kind, arguments):
    out = tmp_path / "picture.png"
    assert printed(capsys, *arguments, "--kind", kind, "--out", str(out)).splitlines()[-1] == str(
        out
    )
    drawn(out)


def test_tables(capsys, tmp_path):
    path = tmp_path / "table.csv"
    printed(capsys, "--load", "1000", "--rpm", "100", "1000", "--csv", str(path))
    with open(path) as file:
        rows = list(csv.DictReader(file))
    assert [float(row["rpm"]) for row in rows] == [100, 1000]
    assert float(rows[0]["capacitance_total_F"]) > float(rows[1]["capacitance_total_F"]) > 0
    out = str(tmp_path / "reading.png")
    reply(capsys, f"electric --load 1000 --rpm 900 --kind reading --out {out} --csv {path}")
    with open(path) as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == len(film_reading.FACTORS)
    assert float(rows[0]["read_by_plates_m"]) < float(rows[0]["h_c_m"])


POINT = ["--load", "1000", "--rpm", "900"]


@pytest.mark.parametrize(
    ("arguments", "code", "message"),
    [
        (["--load", "1000"], 2, "give --rpm"),
        (["--rpm", "900"], 2, "a load or a preload is needed"),
        ([*POINT, "--c-wr", "1e-11"], 2, "--c-wr and --c-rf must be given together"),
        ([*POINT, "--kind", "bode"], 2, "--kind and --out must be given together"),
        ([*POINT, "--kind", "parts", "--out", "x.png"], 2, "several values of one quantity"),
        ([*POINT, "--kind", "field", "--out", "x.png"], 2, "give --voltage"),
        ([*POINT, "--kind", "bode", "--out", "x.png"], 2, "give --resistivity"),
        ([*POINT, "--surroundings", "wet"], 2, "give flooded, dry or cavitated EPS_OUT"),
        ([*POINT, "--surroundings", "cavitated"], 2, "give flooded, dry or cavitated EPS_OUT"),
        ([*POINT, "--surroundings", "cavitated", "x"], 2, "'x' is not a number"),
        ([*POINT, "--surroundings", "cavitated", "9"], 2, "outlet = 9.0 must be from 1"),
        ([*POINT, "--shoulders", "0.04", "0.07"], 2, "shoulder diameter = 0.04 m"),
        ([*POINT, "--measured", "1e-13"], 2, "films from 0.001 to 1000 times"),
        ([*POINT, "--measured-impedance", "1e5", "-90"], 2, "needs --frequency"),
        ([*POINT, "--frequency", "1", "--measured-impedance", "1", "9"], 2, "-90 to 0 deg"),
        ([*POINT, "--bearing", ""], 1, "there is no ball bearing ''"),
        ([*POINT, "--lubricant", "dry"], 1, "has no viscosity"),
        ([*POINT, "--lubricant", "mineral", "--temperature", "70"], 1, "values for 40 C only"),
        ([*POINT, "--csv", "/nowhere/x.csv"], 1, "cannot write /nowhere/x.csv"),
    ],
)
def test_messages(capsys, arguments, code, message):
    assert message in reply(capsys, ["electric", *arguments], code)


def test_paths_of_files_stay_out_of_the_json(capsys, tmp_path):
    words = ["electric", "--load", "2000", "--rpm", "1000", "--lubricant", "vg46", "--json"]
    assert main([*words, "--csv", str(tmp_path / "points.csv")]) in (0, None)
    said = capsys.readouterr()
    assert json.loads(said.out)["bearing"] == "6208" and "points.csv" in said.err
