# SPDX-License-Identifier: GPL-2.0-or-later
"""The spectral lines of a run of the main deck are at the kinematic frequencies of its cage."""

import numpy as np
import pytest
import raceway
from host import succeed
from raceway import spectrum


@pytest.fixture(scope="module")
def long(tmp_path_factory):
    """Return a run over 40 ball passes, i.e. 4.4 turns of the cage. The tolerance is 0.1 nm,
    because with 1 nm the error of fy, the force along the load, would be as large as its ripple
    (docs/output.rst)."""
    folder = tmp_path_factory.mktemp("long") / "run"
    succeed("inputs/in.6208", out=folder, passes=40, tolerance=1e-10)
    return raceway.open(folder)


@pytest.mark.parametrize("signal", ["x", "y", "shift", "fx", "fy", "mz", "capacitance"])
def test_ball_pass_frequency_and_harmonics(long, signal):
    """The stiffness varies as balls pass through the load zone. The frequencies agree with
    kinematics within 0.2 %: slip slows the cage by 4e-4, and noise in the weakest signal (fx, with
    the implicit integrator) shifts a peak by 2e-4."""
    found = {
        (line.name, line.harmonic): line
        for line in spectrum.lines(long, spectrum.of_run(long, signal))
    }
    for harmonic in (1, 2, 3):
        line = found["BPFO", harmonic]
        assert line.note == "" and abs(line.difference) < 2e-3


def test_displacement_shows_the_slip_of_the_cage(long):
    """The spectral line follows the balls: BPFO equals Z times the mean orbital speed of the balls
    to within 1e-3 of a bin, where a bin is 1/40 of the ball pass frequency."""
    (line,) = (
        line for line in spectrum.lines(long, spectrum.of_run(long, "x"), 1) if line.name == "BPFO"
    )
    orbit = long.summary()["cage_speed_rad_s"]
    assert line.found == pytest.approx(9 * orbit / (2 * np.pi), rel=5e-5)
    assert -6e-4 < line.difference < -2e-4


def test_a_perfect_bearing_has_no_other_line(long):
    """Without a flaw or a ball of different size there is no line at BSF or BPFI."""
    for signal in ("x", "shift", "fy"):
        for line in spectrum.lines(long, spectrum.of_run(long, signal)):
            assert line.name in ("BPFO", "FTF") or line.note
