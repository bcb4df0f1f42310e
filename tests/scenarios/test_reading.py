# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of quantities that are computed from runs of the main deck: kinematic frequencies, the
power balance, and the trajectory in MDAnalysis."""

import numpy as np
import pytest
import raceway
from commands import reply
from host import succeed
from raceway import losses, spectrum


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


def test_command(long, capsys):
    assert "BPFO x3" in reply(capsys, ["spectrum", str(long.tables.folder), "--signal", "x"])


def test_datasets_agree_with_each_other(long):
    """Rings, contacts and balls are recorded at the same instants."""
    both = long.rings["capacitance"] - long.bearing["capacitance"]  # xarray aligns the times
    assert both.sizes["time"] == 8001
    # the dump is written at the end of the step
    assert float(np.abs(both / long.bearing["capacitance"]).max()) < 1e-6
    contact, ball = long.contacts["azimuth"].sel(raceway="outer"), long.balls["azimuth"]
    apart = np.abs(np.exp(1j * contact) - np.exp(1j * ball))
    assert float(apart.max()) < 1e-9 and int(np.isfinite(apart).sum()) > 8000 * 8


def test_universe(long):
    u = long.universe()
    ts = u.trajectory[4321]
    loads = long.contacts["load"].sel(raceway="inner").isel(time=4321)
    assert np.array_equal(ts.data["load_inner"][:9], loads) and len(u.trajectory) == 8001


def test_smoothed_friction_takes_force_times_sliding(long):
    """Friction acts in the direction opposite to sliding, so its power is the product of the two
    magnitudes (the dump has 12 digits)."""
    contacts = long.contacts
    np.testing.assert_allclose(
        contacts["friction_power"],
        (contacts["friction"] * contacts["sliding"]).fillna(0),
        rtol=1e-10,
        atol=1e-25,
    )
    assert float(contacts["damping_power"].min()) > -1e-12


def test_shaft_pays_what_the_contacts_lose(tmp_path):
    """With velocity Verlet, the input power equals the losses. The input varies by 40 mW about a
    mean of 1.4 mW as springs are loaded and unloaded. Because of slip, the run falls short of 20
    full passes by a fraction of 4e-4, and 40 mW * 4e-4 is 1.2 % of the mean. The tolerance is three
    times this value.
    """
    succeed("inputs/in.6208", out=tmp_path / "run", passes=20, settle=4, integrator="verlet")
    mean = losses.losses(raceway.open(tmp_path / "run")).mean()
    lost = float(mean["friction_power"] + mean["damping_power"])
    assert float(mean["power_in"]) == pytest.approx(lost, rel=0.04)
    assert float(mean["torque"]) * 477.5 * np.pi / 30 == pytest.approx(
        float(mean["power_in"]), rel=1e-6
    )
