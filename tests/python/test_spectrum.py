# SPDX-License-Identifier: GPL-2.0-or-later
"""Spectra are computed for signals with known lines, and lines are found in a run folder."""

import re

import numpy as np
import pytest
import raceway
import synthetic
import xarray as xr
from commands import answer, reply
from raceway import kinematics, spectrum
from raceway.errors import RunError
from raceway.pictures import spectrum as picture

SAMPLE = 1e-3


def wave(frequency, amplitude=1.0, samples=4000, phase=0.3):
    return amplitude * np.cos(2 * np.pi * frequency * SAMPLE * np.arange(samples) + phase)


@pytest.mark.parametrize("frequency", [17.3, 100.0, 100.06, 100.125, 333.33])
def test_a_sine(frequency):
    """The frequency of a sine may lie anywhere between two bins of 0.25 Hz. The parabola has an
    error of 1e-3 bins in position and of 3e-4 in height."""
    one = spectrum.spectrum(5.0 + 0.1 * np.arange(4000) * SAMPLE + wave(frequency, 2.0), SAMPLE)
    assert one.attrs["resolution"] == pytest.approx(0.25)
    found, difference, height, prominence, note = spectrum.find(one, frequency * 1.001)
    assert note == "" and prominence > 100
    assert found == pytest.approx(frequency, abs=1e-3 * 0.25)
    assert difference == pytest.approx(1 / 1.001 - 1, abs=1e-3 * 0.25 / frequency)
    assert height == pytest.approx(2.0, rel=3e-4)


def test_a_faint_line_beside_a_strong_one():
    """A line has 5e-4 of the height of another line that is 12 bins away. The side lobes of the
    strong line, 2.5e-5 of its height, amount to 5 % of the faint line there, and shift it by 0.05
    to 0.1 bins."""
    one = spectrum.spectrum(wave(100.0) + wave(103.0, 5e-4), SAMPLE)
    assert spectrum.find(one, 103.0)[0] == pytest.approx(103.0, abs=0.1 * 0.25)
    assert spectrum.find(spectrum.spectrum(wave(100.0), SAMPLE), 103.0)[-1] != ""


def test_noise_has_no_lines():
    random = np.random.default_rng(1)
    for _ in range(20):
        one = spectrum.spectrum(random.normal(size=4000), SAMPLE)
        assert all(spectrum.find(one, hertz)[-1] for hertz in np.linspace(20, 400, 39))


@pytest.mark.parametrize(
    "signal, hertz, said",
    [
        (wave(100.0), 1.2, "fewer than 5.5 periods"),
        (wave(100.0), 499.9, "above half the sampling rate"),
        (wave(100.0), 130.0, "no peak|does not stand out"),
        (np.zeros(4000), 100.0, "no peak"),
        (wave(100.0), 100.8, "nearest peak at 100 Hz"),
        (wave(100.0), 99.2, "nearest peak at 100 Hz"),
    ],
)
def test_nothing_there(signal, hertz, said):
    if said.startswith("nearest"):
        found = spectrum.find(spectrum.spectrum(signal[:1000], SAMPLE), hertz)
    else:
        found = spectrum.find(spectrum.spectrum(signal, SAMPLE), hertz)
    assert np.isnan(found[0]) and np.isnan(found[1])
    assert re.search(said, found[-1])


@pytest.mark.parametrize("values", [np.ones(31), np.ones((40, 2)), [*range(40), np.nan]])
def test_no_signal(values):
    with pytest.raises(ValueError, match="at least 32 finite values"):
        spectrum.spectrum(values, SAMPLE)


def write(tmp_path, lubricated, orders, passes=60, samples_per_pass=24):
    """Write a run whose ring moves along the load, with amplitudes given as {shaft order: m}."""
    samples, shaft = passes * samples_per_pass, 477.5 / 60
    time = np.arange(1, samples + 1) * lubricated["settings"]["sample_s"]
    shift = 35e-6 + sum(
        a * np.cos(2 * np.pi * order * shaft * time + order) for order, a in orders.items()
    )
    settings = dict(passes=passes, samples_per_pass=samples_per_pass)
    ring = time, 0, -shift, 2 * np.pi * shaft
    return synthetic.shaken(tmp_path / "run", lubricated, *ring, **settings)


def test_lines_of_a_run(tmp_path, lubricated, bearing):
    orders = kinematics.frequencies(bearing)
    slip = 1 - 4e-4
    given = {
        orders.outer * slip: 4e-7,
        2 * orders.outer * slip: 4e-8,
        orders.inner: 1e-9,
        2 * orders.spin: 2e-9,
    }
    run = raceway.open(write(tmp_path, lubricated, given))
    found = {(line.name, line.harmonic): line for line in spectrum.lines(run, spectrum.of_run(run))}
    assert set(found) == {
        (name, n) for name in ("FTF", "BSF", "BPFO", "BPFI", "shaft") for n in (1, 2, 3)
    }
    expected = {
        ("BPFO", 1): (-4e-4, 4e-7),
        ("BPFO", 2): (-4e-4, 4e-8),
        ("BPFI", 1): (0, 1e-9),
        ("BSF", 2): (0, 2e-9),
    }
    for key, line in found.items():
        if key in expected:
            difference, amplitude = expected[key]
            # 1e-3 of a bin (1/60 of the ball pass frequency), relative to an order of at least 3.5
            assert line.difference == pytest.approx(difference, abs=2e-5) and line.note == ""
            # the leakage of the strong lines is 2.5e-5 of 4e-7
            assert line.amplitude == pytest.approx(amplitude, rel=1e-2)
            assert line.found == pytest.approx(line.expected * (1 + line.difference), rel=1e-12)
            assert line.by_cage == pytest.approx(line.order * 477.5 / 60, rel=1e-15)
        else:
            assert np.isnan(line.found) and line.note


def test_a_line_is_not_taken_for_its_neighbour(tmp_path, lubricated, bearing):
    """BPFO x3 and BPFI x2 of a 6208 are 1.7 % apart. With a search range of this width, one must
    not be mistaken for the other."""
    run = raceway.open(
        write(tmp_path, lubricated, {3 * kinematics.frequencies(bearing).outer: 4e-7})
    )
    found = {
        (line.name, line.harmonic): line
        for line in spectrum.lines(run, spectrum.of_run(run), within=0.02)
    }
    assert found["BPFO", 3].note == "" and found["BPFI", 2].note == "hidden by BPFO x 3"


def test_contact_angle_changes_the_lines(folder, bearing):
    run = raceway.open(folder)
    places = spectrum.expected(run.tables.geometry, 10.0, angle=0.5, harmonics=1)
    orders = kinematics.frequencies(bearing, 0.5)
    assert places["BPFO", 1] == pytest.approx((orders.outer, 10 * orders.outer), rel=1e-14)
    assert places["FTF", 1][0] == pytest.approx(orders.cage, rel=1e-14)


def test_a_column_a_run_has_not(folder):
    with pytest.raises(RunError, match="record.nc has no column fq; it has step, x"):
        spectrum.of_run(raceway.open(folder), "fq")


def test_a_ring_there_is_not(folder):
    """A misspelt ring is not the outer one."""
    for name in ("Inner", "outside", ""):
        with pytest.raises(RunError, match="must be one of inner, outer"):
            raceway.open(folder).signal("x", name)


def test_too_short(folder):
    with pytest.raises(RunError, match="has 20 samples: a spectrum needs 32"):
        spectrum.of_run(raceway.open(folder, slice(0, 20)))


def test_units(folder):
    run = raceway.open(folder)
    for name, unit in (("shift", "m"), ("fy", "N"), ("mz", "N m")):
        one = spectrum.of_run(run, name)
        assert (
            one.attrs["units"] == unit
            and isinstance(one, xr.DataArray)
            and one["frequency"].attrs["units"] == "Hz"
        )


def test_command(tmp_path, lubricated, bearing, capsys):
    folder = write(tmp_path, lubricated, {kinematics.frequencies(bearing).outer * (1 - 4e-4): 4e-7})
    lines = reply(
        capsys, ["spectrum", folder, "--out", tmp_path / "x.png", "--harmonics", "2"]
    ).splitlines()
    assert lines[0].startswith("displacement of the inner ring along the load; resolution ")
    (row,) = (line.split() for line in lines if line.startswith("  BPFO  "))
    # in this run the balls roll without slip
    assert row[:2] + row[6:] == ["BPFO", "3.5644", "-0.0400%", "400", "nm", "-0.0400%"]
    assert lines[-1] == "  order: measured cage and balls; kinematics: balls that roll without slip"
    assert (tmp_path / "x.png").read_bytes()[:4] == b"\x89PNG" and (
        tmp_path / "x.png"
    ).stat().st_size > 10_000
    data = {line["name"]: line for line in answer(capsys, ["spectrum", folder, "--harmonics", "1"])}
    assert list(data) == ["FTF", "BSF", "BPFO", "BPFI", "shaft"]
    assert (
        data["BPFO"]["difference"] == pytest.approx(-4e-4, abs=2e-5)
        and data["BPFI"]["found_Hz"] is None
    )


def test_command_refuses(folder, capsys):
    assert "has no column nothing" in reply(
        capsys, ["spectrum", folder, "--signal", "nothing"], code=1
    )
    said = reply(capsys, ["spectrum", folder, "--harmonics", "0"], code=2)
    assert "number from 1 to 50" in said


def test_labels_do_not_cover_each_other():
    places = [100.0, 101.0, 102.0, 150.0, 99.5]
    rows = picture.levels(places, 1.0)
    assert rows == [1, 0, 0, 0, 0]
    for row in set(rows):
        inside = sorted(p for p, r in zip(places, rows) if r == row)
        assert all(b - a >= 1.0 for a, b in zip(inside, inside[1:]))
