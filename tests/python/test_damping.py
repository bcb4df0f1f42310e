# SPDX-License-Identifier: GPL-2.0-or-later
"""Damping is compared with the values in docs/theory, Normal damping."""

import pytest
from raceway import damping


@pytest.mark.parametrize("h, expected", [(500e-9, 0.8e3), (200e-9, 3.1e3), (100e-9, 8.7e3)])
def test_squeeze_film(h, expected):  # the page prints two digits
    assert damping.film(0.040, 2.059e-3, 6.3e-3, h) == pytest.approx(expected, abs=0.05e3)


def test_hysteresis_is_proportional_to_load():
    assert damping.hysteretic(2436.2) == pytest.approx(1.5 * 0.08 * 2436.2)
    assert damping.hysteretic(0.0) == 0


def test_no_film_is_an_error():
    with pytest.raises(ValueError, match="h_min"):
        damping.film(0.04, 2e-3, 6e-3, 0.0)
