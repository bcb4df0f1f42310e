# SPDX-License-Identifier: GPL-2.0-or-later
"""Permittivity and capacitance are compared with limits and with a plate capacitor."""

import numpy as np
import pytest
from raceway import capacitance


def test_permittivity_at_rest_and_its_growth():
    assert capacitance.permittivity(2.2, 0.0) == pytest.approx(2.2, rel=1e-14)
    assert capacitance.density_ratio(1e15) == pytest.approx(1.34, rel=1e-6)
    pressures = np.linspace(0, 3e9, 50)
    assert np.all(np.diff(capacitance.permittivity(2.2, pressures)) > 0)
    e = capacitance.permittivity(2.2, 2e9)
    assert (e - 1) / (e + 2) == pytest.approx(1.2 / 4.2 * (0.59 + 1.34 * 2) / 2.59, rel=1e-13)


def test_vacuum_stays_vacuum():
    assert capacitance.permittivity(1.0, 2e9) == 1


def test_plate_capacitor():
    assert capacitance.contact(1.0, 0.0, 2e-3, 1e-3, 1e-7) == pytest.approx(
        8.854e-12 * np.pi * 2e-6 / 1e-7, rel=1e-4
    )


def test_series_and_parallel():
    assert capacitance.ball(100.0, 100.0) == 50
    assert capacitance.bearing([100.0, 30.0], [100.0, 60.0]) == pytest.approx(70)
    assert capacitance.bearing([100.0], [100.0], background=30.0) == 80


def test_a_ball_that_lost_a_raceway_adds_nothing():
    assert capacitance.ball([100.0, 0.0, 0.0], [0.0, 100.0, 0.0]).tolist() == [0, 0, 0]


@pytest.mark.parametrize("ambient", [0.9, 20.0])
def test_impossible_permittivity(ambient):
    with pytest.raises(ValueError, match="permittivity"):
        capacitance.permittivity(ambient, 3e9)
