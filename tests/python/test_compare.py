# SPDX-License-Identifier: GPL-2.0-or-later
"""A run is compared with its own signal, written to a file at a lower rate or for another speed."""

import math

import numpy as np
import pytest
import raceway
import synthetic
from commands import answer
from raceway import compare, envelope, kinematics, recording, sensor, spectrum
from raceway.cli import main
from raceway.errors import RunError
from raceway.runs.run import Run
from raceway.runs.turning import Motion
from scipy.signal import resample_poly

SHAFT, SAMPLES = 477.5 / 60, 12000  # Hz


@pytest.fixture(scope="module")
def run(tmp_path_factory, lubricated, bearing):
    """Return a run with a ring that has a resonance excited at BPFO."""
    sampling = 1e4  # Hz
    time = np.arange(1, SAMPLES + 1) / sampling
    rate = float(kinematics.frequencies(bearing).outer) * SHAFT
    since = (rate * time) % 1 / rate
    shift = 1e-6 * np.exp(-6 * rate * since) * np.sin(2 * np.pi * 0.2 * sampling * since)
    passes = SAMPLES // lubricated["settings"]["samples_per_pass"]
    folder, settings = tmp_path_factory.mktemp("compare") / "run", dict(sample_s=1 / sampling)
    ring = time, 0, -35e-6 - shift, 2 * np.pi * SHAFT
    return raceway.open(synthetic.shaken(folder, lubricated, *ring, passes=passes, **settings))


def write(tmp_path, run, share=0.5):
    """Write the signal of the run at a lower rate, and return the file and its rate."""
    rate = share / run.settings["sample_s"]
    values = sensor.decimated(spectrum.signal_of(run, "shift"), run.settings["sample_s"], rate)
    np.savez(tmp_path / "own.npz", shift=values)
    return tmp_path / "own.npz", rate


@pytest.mark.parametrize("share", [0.5, 0.49283])
def test_a_run_beside_itself(tmp_path, run, share):
    """Lines, amplitudes and levels of the run agree with those of its file, whatever the ratio of
    the rates."""
    path, rate = write(tmp_path, run, share)
    rpm = run.motion.shaft * 30 / np.pi
    same = recording.Recording(path, run.geometry, rpm=rpm, rate=rate)
    found = compare.compare(run, same, "shift", "inner")
    assert found.run.level == pytest.approx(found.recording.level, rel=1e-9)
    outer = [one for one in found.lines if one.name == "BPFO"]
    assert len(outer) == 3
    for one in outer:
        assert one.run == pytest.approx(one.recording, rel=1e-6)
        assert one.run_amplitude == pytest.approx(one.recording_amplitude, rel=1e-6)
        assert one.run == pytest.approx(one.nominal, rel=2e-4)


@pytest.mark.parametrize("inner, outer", [(0.0, 1.0), (1.0, -0.5), (-1.0, 0.0)])
def test_rings_turn_as_in_the_run(tmp_path, run, monkeypatch, inner, outer):
    """Both sides have the lines of the rings that rotate, at the same orders. The cage rolls."""
    path, rate = write(tmp_path, run)
    speed = run.motion.shaft
    cage = kinematics.frequencies(run.geometry, 0.0, inner * speed, outer * speed).cage
    monkeypatch.setattr(Run, "motion", Motion(inner * speed, outer * speed, cage, math.nan, 0.0))
    rpm = abs(run.motion.shaft) * 30 / np.pi
    same = recording.Recording(path, run.geometry, rpm=rpm, rate=rate)
    found = compare.compare(run, same, "shift", "inner")
    own = spectrum.places(run)
    assert {(one.name, one.harmonic): one.nominal for one in found.lines} == pytest.approx(
        {key: order for key, (order, _) in own.items()}
    )


def test_a_shaft_without_a_steady_speed(tmp_path, run, monkeypatch):
    path, rate = write(tmp_path, run)
    same = recording.Recording(path, run.geometry, rpm=SHAFT * 60, rate=rate)
    monkeypatch.setattr(Run, "shaft_speed", lambda run: np.linspace(50, 60, SAMPLES))
    with pytest.raises(RunError, match="constant speed"):
        compare.compare(run, same, "shift", "inner")


def test_another_speed_has_the_same_orders(tmp_path, run):
    """The recording is treated as if it had been made at twice the speed and rate."""
    path, rate = write(tmp_path, run)
    rpm = 2 * run.motion.shaft * 30 / np.pi
    fast = recording.Recording(path, run.geometry, rpm=rpm, rate=2 * rate)
    band = (0.2 * rate, 0.45 * rate)
    found = compare.compare(run, fast, "shift", "inner", band=band)
    for one in found.lines:
        if one.name == "BPFO":
            assert one.run == pytest.approx(one.recording, rel=2e-4)
    faster = recording.Recording(path, run.geometry, rpm=rpm, rate=8 * rate)
    with pytest.raises(RunError, match="must lie between 0 and"):
        compare.compare(run, faster, "shift", "inner", band=(1.2 * rate, 1.5 * rate))


def test_the_band_is_one_of_both(tmp_path, run):
    """A recording at a higher rate rings above the frequencies of the run; the band is chosen
    among those of both."""
    sample_s = run.settings["sample_s"]
    values = resample_poly(spectrum.signal_of(run, "shift"), 4, 1)
    time = sample_s / 4 * np.arange(len(values))
    strikes = np.exp(-((((time * 20) % 1 - 0.5) / 0.01) ** 2)) * np.sin(2 * np.pi * 1.5e4 * time)
    np.savez(tmp_path / "fast.npz", ay=values + 1e-6 * strikes)
    rpm = run.motion.shaft * 30 / np.pi
    fast = recording.Recording(tmp_path / "fast.npz", run.geometry, rpm=rpm, rate=4 / sample_s)
    assert envelope.of_run(fast, "ay", orders=False).attrs["band"][1] > 0.5 / sample_s
    found = compare.compare(run, fast, "shift", "inner")
    assert found.band[1] <= 0.5 / sample_s
    outer = next(one for one in found.lines if one.name == "BPFO")
    assert outer.run == pytest.approx(outer.recording, rel=1e-3)


def test_command(tmp_path, run, capsys):
    path, rate = write(tmp_path, run)
    words = ["compare", str(run.tables.folder), str(path), "--signal", "shift", "--ring", "inner"]
    words += ["--rate", f"{rate:.12g}", "--rpm", f"{run.motion.shaft * 30 / np.pi:.12g}"]
    assert main([*words, "--out", str(tmp_path / "both.png")]) == 0
    assert (tmp_path / "both.png").stat().st_size > 10_000
    assert "BPFO x3" in capsys.readouterr().out
    said = answer(capsys, words)
    assert said["run"]["rms"] == pytest.approx(said["recording"]["rms"], rel=1e-9)
