# SPDX-License-Identifier: GPL-2.0-or-later
"""The motions of a shaft are classified correctly, and critical speeds agree with natural
frequencies."""

import numpy as np
import pytest
from bearings import B6208
from raceway import shaft
from raceway.theory import shaft_modes, shaft_motion
from raceway.theory.beam import Disc, Section
from raceway.theory.shaft import Load, Seat, Shaft
from scipy.integrate import quad
from scipy.optimize import brentq


@pytest.fixture(scope="module")
def rotor():
    """Return a shaft with a heavy disc at its overhung end, on preloaded bearings that are equally
    stiff in both planes."""
    whole = Shaft([Section(0.5, 0.04)], discs=[Disc(0.5, 4.0, 0.04, 0.02)])
    seats = [Seat(0.0, B6208), Seat(0.3, B6208, spring=-800.0)]
    return whole, shaft.rest(whole, seats, [Load(0.1, (0.0, 0.0, 1.0))])


def test_a_critical_speed_is_a_natural_frequency_at_that_speed(rotor):
    found = shaft_modes.critical_speeds(*rotor, 1e4)
    assert len(found) >= 3
    for one in found:
        natural = shaft_motion.frequencies(*rotor, one.speed)
        assert np.abs(natural - one.speed).min() < 1e-6 * one.speed


@pytest.mark.parametrize("speed", [0.0, 1000.0])
def test_modes_have_the_natural_frequencies(rotor, speed):
    found = [one.speed for one in shaft_modes.modes(*rotor, speed)]
    # an axial motion without stiffness has a frequency of zero, except for rounding
    assert found == pytest.approx(shaft_motion.frequencies(*rotor, speed), rel=1e-6, abs=1.0)


def test_forward_whirl_rises_with_the_speed_and_backward_whirl_falls(rotor):
    """The gyroscopic moment of the disc stiffens forward whirl and softens backward whirl."""
    still = [one for one in shaft_modes.modes(*rotor, 1.0) if one.whirl][:2]
    fast = [one for one in shaft_modes.modes(*rotor, 2000.0) if one.whirl][:2]
    assert [one.whirl for one in fast] == ["backward", "forward"]
    assert fast[0].speed < still[0].speed * 0.99 and fast[1].speed > still[1].speed * 1.01
    turned = shaft_modes.modes(*rotor, -2000.0)
    assert [one.whirl for one in turned if one.whirl][:2] == ["forward", "backward"]


def test_shapes():
    """In its lowest modes, a stiff shaft moves as a rigid body, also along its axis; in higher
    modes it bends."""
    whole = Shaft([Section(0.4, 0.06)])
    seats = [Seat(0.05, B6208), Seat(0.35, B6208, spring=-300.0)]
    names = [one.shape for one in shaft_modes.modes(whole, shaft.rest(whole, seats, []), 0.0)]
    assert set(names[:5]) == {"axial", "parallel", "conical"}
    assert names[:5].count("parallel") == names[:5].count("conical") == 2
    assert names[5] == "bending"


def shaft_share(ratio):
    """Return the fraction of the strain energy that is stored in the shaft, for the lowest
    symmetric mode of a uniform Euler-Bernoulli beam on a spring k at each end; `ratio` is k L^3/(E
    I).

    The function y = cosh(b) cos(b s) + cos(b) cosh(b s), s = -1 ... 1, has no moment at its ends.
    The shear force at the ends equals the force of the spring, which determines b.
    """

    def shear(b):
        third = np.sin(b) * np.cosh(b) + np.cos(b) * np.sinh(b)
        return 8 * b**3 * third - ratio * 2 * np.cosh(b) * np.cos(b)

    b = brentq(shear, 1e-6, np.pi / 2)
    c, d = np.cos(b), np.cosh(b)
    bent = 8 * b**4 * quad(lambda s: (d * np.cos(b * s) - c * np.cosh(b * s)) ** 2, -1, 1)[0]
    return bent / (bent + 2 * ratio * (2 * c * d) ** 2)


@pytest.mark.parametrize("diameter", [0.02, 0.03, 0.04, 0.05, 0.08, 0.1, 0.12])
def test_a_mode_is_bending_where_the_shaft_has_most_of_its_strain_energy(diameter):
    whole = Shaft([Section(0.5, diameter)])
    seats = [Seat(0.0, B6208), Seat(0.5, B6208, spring=-800.0)]
    still = shaft.rest(whole, seats, [])
    stiffness = shaft_motion.springs(shaft_motion.nodes(whole, still)[0], still)[0, 0]
    share = shaft_share(stiffness * 0.5**3 / (210e9 * np.pi / 64 * diameter**4))
    lowest = next(one for one in shaft_modes.modes(whole, still, 0.0) if one.whirl)
    assert abs(share - 0.5) > 0.1
    assert (lowest.shape == "bending") == (share > 0.5)
    assert lowest.whirl == "planar"
