# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of the limits of capacitance.h; test_physics_in_40_digits.py compares its equations with
40-digit results."""

import numpy as np
import pytest
from raceway import asperity, capacitance, hertz, rough_film, traction
from raceway.core import laws
from scipy.constants import epsilon_0


def test_limits():
    assert laws.density_ratio(0.0) == 1
    # the next term of the series is 0.2e9/p
    assert laws.density_ratio(1e20) == pytest.approx(1.34, rel=1e-10)
    assert laws.permittivity(2.15, 0.0) == pytest.approx(2.15, rel=1e-15)
    assert laws.permittivity(1.0, 3e9) == 1
    # the CODATA value of epsilon_0 changes by about 1e-10 between editions
    assert laws.vacuum_permittivity() == pytest.approx(epsilon_0, rel=1e-9)


def test_what_has_no_value_keeps_none():
    """An open contact has no contact pressure, so its row is NaN."""
    given = np.array([np.nan, 1e9])
    for law in (
        lambda x: capacitance.permittivity(2.2, x),
        lambda x: capacitance.mean_permittivity(2.2, x),
        lambda x: hertz.load(3e10, x),
        lambda x: rough_film.factor(x),
        lambda x: traction.eyring(x, 1.0, 1e-7, 5e6, 1e7),
        asperity.zhou_hoeprich,
    ):
        assert np.isnan(law(given)).tolist() == [True, False]


@pytest.mark.parametrize("inner, outer", [(0.0, 4e-11), (4e-11, 0.0), (0.0, 0.0)])
def test_a_ball_that_lost_a_raceway_adds_nothing(inner, outer):
    assert laws.series_capacitance(inner, outer) == 0
