# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of reading files: rejected files, messages, lines found in recordings, and the command."""

import math
from pathlib import Path

import numpy as np
import pytest
from commands import answer, reply
from raceway import catalogue, identify, kinematics, line_table, orders, prediction, readings
from raceway.errors import RacewayError
from raceway.recordings.prediction import Predicted
from raceway.recordings.readings import Point, Reading
from raceway.theory import cage_speed

GOOD = """
bearing: 6205
lubricant: vg68
known: {load: 10, axial: 30, temperature: 40}
unknown: {clearance: 0 15e-6}
readings:
  - {rpm: 1797, BPFO: 3.5972, within: 2e-4}
"""


def write(tmp_path, text=GOOD):
    path = tmp_path / "readings.yaml"
    path.write_text(text)
    return path


@pytest.mark.parametrize(
    "old, new, says",
    [
        ("bearing: 6205", "", "bearing is missing"),
        ("bearing: 6205", "bearing: 62055", "there is no ball bearing '62055'"),
        ("bearing: 6205", "bearing: [6205]", "bearing must be one name"),
        ("bearing: 6205", "bearings: 6205", "bearings is not one of bearing, lubricant"),
        ("vg68", "vg68\nmodels: fuller", "models 'fuller' is not one of paper, full, eyring"),
        ("load: 10", "load: ten", "known: load is ten, must be a number"),
        ("load: 10", "load: -1", "known: load is -1, must be from 0 to 1e.06"),
        ("load: 10", "clearance: 1e-6", "clearance is under both known and unknown"),
        (", temperature: 40", "", "reading 1: the temperature of the oil is missing"),
        ("0 15e-6", "15e-6 0", "1.5e-05 must be below 0"),
        ("0 15e-6", "15e-6", "needs a range of two numbers"),
        ("clearance: 0 15e-6", "", "unknown is empty"),
        ("rpm: 1797", "rpm: 0", "rpm 0 must be positive"),
        ("rpm: 1797, ", "", "rpm is missing"),
        (", within: 2e-4", "", "within, its standard deviation, is missing"),
        ("BPFO: 3.5972", "BPFO: 3.5972, BPFI: 5.4", "has 2"),
        ("BPFO", "BPF", "BPF is not one of rpm"),
        ("BPFO: 3.5972, within: 2e-4", "file: none.mat", "there is no file"),
        ("BPFO: 3.5972", "file: none.mat", "within cannot be given with file"),
        ("within: 2e-4", "within: 2e-4, line: BPFO", "line cannot be given without file"),
        ("BPFO: 3.5972, within: 2e-4", "file: none.mat, nominal: 1800", "rpm, the true speed, or"),
        ("BPFO: 3.5972, within: 2e-4", "file: [none.mat]", "file must be one name"),
        ("BPFO: 3.5972", "capacitance: 25", "capacitance is 25, must be from 0 to 1e-06"),
        ("BPFO: 3.5972", "BPFO: 107.7", "reading 1: BPFO = 107.7 orders matches no contact angle"),
        ("BPFO: 3.5972", "BPFI: 3.5972", "BPFI = 3.5972 orders matches no contact angle"),
        ("BPFO: 3.5972", "BSF: 4.714", "BSF = 4.714 orders matches no contact angle"),
    ],
)
def test_mistakes(tmp_path, old, new, says):
    with pytest.raises(RacewayError, match=says):
        readings.read(write(tmp_path, GOOD.replace(old, new)))


@pytest.mark.parametrize("name", orders.LINES)
def test_an_angle_gives_its_line(name):
    """If the contact angle is found from a line, kinematics with this angle reproduces the line."""
    from raceway import catalogue, inputs

    body = inputs.bearing(catalogue.find("bearings", "6205"))
    field = {"FTF": "cage", "BPFO": "outer", "BPFI": "inner", "BSF": "spin"}[name]
    for degrees in (3.0, 9.5, 25.0):
        order = float(getattr(kinematics.frequencies(body, math.radians(degrees)), field))
        found = orders.angle(body, name, order, 1e-5)
        assert math.degrees(found.value) == pytest.approx(degrees, abs=1e-6)
        assert found.low < found.value < found.high
    with pytest.raises(ValueError, match="matches no contact angle"):
        orders.angle(body, name, 8.0 if name != "BSF" else -8.0)


def test_a_line_of_a_recording(tmp_path):
    """The order of a line, its uncertainty and the shaft speed are found in the signal."""
    rate, shaft, order = 24000.0, 29.93, 3.5972
    time = np.arange(int(4 * rate)) / rate
    since = (order * shaft * time) % 1 / (order * shaft)
    noise = np.random.default_rng(1).normal(size=len(time))
    values = np.exp(-1500 * since) * np.sin(2 * np.pi * 4000 * since) + 0.02 * noise
    values += sum(0.1 * np.sin(2 * np.pi * n * shaft * time + n) for n in (1, 2, 3))
    np.savez(tmp_path / "1797_OR@6_7_DE48.npz", DE=values)
    row = "file: 1797_OR@6_7_DE48.npz, rate: 24000, line: BPFO"
    path = write(tmp_path, GOOD.replace("rpm: 1797, BPFO: 3.5972, within: 2e-4", row))
    (one,) = readings.read(path).readings
    assert one.point.rpm == pytest.approx(60 * shaft, rel=3e-5)
    assert abs(one.value - order) < 3 * one.within < 1e-3
    with pytest.raises(RacewayError, match="has no line BPFI; it has BPFO"):
        readings.read(write(tmp_path, path.read_text().replace("line: BPFO", "line: BPFI")))
    np.savez(tmp_path / "1797_OR@6_7_DE48.npz", DE=noise)
    with pytest.raises(RacewayError, match="no lines of the shaft near 1797 rpm: give its true"):
        readings.read(path)


def test_an_error_of_the_cage_is_common_to_its_lines():
    """Two lines that both determine the cage speed with the same relative error count as one
    reading with this error divided by sqrt(2). The error of the model and the effect of pocket play
    are added to it (Sherman-Morrison formula). A wide range of slip is penalised in proportion to
    the widening of the lines."""
    read, within, more = 0.4, 1e-4, 1e-3
    points = [Point(1797.0)] * 2
    rows = [
        Reading("FTF", read, within, points[0]),
        Reading("BPFO", 9 * read, 9 * within, points[1]),
    ]
    error = cage_speed.ERROR * (read + more)
    own = [Predicted(share * (read + more), share * error, (0.0, 0.0), 0, 0.0) for share in (1, 9)]
    for play in (0.0, 0.02):
        lags = np.array([[-play / 2, play / 2]] * 2)
        one = prediction.misfit(rows, own, lags)
        wide = (read + more) ** 2 * (cage_speed.ERROR**2 + play**2 / 12)
        assert one.independent @ one.independent == pytest.approx(more**2 / (within**2 / 2 + wide))
        assert one.width == pytest.approx(np.log1p(2 * wide / within**2))
        assert one.relative == pytest.approx([more / np.hypot(within, np.sqrt(wide))] * 2)
    apart = [rows[0], rows[1]._replace(point=Point(3000.0))]
    two = prediction.misfit(apart, own, np.zeros((2, 2)))
    assert two.independent @ two.independent == pytest.approx((two.relative**2).sum())


def lines(tmp_path, text):
    path = tmp_path / "lines.csv"
    path.write_text(text)
    return path


@pytest.mark.parametrize(
    "text, options, says",
    [
        ("bpfo_Hz\n107", {}, "has no column speed_Hz"),
        ("speed_Hz,bpf_Hz\n30,107", {}, "column bpf_Hz is not one of speed_Hz, bpfo_Hz"),
        ("speed_Hz,bpfo_Hz\n30,", {}, "has no line"),
        ("speed_Hz,bpfo_Hz\n,107", {}, "speed_Hz nan must lie between"),
        ("speed_Hz,bpfo_Hz\n-30,107", {}, "speed_Hz -30 must lie between 0.001 and"),
        ("speed_Hz,bpfo_Hz\n30,one", {}, "line 2: bpfo_Hz is 'one', must be a finite number"),
        ("speed_Hz,bpfo_Hz\n30,inf", {}, "line 2: bpfo_Hz is 'inf', must be a finite number"),
        ("speed_Hz,bpfo_Hz\n9,30,107", {}, "line 2: 3 cells, must be 2 as in the heading"),
        ("speed_Hz,bpfo_Hz,ftf_Hz\n30,107,12,", {}, "line 2: 4 cells, must be 3"),
        ("speed_Hz,bpfo_Hz,ftf_Hz\n30,107", {}, "line 2: 2 cells, must be 3"),
        ("speed_Hz,bpfo_Hz,bpfo_Hz\n30,107,108", {}, "column bpfo_Hz occurs 2 times"),
        ("speed_Hz,bpfo_Hz\n", {}, "has no rows"),
        ("speed_Hz,bpfo_Hz\n1797,107", {}, "lines.csv: reading 1: BPFO = .* no contact angle"),
        ("", {}, "has no rows"),
        ("speed_Hz,bpfo_Hz,load_N\n30,107,\n30,107,5", {}, "load_N nan must lie between 0 and"),
        ("speed_Hz,bpfo_Hz,load_N\n30,107,5", {"load": 1.0}, "leave out the load 1"),
        ("speed_Hz,bpfo_Hz\n30,107", {"models": "half"}, "models 'half' is not one of paper"),
    ],
)
def test_mistakes_in_a_table_of_lines(tmp_path, text, options, says):
    with pytest.raises(RacewayError, match=says):
        line_table.read(lines(tmp_path, text), "6205", **options)


def test_unknowns_of_a_table_of_lines(tmp_path):
    """Quantities that are given neither in the table nor by an option are treated as unknown. A
    contact angle determines the clearance."""
    path = lines(tmp_path, "speed_Hz,ftf_Hz,load_N\n30,11.9,5\n")
    given = line_table.read(path, "6205")
    assert set(given.unknown) == {"clearance", "axial", "temperature"}
    assert (given.readings[0].point.rpm, given.readings[0].point.load) == (1800, 5)
    assert set(line_table.read(path, "7205B", temperature=50).unknown) == {"axial"}


def test_lines_of_hidden_clearance_and_thrust(tmp_path, capsys, monkeypatch):
    """The lines are computed by statics and have no errors. A single line determines only a curve
    through the true state. If the ball's spin and a second load are added, the angle is determined.
    The intervals include the true values of clearance, thrust and angle, and zero slip."""
    monkeypatch.setattr(identify, "TRIED", 2)
    monkeypatch.setattr(identify, "VALLEY", 4)
    true = {"clearance": 8e-6, "axial": 90.0}
    path = catalogue.find("bearings", "6205"), catalogue.find("lubricants", "vg46")
    rows = [
        readings.Reading(name, 1.0, 1.0, readings.Point(1800.0, load=load, at=40.0))
        for load in (10.0, 40.0)
        for name in ("BPFO", "BSF")
    ]
    of = prediction.Model(readings.Readings(*path, "paper", {}, {}, rows)).predict(true)
    head = "speed_Hz,load_N,temperature_C,bpfo_Hz"
    tables = (
        f"{head}\n30,10,40,{30 * of[0].value!r}\n",
        f"{head},bsf_Hz\n"
        f"30,10,40,{30 * of[0].value!r},{30 * of[1].value!r}\n"
        f"30,40,40,{30 * of[2].value!r},{30 * of[3].value!r}\n",
    )
    for number, table in enumerate(tables):
        words = ["--lines", str(lines(tmp_path, table)), "--bearing", "6205", "--models", "paper"]
        found = answer(capsys, ["identify", *words])
        truth = {"clearance_m": 8e-6, "axial_N": 90.0}
        truth["contact_angle_deg"] = math.degrees(of[0].angle)
        for key, value in truth.items():
            _, low, high = found[key]
            assert low < value < high, (number, key)
        assert found["slip"][1] < 0 < found["slip"][2] and found["load_N"] is None
        least, middle, most = (found["contact_angle_deg"][k] for k in (1, 0, 2))
        assert most - least < 4 and middle == pytest.approx(truth["contact_angle_deg"], abs=1)
        if number == 0:
            ridge = np.array(found["ridge"])
            assert np.interp(90.0, *ridge[:, ::-1].T) == pytest.approx(8e-6, abs=1.5e-6)
    assert "give a FILE of readings, or --lines CSV" in reply(capsys, "identify", code=2)
    for option in ("load 5", "bearing 6208", "lubricant vg46", "within 2e-4"):
        said = reply(capsys, f"identify readings.yaml --{option}", code=2)
        assert f"--{option.split()[0]} applies to --lines" in said


def test_loads_that_no_state_carries_are_left_out(tmp_path):
    """In part of this range of thrust, the balls are forced out of their grooves. The valley of the
    misfit ends at the boundary of this part."""
    text = GOOD.replace("axial: 30, ", "").replace("0 15e-6", "0 15e-6, axial: 10 1e6")
    text = text.replace("\nknown:", "\nmodels: paper\nknown:")
    found = identify.identify(readings.read(write(tmp_path, text)))
    assert found.chi < 1e-2 and found.values["axial"].high < 1e4


def test_command(tmp_path, capsys):
    """The command prints settings for a deck, and reports a reading that cannot be explained by any
    clearance."""
    path = str(write(tmp_path))
    said = reply(capsys, ["identify", path])
    assert "-var bearing 6205 -var lubricant vg68 -var models full -var rpm 1797" in said
    own = tmp_path / "mine"
    own.write_text(Path("inputs/bearings/6205").read_text())
    assert f"-var bearing {own} -var lubricant vg68" in reply(
        capsys, ["identify", write(tmp_path, GOOD.replace("6205", str(own)))]
    )
    row = "\n  - {rpm: 1797, BPFO: 3.55, within: 1e-4}"
    said = answer(capsys, ["identify", write(tmp_path, GOOD.rstrip() + row)])
    assert max(abs(one["residual"]) for one in said["readings"]) > 3 and said["chi_squared"] > 9


def test_a_contact_angle_is_not_negative(tmp_path):
    """Its interval ends at 0 if a line does not exclude that balls roll at the groove's bottom."""
    text = GOOD.replace("0 15e-6", "-40e-6 15e-6").replace("3.5972", "3.5855")
    text = text.replace("2e-4", "1e-3").replace("\nknown:", "\nmodels: paper\nknown:")
    found = identify.identify(readings.read(write(tmp_path, text))).angle
    assert found.low == 0 < found.best < found.high < math.radians(8)


def test_angle_beside_a_temperature_that_was_read_first(tmp_path, capsys):
    """The contact angle follows from the line whatever the order of the readings."""
    line = "  - {rpm: 1797, BPFO: 3.5972, within: 2e-4}"
    rows = ["  - {rpm: 1797, temperature: 40, within: 1}", line]
    head = GOOD.split("readings:")[0].replace(", temperature: 40", "")
    head = head.replace("unknown: {", "models: paper\nunknown: {temperature: 30 50, ")
    head += "readings:\n"
    angles = []
    for order in (rows, rows[::-1]):
        angles.append(
            answer(capsys, ["identify", write(tmp_path, head + "\n".join(order))])[
                "contact_angle_deg"
            ]
        )
    assert angles[0][0] > 5 and angles[0] == pytest.approx(angles[1], abs=0.05)
