# SPDX-License-Identifier: GPL-2.0-or-later
"""The amplitude as a function of time and frequency, and of time and order during a run-up, is
computed for sines of known frequency and amplitude."""

import numpy as np
import pytest
import raceway
import synthetic
from commands import reply
from raceway import time_frequency
from raceway.errors import RunError
from raceway.runs import order_tracking
from raceway.runs.run import Run
from raceway.runs.turning import Motion

SAMPLE = 1e-4  # s
ORDER, HEIGHT = 7.3, 2e-6  # order relative to the shaft speed; amplitude in m


def test_a_line_that_comes_and_goes():
    time = np.arange(20000) * SAMPLE
    values = 5.0 + np.where(time < 1.0, 2.0, 0.0) * np.sin(2 * np.pi * 800 * time)
    found = time_frequency.spectrogram(values, SAMPLE, 0.1)
    line = found.sel(frequency=800)
    assert line.sel(time=slice(0.1, 0.9)).to_numpy() == pytest.approx(2.0, rel=1e-3)
    assert line.sel(time=slice(1.1, None)).max() < 1e-6
    assert found.attrs["resolution"] == pytest.approx(10.0)
    # the mean is removed
    assert found.sel(frequency=slice(0, 700)).sel(time=slice(0.1, 0.9)).max() < 1e-2


@pytest.mark.parametrize(
    "values, window, says",
    [
        (np.ones(1000), 1e-3, "window 0.001 must be 0.0016 to 0.025"),
        (np.ones(1000), 0.05, "a quarter of the record"),
        (np.full(1000, np.nan), 0.01, "finite"),
        (np.ones((2, 500)), 0.01, "a row of"),
    ],
)
def test_mistakes(values, window, says):
    with pytest.raises(ValueError, match=says):
        time_frequency.spectrogram(values, SAMPLE, window)


@pytest.mark.parametrize("sign", [1, -1])
def test_even_angles(sign):
    """If the signal is resampled at equal angles, a line of constant order in a run-up from 10 to
    30 revolutions per second becomes a single sine."""
    time = np.arange(10000) * SAMPLE
    angle = sign * 2 * np.pi * (10 * time + 10 * time**2)
    values, step = order_tracking.at_even_angles(np.cos(ORDER * angle), angle)
    turns = np.arange(len(values)) * step
    assert turns[-1] == pytest.approx(abs(angle[-1]) / (2 * np.pi), rel=1e-12)
    assert values == pytest.approx(np.cos(2 * np.pi * ORDER * turns), abs=2e-3)


def test_a_shaft_that_turns_back():
    with pytest.raises(ValueError, match="must rotate in one direction"):
        order_tracking.at_even_angles(np.zeros(5), [0, 1, 2, 1, 0])


@pytest.fixture(scope="module")
def run_up(tmp_path_factory, lubricated):
    """Return a run whose ring moves sideways ORDER times per revolution while the shaft speed
    doubles."""
    settings = dict(sample_s=SAMPLE, rpm=900.0, passes=100, samples_per_pass=200)
    time = np.arange(1, 20001) * SAMPLE
    spin = 2 * np.pi * (10 + 5 * time)
    angle = 2 * np.pi * (10 * time + 2.5 * time**2)
    folder, x = tmp_path_factory.mktemp("run_up") / "run", HEIGHT * np.cos(ORDER * angle)
    return synthetic.shaken(folder, lubricated, time, x, -35e-6, spin, **settings)


def test_orders_of_a_run_up(run_up):
    run = raceway.open(run_up)
    nyquist = 0.5 / SAMPLE
    found = time_frequency.of_run(run, "x", "inner", band=(0.2, nyquist), orders=True)
    assert found.dims == ("order", "time") and found["order"].attrs["units"] == "1"
    found = time_frequency.of_run(run, "x", "inner")
    assert found.attrs["orders"] and found.attrs["units"] == "m"
    middle = found.sel(time=slice(0.3, 1.7))
    # the windows last a quarter of a ball pass, so they resolve only few orders
    peaks = middle["order"][middle.argmax("order")]
    assert np.abs(peaks - ORDER).max() < 0.5 * found.attrs["resolution"]
    hertz = time_frequency.of_run(run, "x", "inner", orders=False)
    assert hertz.dims == ("frequency", "time") and hertz["frequency"].attrs["units"] == "Hz"


def test_a_steady_shaft_has_frequencies(folder):
    with pytest.raises(RunError, match="record.nc: window"):
        time_frequency.of_run(raceway.open(folder), "x", "inner")
    with pytest.raises(RunError, match="has no column nothing"):
        time_frequency.of_run(raceway.open(folder), "nothing", "inner")


def test_a_shaft_at_rest(folder, monkeypatch):
    monkeypatch.setattr(Run, "motion", Motion(0.0, 0.0, 0.0, 0.0, 0.0))
    with pytest.raises(RunError, match="the shaft is at rest"):
        time_frequency.of_run(raceway.open(folder), "shift", "inner")


def test_command(run_up, tmp_path, capsys):
    words = ["spectrum", str(run_up), "--signal", "x", "--kind", "time"]
    out = tmp_path / "picture.png"
    for more in ([], ["--envelope", "--band", "20", "4000"], ["--envelope"]):
        assert reply(capsys, [*words, *more, "--out", out]).strip() == str(out)
        assert out.stat().st_size > 10_000
        out.unlink()
    assert "--json applies to --kind lines" in reply(capsys, [*words, "--json"], code=2)
