# SPDX-License-Identifier: GPL-2.0-or-later
"""Hertz contact, film thickness and capacitance are compared with 40-digit mpmath results over a
table of inputs.

Relative errors are below 1e-12. A film thickness is the exponential of a sum of terms of at most
50, each with a relative rounding error of 2e-16, so it is accurate to about 1e-14. The ellipse and
the pressure have the rounding error of an iteration, a few 1e-15. Rounding of the table values
affects all three results.
"""

import itertools

import mpmath
import numpy as np
import pytest
from bearings import B6208
from physics_c import HAMROCK_DOWSON, INNER, MASJEDI, MASJEDI_PRINTED, OUTER
from raceway import capacitance, film, hertz
from raceway.theory.bearing import Bearing
from references import film as film_reference
from references import hertz as reference

STEEL = 210e9 / (1 - 0.3**2)
BEARINGS = {
    "6208": B6208,
    "harris 209": Bearing(9, 12.7e-3, 26.15e-3, 38.85e-3, 6.604e-3, 6.604e-3),
    "conformity 0.505": Bearing(9, 12.6e-3, 24.0e-3, 36.6e-3, 6.363e-3, 6.363e-3),
    "nearly spherical": Bearing(9, 12.6e-3, 24.0e-3, 36.6e-3, 1.0, 1.0),
}
CONTACTS = [
    (name, side, angle) for name in BEARINGS for side in (INNER, OUTER) for angle in (0.0, 0.6)
]
RATIOS = (0.02, 0.4, 0.95, 1 + 1e-9, 1.01, 1.05, 1.5, 3.0, 9.0, 33.0, 500.0, 1e3, 1e6)  # R_y/R_x
STATES = list(itertools.product([1e-3, 0.725, 25.0], [1e-3, 50.0, 2436.2, 3e4]))  # m/s, N
OILS = [(0.040, 22e-9, 2.25), (1.0, 35e-9, 2.05), (0.005, 8e-9, 3.0)]  # Pa s, 1/Pa, permittivity
EQUAL = 1e-12


def exact_films(model, kappa, oil, r_x, speed, load):
    """Return (h_min, h_c) from the equations, in mpmath."""
    r_x = mpmath.mpf(r_x)
    groups = film_reference.groups(*oil, STEEL, r_x, mpmath.mpf(speed), load)
    if model == HAMROCK_DOWSON:
        return film_reference.hamrock_dowson(r_x, *groups, kappa)
    sign = -1 if model == MASJEDI_PRINTED else 1
    return film_reference.masjedi_khonsari(r_x, *groups, kappa, sign)


def electric(ambient, pressure, a, b, h):
    """Return (permittivity, capacitance) from equations 8, 10 and 11, in mpmath."""
    d = mpmath.mpf
    ambient, pressure, a, b, h = map(d, (ambient, pressure, a, b, h))
    x = (
        (ambient - 1)
        / (ambient + 2)
        * (d("0.59e9") + d("1.34") * pressure)
        / (d("0.59e9") + pressure)
    )
    eps = (1 + 2 * x) / (1 - x)
    return eps, d("8.8541878128e-12") * eps * mpmath.pi * a * b / h


def agree(found, exact, rel=EQUAL):
    np.testing.assert_allclose(found, [float(value) for value in exact], rtol=rel)


def radii(name, side, angle):
    return tuple(float(radius) for radius in BEARINGS[name].effective_radii(side, angle))


@pytest.mark.parametrize(
    "radii", [(5e-3, 5e-3 * ratio) for ratio in RATIOS] + [radii(*one) for one in CONTACTS]
)
def test_hertz(radii):
    found = hertz.exact(*radii)
    agree(found, reference.ellipse(*radii), 1e-13)
    for _, load in STATES:
        exact = reference.contact(*radii, STEEL, load)
        a, b = hertz.semi_axes(found, STEEL, load)
        pressure = hertz.pressure(found, STEEL, load)
        agree([*found, hertz.stiffness(found, STEEL), a, b, pressure], exact.values())


def films(model, r_x, g):
    """Return (h_min, h_c) from the package."""
    if model == HAMROCK_DOWSON:
        return film.hamrock_dowson_min(r_x, g), film.hamrock_dowson_c(r_x, g)
    return film.h_min(r_x, g), film.h_c(r_x, g, printed=model == MASJEDI_PRINTED)


@pytest.mark.parametrize("name, side, angle", CONTACTS)
@pytest.mark.parametrize("model", [MASJEDI, MASJEDI_PRINTED, HAMROCK_DOWSON])
def test_film_thickness(name, side, angle, model):
    r_x, r_y = radii(name, side, angle)
    kappa = hertz.exact(r_x, r_y).kappa
    for (speed, load), (*oil, _) in itertools.product(STATES, OILS):
        found = films(model, r_x, film.group(*oil, STEEL, r_x, kappa, speed, load))
        with mpmath.workdps(40):
            agree(found, exact_films(model, reference.ellipse(r_x, r_y)[0], oil, r_x, speed, load))


@pytest.mark.parametrize("name, side, angle", CONTACTS)
def test_permittivity_and_capacitance(name, side, angle):
    ellipse = hertz.exact(*radii(name, side, angle))
    for (_, load), (_, _, ambient), h in itertools.product(STATES, OILS, (3e-9, 2e-7, 1e-5)):
        contact = reference.contact(*radii(name, side, angle), STEEL, load)
        with mpmath.workdps(40):
            exact = electric(ambient, *(contact[name] for name in ("pressure", "a", "b")), h)
        p, axes = hertz.pressure(ellipse, STEEL, load), hertz.semi_axes(ellipse, STEEL, load)
        found = capacitance.permittivity(ambient, p), capacitance.contact(ambient, p, *axes, h)
        agree(found, exact)


def test_series_and_composite_roughness():
    for one, other in itertools.product([1e-15, 3e-11, 7.7e-10], repeat=2):
        with mpmath.workdps(40):
            x, y = mpmath.mpf(one), mpmath.mpf(other)
            exact = float(1 / (1 / x + 1 / y))
            assert capacitance.ball(one, other) == pytest.approx(exact, rel=EQUAL)
            exact = float(mpmath.mpf(2e-7) / mpmath.sqrt(x * x + y * y))
            assert film.ratio(2e-7, one, other) == pytest.approx(exact, rel=EQUAL)
