# SPDX-License-Identifier: GPL-2.0-or-later
"""The laws of a run and those of the Python package are evaluated for the same table of inputs, and
both are compared with 40-digit mpmath results.

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
from raceway.core import laws
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
STATES = list(itertools.product([1e-3, 0.725, 25.0], [1e-3, 50.0, 2436.2, 3e4]))  # m/s, N
OILS = [(0.040, 22e-9, 2.25), (1.0, 35e-9, 2.05), (0.005, 8e-9, 3.0)]  # Pa s, 1/Pa, permittivity
MODELS = {MASJEDI: False, MASJEDI_PRINTED: True, HAMROCK_DOWSON: None}
EQUAL = 1e-12


def films(model, kappa, oil, r_x, speed, load):
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


def agree(cpp, python, exact):
    """Assert that both values equal the reference, and therefore each other."""
    exact = [float(value) for value in exact]
    np.testing.assert_allclose(cpp, exact, rtol=EQUAL)
    np.testing.assert_allclose(python, exact, rtol=EQUAL)
    np.testing.assert_allclose(cpp, python, rtol=EQUAL)


def radii(name, side, angle):
    return tuple(map(float, BEARINGS[name].effective_radii(side, angle)))


@pytest.mark.parametrize("name, side, angle", CONTACTS)
def test_hertz(physics, name, side, angle):
    r_x, r_y = radii(name, side, angle)
    cpp, python = physics.hertz(r_x, r_y, STEEL), hertz.exact(r_x, r_y)
    with mpmath.workdps(40):
        kappa, first, second, radius = reference.ellipse(r_x, r_y)
        modulus = mpmath.mpf(STEEL)
        stiffness = (
            mpmath.pi
            * kappa
            * modulus
            * mpmath.sqrt(second * radius / (mpmath.mpf("4.5") * first**3))
        )
        # E and F themselves are not compared, because the headers use the integrals of the other
        # modulus for an ellipse that is longer along rolling
        agree(
            [cpp.kappa, cpp.K], [python.kappa, hertz.stiffness(python, STEEL)], [kappa, stiffness]
        )
        for load in {load for _, load in STATES}:
            a = mpmath.cbrt(6 * kappa**2 * second * load * radius / (mpmath.pi * modulus))
            pressure = mpmath.mpf("1.5") * load / (mpmath.pi * a * a / kappa)
            root = (load / cpp.K) ** (1 / 3)  # of the overlap
            agree(
                [cpp.a * root, cpp.b * root, cpp.p * root],
                [*hertz.semi_axes(python, STEEL, load), hertz.pressure(python, STEEL, load)],
                [a, a / kappa, pressure],
            )


@pytest.mark.parametrize("name, side, angle", CONTACTS)
@pytest.mark.parametrize("model", MODELS)
def test_film_and_capacitance(physics, name, side, angle, model):
    r_x, r_y = radii(name, side, angle)
    cpp, python = physics.hertz(r_x, r_y, STEEL), hertz.exact(r_x, r_y)
    for (speed, load), (viscosity, xi, ambient) in itertools.product(STATES, OILS):
        with mpmath.workdps(40):
            kappa, _, second, radius = reference.ellipse(r_x, r_y)
            exact = films(model, kappa, (viscosity, xi), r_x, speed, load)
            a = mpmath.cbrt(6 * kappa**2 * second * load * radius / (mpmath.pi * mpmath.mpf(STEEL)))
            pressure = mpmath.mpf("1.5") * load / (mpmath.pi * a * a / kappa)
            charge = electric(ambient, pressure, a, a / kappa, exact[1])
        h_cpp = physics.film(model, cpp.kappa, viscosity, xi, STEEL, r_x, speed, load)
        g = film.group(viscosity, xi, STEEL, r_x, python.kappa, speed, load)
        h_python = (
            (film.hamrock_dowson_min(r_x, g), film.hamrock_dowson_c(r_x, g))
            if MODELS[model] is None
            else (film.h_min(r_x, g), film.h_c(r_x, g, printed=MODELS[model]))
        )
        agree(h_cpp, h_python, exact)
        root = (load / cpp.K) ** (1 / 3)
        eps = laws.permittivity(ambient, cpp.p * root)
        p, (a, b) = hertz.pressure(python, STEEL, load), hertz.semi_axes(python, STEEL, load)
        agree(
            [eps, laws.contact_capacitance(eps, cpp.a * root, cpp.b * root, h_cpp[1])],
            [
                capacitance.permittivity(ambient, p),
                capacitance.contact(ambient, p, a, b, h_python[1]),
            ],
            charge,
        )


def test_series_and_composite_roughness():
    for one, other in itertools.product([1e-15, 3e-11, 7.7e-10], repeat=2):
        with mpmath.workdps(40):
            x, y = mpmath.mpf(one), mpmath.mpf(other)
            exact = float(1 / (1 / x + 1 / y))
            assert capacitance.ball(one, other) == pytest.approx(exact, rel=EQUAL)
            exact = float(mpmath.mpf(2e-7) / mpmath.sqrt(x * x + y * y))
            assert film.ratio(2e-7, one, other) == pytest.approx(exact, rel=EQUAL)
