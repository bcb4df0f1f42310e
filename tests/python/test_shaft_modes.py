# SPDX-License-Identifier: GPL-2.0-or-later
"""Names of a shaft's motions, and its critical speeds, against its natural frequencies."""

import numpy as np
import pytest
from raceway import shaft
from raceway.theory import shaft_modes, shaft_motion
from raceway.theory.beam import Disc, Section
from raceway.theory.bearing import Bearing
from raceway.theory.shaft import Load, Seat, Shaft

B6208 = Bearing(9, 12.6e-3, 24.0e-3, 36.6e-3, 6.552e-3, 6.552e-3)


@pytest.fixture(scope="module")
def rotor():
    """A heavy disc at the overhung end, preloaded bearings alike in both planes."""
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
    # of an axial motion without a spring rate only rounding is left
    assert found == pytest.approx(shaft_motion.frequencies(*rotor, speed), rel=1e-6, abs=1.0)


def test_forward_whirl_rises_with_the_speed_and_backward_whirl_falls(rotor):
    """The gyroscopic moment of the disc stiffens a forward whirl and softens a backward one."""
    still = [one for one in shaft_modes.modes(*rotor, 1.0) if one.whirl][:2]
    fast = [one for one in shaft_modes.modes(*rotor, 2000.0) if one.whirl][:2]
    assert [one.whirl for one in fast] == ["backward", "forward"]
    assert fast[0].speed < still[0].speed * 0.99 and fast[1].speed > still[1].speed * 1.01
    turned = shaft_modes.modes(*rotor, -2000.0)
    assert [one.whirl for one in turned if one.whirl][:2] == ["forward", "backward"]


def test_shapes():
    """A stiff shaft moves as a rigid body first, along its axis too; then it bends."""
    whole = Shaft([Section(0.4, 0.06)])
    seats = [Seat(0.05, B6208), Seat(0.35, B6208, spring=-300.0)]
    names = [one.shape for one in shaft_modes.modes(whole, shaft.rest(whole, seats, []), 0.0)]
    assert set(names[:5]) == {"axial", "parallel", "conical"}
    assert names[:5].count("parallel") == names[:5].count("conical") == 2
    assert names[5] == "bending"
