# SPDX-License-Identifier: GPL-2.0-or-later
"""Stribeck's integral is compared with 30-digit quadrature, and with the load parameters given in
the paper."""

import mpmath
import numpy as np
import pytest
from raceway import clearance, distribution


@pytest.mark.parametrize("parameter", [0.02, 0.2, 0.5, 0.9, 1.0, 1.7])
def test_radial_integral(parameter):
    with mpmath.workdps(30):
        edge = mpmath.pi if parameter >= 1 else mpmath.acos(1 - 2 * mpmath.mpf(parameter))
        expected = (
            mpmath.quad(
                lambda psi: (
                    mpmath.re((1 - (1 - mpmath.cos(psi)) / (2 * parameter)) ** 1.5)
                    * mpmath.cos(psi)
                ),
                mpmath.linspace(0, edge, 9),
            )
            / mpmath.pi
        )
    assert distribution.radial_integral(parameter) == pytest.approx(float(expected), rel=1e-10)


def test_stribeck_number():
    assert 9 * distribution.largest_load(9, 1.0, 0.5) == pytest.approx(4.37, abs=0.005)


def test_loaded_zone():
    assert distribution.relative_load(
        np.array([0.0, np.pi / 2, np.pi]), 0.5
    ).tolist() == pytest.approx([1, 0, 0])
    assert distribution.relative_load(np.pi, 2.0) == pytest.approx(0.5**1.5)
    with pytest.raises(ValueError, match="parameter"):
        distribution.relative_load(0.0, 0.0)


@pytest.mark.parametrize(
    "relative, expected",
    [(-0.0045, 1.699), (-0.0035, 1.317), (0, 0.5), (0.0035, 0.319), (0.0045, 0.292)],
)
def test_load_parameters_of_the_paper(bearing, relative, expected):
    pd = relative * bearing.ball_diameter
    shift = distribution.shift(bearing, 5000.0, pd)
    assert clearance.load_parameter(pd, shift) == pytest.approx(expected, abs=6e-4)


def test_shift_needs_a_load(bearing):
    with pytest.raises(ValueError, match="radial load"):
        distribution.shift(bearing, 0.0)
