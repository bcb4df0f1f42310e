# SPDX-License-Identifier: GPL-2.0-or-later
"""Files of readings: refused files and their messages; lines of recordings; the command."""

import json
import math

import numpy as np
import pytest
from raceway import kinematics, orders, readings
from raceway.cli import main
from raceway.errors import RacewayError

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
        ("bearing: 6205", "bearing: 62055", "there is no bearing '62055'"),
        ("bearing: 6205", "bearings: 6205", "bearings is none of bearing, lubricant"),
        ("vg68", "vg68\nmodels: fuller", "models 'fuller' is none of paper, full, eyring"),
        ("load: 10", "load: ten", "known: load: 'ten' is not a number"),
        ("load: 10", "load: -1", "known: load: -1 must lie between 0 and 1e.06"),
        ("load: 10", "clearance: 1e-6", "clearance is known and unknown"),
        (", temperature: 40", "", "reading 1: the temperature of the oil is missing"),
        ("0 15e-6", "15e-6 0", "1.5e-05 must be below 0"),
        ("0 15e-6", "15e-6", "needs a range of two numbers"),
        ("clearance: 0 15e-6", "", "unknown is empty"),
        ("rpm: 1797", "rpm: 0", "rpm 0 must be positive"),
        ("rpm: 1797, ", "", "rpm is missing"),
        (", within: 2e-4", "", "within, its standard deviation, is missing"),
        ("BPFO: 3.5972", "BPFO: 3.5972, BPFI: 5.4", "has 2"),
        ("BPFO", "BPF", "BPF is none of rpm"),
        ("BPFO: 3.5972, within: 2e-4", "file: none.mat", "there is no file"),
    ],
)
def test_mistakes(tmp_path, old, new, says):
    with pytest.raises(RacewayError, match=says):
        readings.read(write(tmp_path, GOOD.replace(old, new)))


@pytest.mark.parametrize("name", orders.LINES)
def test_an_angle_gives_its_line(name):
    """The inverse of the kinematics."""
    from raceway import catalogue, inputs

    body = inputs.bearing(catalogue.find("bearings", "6205"))
    field = {"FTF": "cage", "BPFO": "outer", "BPFI": "inner", "BSF": "spin"}[name]
    for degrees in (3.0, 9.5, 25.0):
        order = float(getattr(kinematics.frequencies(body, math.radians(degrees)), field))
        found = orders.angle(body, name, order, 1e-5)
        assert math.degrees(found.value) == pytest.approx(degrees, abs=1e-6)
        assert found.low < found.value < found.high
    with pytest.raises(ValueError, match="belongs to no contact angle"):
        orders.angle(body, name, 8.0 if name != "BSF" else -8.0)


def test_a_line_of_a_recording(tmp_path):
    """Order and uncertainty of a line come from the signal, and so does the speed."""
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
    with pytest.raises(RacewayError, match="shows no line BPFI; it shows BPFO"):
        readings.read(write(tmp_path, path.read_text().replace("line: BPFO", "line: BPFI")))


def test_command(tmp_path, capsys):
    """Settings of a deck; a reading that no clearance explains is reported."""
    path = str(write(tmp_path))
    assert main(["identify", path]) == 0
    said = capsys.readouterr().out
    assert "-var bearing 6205 -var lubricant vg68 -var models full -var rpm 1797" in said
    row = "\n  - {rpm: 1797, BPFO: 3.55, within: 1e-4}"
    assert main(["identify", str(write(tmp_path, GOOD.rstrip() + row)), "--json"]) == 0
    said = json.loads(capsys.readouterr().out)
    assert max(abs(one["residual"]) for one in said["readings"]) > 3 and said["chi_squared"] > 9
