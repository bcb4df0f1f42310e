# SPDX-License-Identifier: GPL-2.0-or-later
"""docs/decks/in.two_bearings is a self-contained deck with a 6208 and a 6306 on one shaft, which
are lubricated with different oils."""

import numpy as np
import pytest
import raceway
from commands import answer, reply
from host import succeed

AT = {1: 0.03, 2: 0.33}  # m, positions of the bearings along the shaft
LOADS = [(0.1874, (0, -133, 0)), (0.39, (1500, 0, 0)), (0.18, (0, 0, 400))]  # m, N, as in the deck


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    folder = tmp_path_factory.mktemp("two")
    succeed("docs/decks/in.two_bearings", out=folder)
    return raceway.open(folder)


def reaction(run, number):
    """Return (mean force (N) of the balls on the inner ring of bearing `number`, moment (N m) of
    this force about the centre of the ring)."""
    mean = run.select(number).rings.isel(time=slice(1, None)).mean("time")
    return tuple(
        np.array([float(mean[name]) for name in names])
        for names in (("fx", "fy", "fz"), ("mx", "my", "mz"))
    )


def test_each_has_its_data(run):
    """vg46 at 60 C and grease110 have different pressure-viscosity coefficients, and the bearings
    have different balls."""
    one, other = (run.select(number).settings for number in run.bearing_numbers)
    assert (one["ball_diameter_m"], other["ball_diameter_m"]) == (12.6e-3, 12.3e-3)
    assert (one["clearance_m"], other["clearance_m"]) == pytest.approx((10e-6, 8e-6))
    assert other["viscosity_Pa_s"] > 1.5 * one["viscosity_Pa_s"]
    assert run.settings["models"] == "full" and run.settings["settled_passes"] >= 2


def test_forces_and_moments_balance(run):
    """Averaged over whole ball passes, the reactions of the bearings balance the force and the
    moment of the loads. The floating bearing does not carry any thrust."""
    force, moment = np.zeros(3), np.zeros(3)
    for number, z in AT.items():
        of, couple = reaction(run, number)
        force += of
        moment += couple + np.cross([0, 0, z], of)
    for z, load in LOADS:
        force += load
        moment += np.cross([0, 0, z], load)
    assert force == pytest.approx([0, 0, 0], abs=2e-3 * 1500)
    assert moment[:2] == pytest.approx([0, 0], abs=2e-3 * 1500 * 0.39)
    assert abs(reaction(run, 1)[0][2]) < 2e-3 * 400


@pytest.mark.parametrize("ring", ["inner", "outer"])
def test_the_spectrum_is_that_of_one_bearing(run, capsys, ring):
    words = ["spectrum", run.tables.folder, "--ring", ring, "--signal", "z"]
    assert "select one with --bearing NUMBER" in reply(capsys, words, code=1)
    lines = [answer(capsys, [*words, "--bearing", str(number)]) for number in AT]
    assert lines[0][0]["order"] != lines[1][0]["order"]
