# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of spalls in a 6208 at 1500 rpm under 2 kN: spectral lines in the envelope, and the length
of a spall, determined from the entry of a ball and its impact."""

from contextlib import nullcontext

import numpy as np
import pytest
import raceway as package
from host import succeed
from raceway import envelope, inputs, kinematics, passages, recording, sensor, spall
from raceway.theory.bearing import INNER, OUTER

BALLS, RPM = 9, 1500
BAND = (5000.0, 12000.0)  # Hz
REACH = 1.2e-3  # s, three times the time over half a spall of 2 mm
RING_MASS = 0.055  # kg, mass of the 6205's inner ring
HOUSED = dict(
    **dict(bearing=6205, rpm=1797, load=500, lubricant="vg46", housing="springs"),
    **dict(integrator="vibration", record="summary", overwrite="yes"),
)
CASE = dict(rpm=RPM, load=2000, clearance=10e-6, settle=2, overwrite="yes")


def notch(length, edge=5e-5):
    return f"notch {-np.pi / 2} {length} full 1e-4 {edge}"


def peak(found, hertz):
    """Return (frequency (Hz) of the highest point within 3 Hz of `hertz`, ratio of its amplitude to
    the median within 12 Hz)."""
    frequency, amplitude = found["frequency"].to_numpy(), found.to_numpy()
    near = np.flatnonzero(np.abs(frequency - hertz) < 3.0)
    top = near[np.argmax(amplitude[near])]
    around = np.abs(frequency - hertz) < 12.0
    return frequency[top], amplitude[top] / np.median(amplitude[around])


@pytest.mark.parametrize("length", [1e-3, 2e-3])
@pytest.mark.parametrize("ring", ["outer", "inner"])
def test_lines_of_the_envelope(tmp_path, ring, length):
    """A spall on the outer raceway causes lines at BPFO. A spall on the inner raceway, which
    rotates through the load zone, causes lines at BPFI with sidebands at the shaft speed. The lines
    agree within 0.2 % with values computed from the cage speed of the run."""
    flaw = {f"flaw_{ring}": notch(length)}
    succeed(
        "inputs/in.6208", out=tmp_path, passes=60, samples=300, record="summary", **CASE, **flaw
    )
    run = package.open(tmp_path)
    found = envelope.of_run(run, "ay", BAND)
    shaft, cage = RPM / 60, float(run.bearing["cage_speed"].mean()) / (2 * np.pi)
    if ring == "outer":
        lines = [BALLS * cage, 2 * BALLS * cage]
    else:
        passing = BALLS * (shaft - cage)
        lines = [passing, passing - shaft, passing + shaft, 2 * passing]
    for hertz in lines:
        there, above = peak(found, hertz)
        assert there == pytest.approx(hertz, rel=2e-3) and above > 3, hertz


def test_lines_of_a_flawed_ball(tmp_path):
    """A pit on a ball strikes both raceways alternately, half a turn apart. The line is at twice
    the speed of the ball relative to the cage, with sidebands at the cage speed because the load is
    on one side. It agrees within 0.2 % with the value computed from the spin of this ball in the
    run."""
    flaw = {"flaw_ball": "pit 0 0 1e-3 1e-3 1e-4 5e-5", "flawed_ball": 3}
    succeed("inputs/in.6208", out=tmp_path, passes=90, samples=300, record="all", **CASE, **flaw)
    run = package.open(tmp_path)
    assert run.flaws == {"ball 3": "pit 0 0 1e-3 1e-3 1e-4 5e-5"}
    found = envelope.of_run(run, "ay", BAND)
    cage = float(run.bearing["cage_speed"].mean()) / (2 * np.pi)
    turns = cage - float(run.balls["omegaz"].sel(ball=3).mean()) / (2 * np.pi)
    for hertz in (2 * turns, 2 * turns - cage, 2 * turns + cage, 4 * turns):
        there, above = peak(found, hertz)
        assert there == pytest.approx(hertz, rel=2e-3) and above > 3, hertz
    # both impacts are equally strong; with only one impact, the line at one turn would be higher
    once, twice = (
        found.to_numpy()[np.abs(found["frequency"].to_numpy() - k * turns) < 1.0].max()
        for k in (1, 2)
    )
    assert once < 0.5 * twice


@pytest.mark.parametrize("length", [1e-3, 2e-3])
@pytest.mark.parametrize("raceway, passes", [("outer", 5), ("inner", 12)])
def test_length_from_a_housing(tmp_path, raceway, passes, length):
    """Lengths of 1 and 2 mm, determined from the signal of an accelerometer on the housing, agree
    within 3 %. The half-way rule gives lengths that are 5 % to 70 % too large, because the ball
    loses its load and flies."""
    found, half_way = lengths_from_a_housing(tmp_path, raceway, passes, length)
    assert found == pytest.approx(length, rel=0.03)
    assert 1.05 * length < half_way < 1.7 * length


@pytest.mark.parametrize(
    "raceway, length, more, rings",
    [
        # the ball almost loses its load, and bounces
        ("outer", 1e-3, dict(load=1000, rpm=3000), True),
        # the ball keeps its load
        ("outer", 1e-3, dict(bearing=6208, load=2000, rpm=1500, mass=0.2), False),
        # the largest error on the page
        ("inner", 2e-3, dict(bearing=6208, load=2000, rpm=1500, mass=0.2), False),
        # the length would be 3.55 mm if the line were continued through earlier ringing
        ("outer", 1e-3, dict(bearing=6208, load=4000, rpm=3000, mass=0.2, passes=8), True),
    ],
)
def test_hard_lengths_from_a_housing(tmp_path, raceway, length, more, rings):
    """Lengths agree within 3 % for the most difficult runs of tests/bench/spall_length.py, and for
    a run in which the housing is still vibrating when the next ball arrives."""
    more = {"passes": {"outer": 5, "inner": 16}[raceway]} | more
    with pytest.warns(UserWarning, match="the signal varies by") if rings else nullcontext():
        found, _ = lengths_from_a_housing(tmp_path, raceway, length=length, **more)
    assert found == pytest.approx(length, rel=0.03)


def test_a_length_that_is_wrong_has_a_warning(tmp_path):
    """The computed length is 4.95 mm instead of 2 mm, because ringing caused by the previous ball
    hides the entry of the next ball."""
    case = dict(bearing=6208, load=2000, rpm=3000, mass=0.2)
    with pytest.warns(UserWarning, match="lengths can be wrong by half or more"):
        found, _ = lengths_from_a_housing(tmp_path, "outer", 5, 2e-3, **case)
    assert found > 3e-3  # once this is correct, the test needs another scene


def test_length_from_a_file(tmp_path):
    """A length of 1.5 mm is determined from the file of a 96 kHz sensor. Behind the filter of a 48
    kHz sensor, all spalls appear to be 1 mm long, and there is a warning."""
    words = HOUSED | dict(bearing=6206, rpm=1500, load=800)
    flaw = f"notch {-np.pi / 2} 1.5e-3 full 1e-3 5e-5"
    succeed("inputs/in.6208", out=tmp_path, passes=8, **words, flaw_outer=flaw)
    run, body = package.open(tmp_path), inputs.bearing("6206")
    for rate, length, warning in (
        (96000, pytest.approx(1.5e-3, rel=0.04), nullcontext()),
        (48000, pytest.approx(1e-3, rel=0.1), pytest.warns(UserWarning, match="below 60 kHz")),
    ):
        path = tmp_path / f"{rate}.csv"
        np.savetxt(path, sensor.of_run(run, "ay", "outer", rate=rate))
        heard = recording.Recording(path, body, rate=rate, rpm=1500)
        with warning:
            seconds = passages.of_run(heard, "outer", next(iter(heard.channels))).seconds
        found = spall.length(body, OUTER, seconds, heard.motion.shaft, 800, 0.1, edge=5e-5)
        assert np.median(found) == length


def lengths_from_a_housing(folder, raceway, passes, length, mass=RING_MASS, **more):
    """Return the median lengths (m) found by `spall.length` and by the half-way rule."""
    edge, words = 5e-5, {**HOUSED, **more}
    flaw = {f"flaw_{raceway}": f"notch {-np.pi / 2} {length} full 1e-3 {edge}"}
    succeed("inputs/in.6208", out=folder, passes=passes, **words, **flaw)
    run = package.open(folder)
    bearing, spin = run.tables.geometry, words["rpm"] * np.pi / 30
    seconds = passages.of_run(run, raceway).strong.seconds
    assert len(seconds) >= 2
    side, load = {"inner": INNER, "outer": OUTER}[raceway], words["load"]
    found = spall.length(bearing, side, seconds, spin, load, mass, heard=OUTER, edge=edge)
    return np.median(found), np.median(kinematics.spall_length(bearing, spin, seconds))


def test_length_from_a_contact_load(tmp_path):
    """Lengths determined from balls that remain loaded over a 1 mm spall agree within 5 %."""
    length, edge = 1e-3, 2e-5
    succeed(
        "inputs/in.6208",
        out=tmp_path,
        passes=2,
        samples=4000,
        flaw_outer=notch(length, edge),
        **CASE,
    )
    run = package.open(tmp_path)
    sample_s = run.settings["sample_s"]
    loads = run.contacts["load"].sel(raceway="outer").transpose("time", "ball").to_numpy()
    each = [
        passages.find(one, sample_s, 0.999 * len(one) * sample_s, REACH, share=0.1)
        for one in loads.T
    ]
    every = passages.Passages(*map(np.concatenate, zip(*each)))
    # the neighbouring balls take up less load than the ball loses
    seconds = every.seconds[every.dip > 0.9 * every.dip.max()]
    assert len(seconds) == 2
    spin = RPM * np.pi / 30
    more = dict(edge=edge, clearance=10e-6)
    found = spall.length(run.tables.geometry, OUTER, seconds, spin, 2000, 0.2, **more)
    assert found == pytest.approx(length, rel=0.05)
