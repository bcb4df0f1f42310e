# SPDX-License-Identifier: GPL-2.0-or-later
"""Film factors, the film in all regimes and the film in the gap are compared with published values,
limits and finite slopes."""

import numpy as np
import pytest
from raceway import film, film_factors, film_regimes, hertz, rolling, rough_film
from raceway.theory.bearing import INNER
from references import friction as friction_reference
from scipy import stats

OIL = (0.04, 22e-9)
SPEEDS = np.array([0.7248, 2.899, 14.4946])


@pytest.fixture(scope="module")
def inner(bearing):
    """Return (E', R_x, R_y, kappa, K) for the inner raceway of the 6208."""
    r_x, r_y = bearing.effective_radii(INNER)
    ellipse, modulus = hertz.exact(r_x, r_y), bearing.effective_modulus
    return modulus, r_x, r_y, ellipse.kappa, hertz.stiffness(ellipse, modulus)


# ---- factors -----------------------------------------------------------------------------------


def test_inlet_shear(bearing):
    loading = film_factors.thermal_loading(0.047, 0.04, SPEEDS, 0.134)
    assert loading[:2] == pytest.approx([0.0074, 0.1179], abs=5e-5)
    assert loading[2] == pytest.approx(2.948, abs=5e-4)
    ratio = 2.571e9 / bearing.effective_modulus
    for factor, expected in (
        (film_factors.murch_wilson(loading), [0.9881, 0.9368, 0.6684]),
        (film_factors.gupta(loading, ratio), [0.9724, 0.8917, 0.5391]),
        (film_factors.wilson(loading), [0.9957, 0.9752, 0.8335]),
    ):
        assert factor == pytest.approx(expected, abs=5e-5)


def test_inlet_shear_of_the_rolling_torque():
    loading = np.array([1e-3, 0.0074, 1.0, 2.948, 10.0])
    exact = [float(friction_reference.aihara(one)) for one in loading]
    assert rolling.inlet_shear(loading) == pytest.approx(exact, rel=1e-14)


def test_the_factor_of_rough_films_is_the_mean_of_a_gamma_distribution():
    for ratio in (2.5, 4.24, 13.09):
        one = stats.gamma(ratio**2, scale=1 / ratio**2)  # mean 1, standard deviation 1/ratio
        assert one.std() == pytest.approx(1 / ratio, rel=1e-12)
        inverse = one.expect(lambda h: 1 / h)
        assert rough_film.factor(ratio) == pytest.approx(inverse, rel=1e-7)


# ---- all regimes -------------------------------------------------------------------------------
def test_all_regimes_tend_to_their_asymptotes():
    def h(load, material):
        return film_regimes.h_c(film_regimes.Moes(load, material, 1.0, 1.0))

    wide = 1.63
    ei = 3.18 * wide ** (-14 / 25) * 1e9 ** (-2 / 15)
    ep = 1.48 * wide ** (-7 / 20) * 1e9 ** (-1 / 12) * 1e3**0.75
    rp = 1.29 * 1.691 ** (-2 / 3) * 1e3 ** (2 / 3)
    assert h(1e9, 1e-6) == pytest.approx(ei, rel=1e-3)
    assert h(1e9, 1e3) == pytest.approx(ep, rel=0.01)
    assert h(10.0, 1e3) == pytest.approx(rp, rel=0.05)
    assert h(1e-3, 1e-6) == pytest.approx(145 * 1.796 ** (-15 / 7) * 1e6, rel=1e-3)


def test_all_regimes_near_the_power_law_at_load(inner):
    """As stated in section 2 of the theory, at loads typical of a 6208 the film is about 1.15 times
    as thick as according to the formula by Masjedi and Khonsari."""
    modulus, r_x, r_y, kappa, _ = inner
    for speed in SPEEDS:
        both = (
            film_regimes.h_c(film_regimes.group(*OIL, modulus, r_x, r_y, speed, 2436.2)),
            film.h_c(r_x, film.group(*OIL, modulus, r_x, kappa, speed, 2436.2)),
        )
        assert both[0] / both[1] == pytest.approx(1.15, abs=0.12)


# ---- in the gap --------------------------------------------------------------------------------


def test_load_exponent(inner):
    assert film.load_exponent(inner[3]) == pytest.approx(0.067322, abs=5e-7)
