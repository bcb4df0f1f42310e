# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of the factors by which inlet shear and starvation reduce the film thickness, against
published values and 40-digit arithmetic."""

import pytest
from film_scene import ROUNDING, SPEEDS
from raceway import film_factors
from references import film as reference

SHEAR = {
    1: (film_factors.murch_wilson, reference.murch_wilson),
    2: (film_factors.wilson, reference.wilson),
}  # 3 is Gupta's factor


def factor(physics, shear, speed, starvation=1.0, pressure=0.0, sliding=0.0):
    return physics.call(
        "film_factor",
        shear=shear,
        beta=0.047 if shear else 0.0,
        viscosity=0.04,
        conductivity=0.134 if shear else 0.0,
        starvation=starvation,
        speed=speed,
        pressure=pressure,
        sliding=sliding,
    )


@pytest.mark.parametrize("shear", SHEAR)
@pytest.mark.parametrize("speed", [1e-3, *SPEEDS, 90.0])
def test_inlet_shear(physics, shear, speed):
    loading = 0.047 * 0.04 * speed**2 / 0.134
    assert film_factors.thermal_loading(0.047, 0.04, speed, 0.134) == pytest.approx(
        loading, rel=1e-14
    )
    package, exact = (float(one(loading)) for one in SHEAR[shear])
    assert package == pytest.approx(exact, rel=ROUNDING)
    assert factor(physics, shear, speed, 0.8) == pytest.approx(0.8 * exact, rel=ROUNDING)


@pytest.mark.parametrize("sliding", [0.0, 0.02, 0.3])
@pytest.mark.parametrize("speed", [1e-3, *SPEEDS])
def test_gupta(physics, speed, sliding):
    loading = 0.047 * 0.04 * speed**2 / 0.134
    for pressure in (0.0, 0.004, 0.0115):
        found = factor(physics, 3, speed, 0.8, pressure, sliding)
        exact = float(reference.gupta(loading, pressure, sliding / speed))
        assert found == pytest.approx(0.8 * exact, rel=ROUNDING)
        package = film_factors.gupta(loading, pressure, sliding / speed)
        assert package == pytest.approx(exact, rel=ROUNDING)


def test_gupta_beyond_its_range(physics):
    """Outside the range of Gupta's formula, Python raises an error, whereas a run continues with a
    tenth of the factor at zero pressure."""
    loading = film_factors.thermal_loading(0.047, 0.04, 90.0, 0.134)
    with pytest.raises(ValueError, match="range of Gupta"):
        film_factors.gupta(loading, 0.02)
    found = factor(physics, 3, 90.0, pressure=0.02)
    assert found == pytest.approx(0.1 / (1 + 0.213 * loading**0.64), rel=ROUNDING)


def test_no_factor(physics):
    assert factor(physics, 0, 14.0) == 1.0
    assert factor(physics, 1, 0.0) == 1.0  # at rest
    assert factor(physics, 3, 0.0, pressure=0.01, sliding=0.1) == 1.0
