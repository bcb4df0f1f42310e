# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of damping.h against equations 4 and 5, the lower bound, and the options in the errata."""

import numpy as np
import pytest
from physics_c import BALL
from raceway import damping as package
from raceway.core import laws


def film_damping(viscosity, length, radius, h, floor=0.0, factor=1.0):
    return laws.film_damping(viscosity, factor * length, radius, h, floor)


def test_equation_5():
    expected = 3 * np.pi * 0.04 * 2e-3 / np.sqrt(2) * (BALL / 2e-7) ** 1.5
    # about ten rounding errors
    assert film_damping(0.04, 2e-3, BALL, 2e-7) == pytest.approx(expected, rel=1e-14)
    assert package.film(0.04, 2e-3, BALL, 2e-7) == pytest.approx(expected, rel=1e-14)


def test_numbers_of_the_6208():
    """The damping equals the values in docs/theory, section Normal damping: 0.8, 3.1 and 8.7 kN s/m
    at 5 kN and 0.04 Pa s."""
    found = [film_damping(0.04, 2.059e-3, BALL, h) for h in (500e-9, 200e-9, 100e-9)]
    assert found == pytest.approx([0.8e3, 3.1e3, 8.7e3], abs=50)


def test_over_damped_below_a_quarter_of_a_micron():
    # c > 2 sqrt(k m) for the ball between both raceways at 5 kN, where k = 4.19e8 N/m and there are
    # two dampers; the docs state "about 250 nm"
    mass, k = 4 / 3 * np.pi * BALL**3 * 7800, 4.19e8
    excess = [
        2 * film_damping(0.04, 2.03e-3, BALL, h) / (2 * np.sqrt(k * mass)) for h in (200e-9, 320e-9)
    ]
    assert excess[0] > 1 > excess[1]


def test_the_film_never_falls_below_the_floor():
    at_floor = film_damping(0.04, 2e-3, BALL, 5e-8)
    assert film_damping(0.04, 2e-3, BALL, 0.0, floor=5e-8) == at_floor
    assert film_damping(0.04, 2e-3, BALL, 4.9e-8, floor=5e-8) == at_floor
    assert film_damping(0.04, 2e-3, BALL, 6e-8, floor=5e-8) == film_damping(0.04, 2e-3, BALL, 6e-8)


def test_errata_equation_5_with_the_full_axis_and_the_rolling_radius():
    printed = film_damping(0.04, 2e-3, BALL, 2e-7)
    assert film_damping(0.04, 2e-3, BALL, 2e-7, factor=2.0) == pytest.approx(2 * printed, rel=1e-15)
    r_x = 4.99e-3
    assert film_damping(0.04, 2e-3, r_x, 2e-7) == pytest.approx(
        (r_x / BALL) ** 1.5 * printed, rel=1e-14
    )


def test_no_film_is_an_error():
    with pytest.raises(ValueError, match="h_min"):
        package.film(0.04, 2e-3, 6e-3, 0.0)


def test_hysteretic():
    assert package.hysteretic(2436.2) == pytest.approx(1.5 * 0.08 * 2436.2, rel=1e-15)
    assert package.hysteretic(0.0) == 0
