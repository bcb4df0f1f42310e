# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of rolling.h: no slip at either raceway, frequencies of the 6208, and limits."""

import pytest
from bearings import B6208
from physics_c import BALL, PITCH, rolling
from raceway.theory.kinematics import frequencies


@pytest.mark.parametrize("inner, outer", [(50.0, 0.0), (0.0, 50.0), (120.0, -70.0), (-30.0, -30.0)])
def test_no_slip(inner, outer):
    motion = rolling(inner, outer)
    centre = motion.orbit * PITCH
    # an ulp of a few m/s
    assert centre - motion.spin * BALL == pytest.approx(inner * (PITCH - BALL), abs=5e-15)
    assert centre + motion.spin * BALL == pytest.approx(outer * (PITCH + BALL), abs=5e-15)


def test_both_rings_together_carry_the_balls_along():
    motion = rolling(40.0, 40.0)
    assert [motion.orbit, motion.spin] == pytest.approx([40, 40], rel=1e-14)


def test_frequencies_of_the_6208():  # values as printed in docs/theory, Numbers to reproduce
    motion = rolling(1.0)
    found = [
        motion.orbit,
        9 * motion.orbit,
        9 * (1 - motion.orbit),
        abs(motion.spin - motion.orbit),
    ]
    assert found == pytest.approx([0.39604, 3.5644, 5.4356, 2.3008], abs=5e-5)
    assert found == pytest.approx(list(frequencies(B6208)), rel=1e-13)
