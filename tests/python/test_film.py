# SPDX-License-Identifier: GPL-2.0-or-later
"""Values by hand, the dimensionless group of a film, contacts that roll backwards, rest or carry no
load, and the regimes; tests/physics compares the laws with theory."""

import numpy as np
import pytest
from raceway import film, hertz
from raceway.theory.bearing import INNER


def group(bearing, side=INNER, speed=0.725, load=2436.2):
    r_x, r_y = bearing.effective_radii(side)
    return r_x, film.group(
        0.04, 20e-9, bearing.effective_modulus, r_x, hertz.exact(r_x, r_y).kappa, speed, load
    )


def test_by_hand():
    # for kappa = 1 the exponents equal the printed values
    g = film.Group(speed=1e-11, material=4500.0, load=1e-4, kappa=1.0)
    assert film.h_min(1.0, g) == pytest.approx(
        1.637 * 10 ** (-11 * 0.711) * 4500**0.65 * 10 ** (4 * 0.09) * (1 - 0.974 * np.exp(-0.676)),
        rel=1e-13,
    )
    assert film.h_c(1.0, g) == pytest.approx(
        3.672 * 10 ** (-11 * 0.663) * 4500**0.502 * 10 ** (4 * 0.045) * (1 - 0.573 * np.exp(-0.74)),
        rel=1e-13,
    )
    assert film.h_c(1.0, g) == film.h_c(1.0, g, printed=True)


def test_printed_signs_of_equation_9_do_not(bearing):
    r_x, g = group(bearing, speed=0.05)
    assert film.h_c(r_x, g, printed=True) / film.hamrock_dowson_c(r_x, g) > 1.4


def test_direction_of_rolling_does_not_matter_and_rest_has_no_film(bearing):
    r_x, g = group(bearing, speed=-0.725)
    assert film.h_c(r_x, g) == film.h_c(*group(bearing))
    assert film.h_c(*group(bearing, speed=0.0)) == 0


def test_unloaded_contact_is_an_error(bearing):
    with pytest.raises(ValueError, match="load = 0"):
        group(bearing, load=0)


def test_regimes():
    assert film.regime([0.0, 0.999, 1.0, 2.0, 3.0, 3.001]).tolist() == [0, 0, 1, 1, 1, 2]
    assert film.regime(0.5, boundary=0.4, full=0.45) == 2
