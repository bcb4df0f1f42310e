# SPDX-License-Identifier: GPL-2.0-or-later
"""Spalls of a 6208 at 1500 rpm under 2 kN: lines of the envelope, and the length from entry and
blow."""

import numpy as np
import pytest
import raceway
from host import succeed
from raceway import envelope, kinematics

BALLS, RPM = 9, 1500
OUTER, INNER = 36.6e-3, 24.0e-3  # m
BAND = (5000.0, 12000.0)  # Hz
CASE = dict(rpm=RPM, load=2000, clearance=10e-6, settle=2, overwrite="yes")


def spall(length, edge=5e-5):
    return f"notch {-np.pi / 2} {length} full 1e-4 {edge}"


def peak(found, hertz):
    """Frequency (Hz) of the highest point within 3 Hz, and how far it stands out of the 12 Hz
    around."""
    frequency, amplitude = found["frequency"].to_numpy(), found.to_numpy()
    near = np.flatnonzero(np.abs(frequency - hertz) < 3.0)
    top = near[np.argmax(amplitude[near])]
    around = np.abs(frequency - hertz) < 12.0
    return frequency[top], amplitude[top] / np.median(amplitude[around])


@pytest.mark.parametrize("length", [1e-3, 2e-3])
@pytest.mark.parametrize("ring", ["outer", "inner"])
def test_lines_of_the_envelope(tmp_path, ring, length):
    """BPFO of the outer raceway; BPFI and the shaft's sidebands of the inner one, which turns
    through the load: at 0.2 % of what the run's own cage speed says."""
    flaw = {f"flaw_{ring}": spall(length)}
    succeed(
        "inputs/in.6208", out=tmp_path, passes=60, samples=300, record="summary", **CASE, **flaw
    )
    run = raceway.open(tmp_path)
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


def test_length_from_entry_and_blow(tmp_path):
    """Entry: from where the overlap falls as the square of the way. Blow: where it turns. 5 %."""
    length = 1e-3
    succeed(
        "inputs/in.6208",
        out=tmp_path,
        passes=2,
        samples=4000,
        flaw_outer=spall(length, edge=2e-5),
        **CASE,
    )
    run = raceway.open(tmp_path)
    time = run.rings["time"].to_numpy()
    azimuth = np.arctan2(run.balls["y"].to_numpy(), run.balls["x"].to_numpy())
    overlap = run.contacts["overlap"].sel(raceway="outer").transpose("time", "ball").to_numpy()
    found = []
    for ball in range(BALLS):
        way = OUTER * (azimuth[:, ball] + np.pi / 2)
        over = np.flatnonzero(np.abs(way) < 2 * length)
        if len(over) < 500 or np.ptp(way[over]) < 3.9 * length:
            continue
        t, depth = time[over], overlap[over, ball]
        before = slice(0, len(over) // 6)
        depth = np.polyval(np.polyfit(t[before], depth[before], 1), t) - depth
        blow = np.argmax(depth)
        falling = (depth[:blow] > 5e-8) & (depth[:blow] < 5e-7)
        rate, start = np.polyfit(t[:blow][falling], np.sqrt(depth[:blow][falling]), 1)
        found.append(
            kinematics.spall_length(run.tables.geometry, RPM * np.pi / 30, t[blow] + start / rate)
        )
    assert len(found) >= 2
    assert np.array(found) == pytest.approx(length, rel=0.05)
