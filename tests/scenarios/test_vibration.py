# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of the main deck with the integrator `vibration`: samples at the requested rate, a housing
that moves, and the lines of a spall in the envelope of the housing's signal."""

import numpy as np
import pytest
import raceway
from host import refuses, succeed
from raceway import envelope, sensor, spectrum
from raceway.runs.tables import RunTables
from raceway.sweeps import check

DECK = "inputs/in.6208"
SPALL = "notch -1.5708 {} full 1.0e-3 5.0e-5"
RUN = dict(bearing=6205, lubricant="vg46", integrator="vibration", load=500, record="summary")
QUICK = dict(RUN, rpm=6000, housing="springs", oversampling=2)


@pytest.fixture(scope="module", params=["1.0e-3", "2.0e-3"])
def length(request):
    return request.param


@pytest.mark.parametrize(
    "side, names", [("outer", ["BPFO"]), ("inner", ["BPFI", "BPFI+shaft", "BPFI-shaft"])]
)
def test_lines_of_a_spall(tmp_path, side, names, length):
    """A sensor on the housing samples at 48 kHz. In its envelope around the resonance of the
    housing, the lines agree within 0.2 % with kinematics at the cage speed of the run."""
    flaw = {f"flaw_{side}": SPALL.format(length)}
    succeed(DECK, out=tmp_path, passes=100, settle=2, **flaw, **QUICK)
    run = raceway.open(tmp_path)
    heard = sensor.of_run(run, "ay", rate=48e3)
    assert heard.std() > 10  # m/s^2
    found = spectrum.spectrum(envelope.of_values(heard, 1 / 48e3, 2e3, 8e3), 1 / 48e3)
    lines = spectrum.lines(run, found, harmonics=2, sidebands=True)
    wanted = [line for line in lines if line.name in names]
    assert len(wanted) == 2 * len(names)
    for line in wanted:
        assert line.note == "", line
        assert line.found == pytest.approx(line.by_cage, rel=2e-3), line
    # a flaw on the other raceway would cause no line at these frequencies
    other = {"outer": "BPFI", "inner": "BPFO"}[side]
    assert all(line.note for line in lines if line.name == other)


@pytest.fixture(scope="module")
def perfect(tmp_path_factory):
    folder = tmp_path_factory.mktemp("perfect")
    succeed(DECK, out=folder, passes=4, sampling=25600, **QUICK)
    return folder


def test_rate(perfect):
    """The sampling rate of the record is the requested rate times `oversampling`, and the record
    covers whole ball passes to the nearest sample."""
    run = raceway.open(perfect)
    sample_s, passes = run.settings["sample_s"], run.settings["passes"]
    assert sample_s == pytest.approx(1 / (2 * 25600), rel=1e-12)
    count = run.rings.sizes["time"]
    assert count - 1 == round(passes * run.settings["samples_per_pass"])
    ball_pass = 2 * np.pi / (9 * float(run.bearing["cage_speed"].mean()))
    assert (count - 1) * sample_s == pytest.approx(4 * ball_pass, rel=2e-3)
    assert sensor.of_run(run, rate=25600).sizes["time"] == (count + 1) // 2


def test_a_repeat_with_more_samples(perfect):
    """When `raceway check` repeats a run with a finer tolerance, it also uses a shorter step."""
    more = check.repeats(RunTables(perfect))["sampling"]
    assert more["oversampling"] == "4" and more["samples"] == "200"
    assert more["sampling"] == "25600" and more["housing_frequency"] == "4000"


def test_the_housing_carries_the_load(perfect):
    run = raceway.open(perfect)
    stiffness = 2 * (2 * np.pi * 4000) ** 2
    moved = spectrum.signal_of(run, "y", "outer").mean()
    assert moved == pytest.approx(-500 / stiffness, rel=0.02)


@pytest.mark.parametrize("order, shift", [(8, -1), (10, 1)])
def test_a_fine_wave_stands_out(tmp_path, order, shift):
    """A wave with an amplitude of 0.01 um on the inner raceway causes a line at BPFI - shaft if its
    order is Z - 1, and at BPFI + shaft if its order is Z + 1. The line has a hundred times the
    amplitude that it has in a perfect bearing, and there is no line at the other frequency."""
    heard = {}
    for name, flaw in (("perfect", "none"), ("wave", f"wave {order} 1.0e-8 0")):
        folder = tmp_path / name
        succeed(DECK, out=folder, passes=60, settle=4, flaw_inner=flaw, **QUICK)
        run = raceway.open(folder)
        found = spectrum.of_run(run, "ay")
        middle, _ = spectrum.places(run, harmonics=1)["BPFI", 1]
        heard[name] = {
            side: float(found.sel(frequency=(middle + side) * 100, method="nearest"))
            for side in (-1, 1)
        }
    assert heard["wave"][shift] > 0.01  # m/s^2
    assert heard["wave"][shift] > 100 * heard["perfect"][shift]
    assert heard["wave"][shift] > 100 * heard["wave"][-shift]


def test_goes_on(perfect, tmp_path):
    """A run that is continued from two passes to four writes the same bytes as an uninterrupted
    run."""
    succeed(DECK, out=tmp_path, passes=2, sampling=25600, **QUICK)
    succeed(DECK, out=tmp_path, passes=4, sampling=25600, resume="yes", **QUICK)
    assert (tmp_path / "record.nc").read_bytes() == (perfect / "record.nc").read_bytes()


def test_a_held_ring_is_no_sensor(tmp_path):
    succeed(DECK, out=tmp_path, passes=1, rpm=20000, **RUN)
    with pytest.raises(raceway.errors.RunError, match="ay of the outer ring does not change"):
        sensor.of_run(raceway.open(tmp_path))


def test_sampling_of_another_integrator(tmp_path):
    words = {**RUN, "integrator": "implicit", "sampling": 10000}
    refuses(DECK, "sampling belongs to bearing/vibration", out=tmp_path, **words)
