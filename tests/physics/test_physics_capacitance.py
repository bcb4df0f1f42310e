# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of capacitance.h against equations 8 and 10 to 12, their limits, and the CODATA value of
epsilon_0."""

import numpy as np
import pytest
from raceway import asperity, capacitance, hertz, rough_film, traction
from raceway.core import laws
from scipy.constants import epsilon_0

PRESSURES = [0.0, 0.4e9, 2.571e9, 1e15]


@pytest.mark.parametrize("ambient", [1.0, 2.15, 4.0])
@pytest.mark.parametrize("pressure", PRESSURES)
def test_clausius_mossotti_is_proportional_to_density(ambient, pressure):
    eps = laws.permittivity(ambient, pressure)
    density = (0.59e9 + 1.34 * pressure) / (0.59e9 + pressure)
    assert laws.density_ratio(pressure) == pytest.approx(density, rel=1e-15)
    # the expected values are computed with the inverse of the tested function; since 1 - c >= 0.3,
    # rounding errors are magnified only by a small factor
    assert (eps - 1) / (eps + 2) == pytest.approx(
        (ambient - 1) / (ambient + 2) * density, rel=1e-14, abs=1e-15
    )


def test_limits():
    assert laws.density_ratio(0.0) == 1
    # the next term of the series is 0.2e9/p
    assert laws.density_ratio(1e20) == pytest.approx(1.34, rel=1e-10)
    assert laws.permittivity(2.15, 0.0) == pytest.approx(2.15, rel=1e-15)
    assert laws.permittivity(1.0, 3e9) == 1


def test_parallel_plates():
    # the CODATA value of epsilon_0 changes by about 1e-10 between editions
    assert laws.contact_capacitance(2.15, 2e-3, 2.2e-4, 3e-7) == pytest.approx(
        epsilon_0 * 2.15 * np.pi * 2e-3 * 2.2e-4 / 3e-7, rel=1e-9
    )


def test_series():
    assert 1 / laws.series_capacitance(3e-11, 7e-11) == pytest.approx(
        1 / 3e-11 + 1 / 7e-11, rel=1e-15
    )
    assert laws.series_capacitance(4e-11, 4e-11) == pytest.approx(2e-11, rel=1e-15)


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
