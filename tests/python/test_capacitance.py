# SPDX-License-Identifier: GPL-2.0-or-later
"""Capacitors in series and parallel; the tests in tests/physics compare the laws with theory."""

import pytest
from raceway import capacitance


def test_series_and_parallel():
    assert capacitance.ball(100.0, 100.0) == 50
    assert capacitance.bearing([100.0, 30.0], [100.0, 60.0]) == pytest.approx(70)
    assert capacitance.bearing([100.0], [100.0], background=30.0) == 80


@pytest.mark.parametrize("ambient", [0.9, 20.0])
def test_impossible_permittivity(ambient):
    with pytest.raises(ValueError, match="permittivity"):
        capacitance.permittivity(ambient, 3e9)
