# SPDX-License-Identifier: GPL-2.0-or-later
"""A drifting state, tracked from readings that statics generated."""

import shutil

import numpy as np
import pandas as pd
import pytest
from raceway import track
from raceway.cli import main
from raceway.recordings import readings
from raceway.recordings.prediction import Model

FILE = """
bearing: 6205
lubricant: vg68
known: {load: 10, axial: 100}
unknown: {clearance: 0 15e-6, temperature: 20 90}
series: hours.csv
within: {BPFO: 1e-4, capacitance: 0.1e-12}
drift: {clearance: 2e-6, temperature: 25}
"""
ROWS = 12


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    """A folder with readings of oil that warms up while the clearance shrinks, with noise of the
    stated size and one gap; and the truth."""
    folder = tmp_path_factory.mktemp("track")
    random = np.random.default_rng(4)
    time = 600.0 * np.arange(ROWS)
    true = {
        "temperature": 70 - 40 * np.exp(-time / 2400),
        "clearance": 9e-6 - 4e-6 * (1 - np.exp(-time / 2400)),
    }
    table = pd.DataFrame({"time_s": time, "rpm": 1797.0, "BPFO": 3.6, "capacitance": 1e-11})
    table.to_csv(folder / "hours.csv", index=False)
    (folder / "hours.yaml").write_text(FILE)
    given = readings.series(folder / "hours.yaml")
    model = Model(given.readings)
    for k, (_, rows) in enumerate(given.rows):
        state = dict(given.readings.known, **{name: float(v[k]) for name, v in true.items()})
        for one, own in zip(rows, model.predict(state, rows)):
            error = np.hypot(one.within, own.error)
            table.loc[k, one.quantity] = own.value + error * random.normal()
    table.loc[5, "capacitance"] = np.nan
    table.to_csv(folder / "hours.csv", index=False)
    return folder, true


@pytest.fixture
def folder(made, tmp_path):
    """A copy of the folder, free to be modified, and the truth."""
    return shutil.copytree(made[0], tmp_path / "track"), made[1]


def test_a_warming_bearing(folder):
    """The truth stays within the band of two standard deviations, which becomes narrow."""
    path, true = folder
    out, table = path / "hours.png", path / "state.csv"
    assert main(["track", str(path / "hours.yaml"), "--out", str(out), "--csv", str(table)]) == 0
    assert out.stat().st_size > 10_000
    found = pd.read_csv(table)
    inside = 0
    for name, values in true.items():
        low, high = found[f"{name}_low"], found[f"{name}_high"]
        inside += int(((low <= values) & (values <= high)).sum())
    assert inside >= 0.85 * 2 * ROWS
    assert (found["temperature_high"] - found["temperature_low"]).iloc[-1] < 12
    assert (found["clearance_high"] - found["clearance_low"]).iloc[-1] < 3e-6
    assert 0.2 < found["surprise"].iloc[1:].mean() < 3


@pytest.mark.parametrize(
    "old, new, says",
    [
        ("series: hours.csv", "", "series is missing"),
        ("hours.csv", "other.csv", "cannot read"),
        ("BPFO: 1e-4, ", "", "within: BPFO is missing"),
        ("BPFO", "BPF", "BPF is not one of"),
        ("clearance: 2e-6", "axial: 2", "drift: axial is not an unknown"),
        ("clearance: 2e-6", "clearance: -1", "drift: clearance: -1 must lie between"),
        ("series: hours.csv", "series: [hours.csv]", "series must be one name"),
        (FILE, "", "the file must be a map"),
        (FILE, "- hours.csv", "the file must be a map"),
    ],
)
def test_mistakes(folder, capsys, old, new, says):
    path = folder[0] / "hours.yaml"
    path.write_text(FILE.replace(old, new))
    assert main(["track", str(path)]) == 1
    assert says in capsys.readouterr().err


def test_times_must_rise(folder, capsys):
    path = folder[0] / "hours.csv"
    pd.read_csv(path).iloc[::-1].to_csv(path, index=False)
    assert main(["track", str(folder[0] / "hours.yaml")]) == 1
    assert "must have rising times" in capsys.readouterr().err


def test_a_linear_reading_is_kalmans():
    """Mean and covariance equal those of a Kalman filter, for several readings at once."""
    random = np.random.default_rng(1)
    mean, root, shows = (random.normal(size=one) for one in (3, (3, 3), (2, 3)))
    covariance, noise, read = root @ root.T, np.array([0.3, 0.7]), random.normal(size=2)
    found = track.unscented(mean, covariance, lambda x: shows @ x, read, noise)
    gain = covariance @ shows.T @ np.linalg.inv(shows @ covariance @ shows.T + np.diag(noise))
    assert found[0] == pytest.approx(mean + gain @ (read - shows @ mean))
    assert found[1] == pytest.approx(covariance - gain @ shows @ covariance)
