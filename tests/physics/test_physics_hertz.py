# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of hertz.h against the sphere, Hertz's equations, and the errata (40-digit values:
test_physics_in_40_digits.py)."""

import numpy as np
import pytest
from physics_c import (
    BALL,
    EXACT,
    HAMROCK,
    INNER,
    OUTER,
    PITCH,
    PRINTED,
    groove_radii,
    hertz_contact,
)
from raceway.core import laws
from scipy.integrate import quad

STEEL = 210e9 / (1 - 0.09)
# The bound covers some tens of rounding errors of 1e-16 and the rounding error of a root.
ROUNDING = 1e-13


def approach_and_curvatures(a, b, pressure, modulus):
    """Return the displacement and the curvatures of two elastic half-spaces under the pressure
    p sqrt(1 - x^2/a^2 - y^2/b^2).

    Hertz's potential integrals (Johnson 3.39, 4.19) are evaluated by quadrature, without elliptic
    integrals. The displacement is (p a b/E*)/2 int (1 - x^2/(a^2 + s) - y^2/(b^2 + s)) ds/sqrt((a^2
    + s)(b^2 + s)s), where E* = E'/2.
    """

    def moment(power_a, power_b):  # s = b^2 t^2 removes the root at 0
        def f(t):
            s = (b * t) ** 2
            return (
                2
                * b
                / np.sqrt((a * a + s) * (b * b + s))
                / (a * a + s) ** power_a
                / (b * b + s) ** power_b
            )

        return quad(f, 0, np.inf, epsabs=0, epsrel=1e-12, limit=400)[0]

    factor = pressure * a * b / modulus
    return factor * moment(0, 0), 2 * factor * moment(1, 0), 2 * factor * moment(0, 1)


@pytest.mark.parametrize("r_x, r_y", [(5e-3, 5e-3), (5e-3, 8e-3), (5e-3, 0.16), (0.16, 5e-3)])
def test_hertz_pressure_presses_the_surfaces_together(r_x, r_y):
    overlap = 2e-5
    h = hertz_contact(r_x, r_y, STEEL)
    a, b, p = (value * np.sqrt(overlap) for value in (h.a, h.b, h.p))
    approach, across, along = approach_and_curvatures(a, b, p, STEEL)
    # the tolerance of the quadrature is 1e-12
    assert [approach, along, across] == pytest.approx([overlap, 1 / r_x, 1 / r_y], rel=1e-10)
    assert 2 / 3 * p * np.pi * a * b == pytest.approx(h.K * overlap**1.5, rel=ROUNDING)


@pytest.mark.parametrize("form", [EXACT, HAMROCK])
def test_circle_is_the_sphere(form):
    # for two spheres R_x = R_y = R* = r1 r2/(r1 + r2)
    h, r1, r2 = hertz_contact(2e-3, 2e-3, STEEL, form), 6e-3, 3e-3
    sphere = 4 / 3 * (STEEL / 2) * np.sqrt(2e-3)
    # the exact root is bracketed to within 1e-12 in ln kappa; K is stationary there, but the
    # semi-axes are not
    assert h.K == pytest.approx(sphere, rel=ROUNDING)
    assert laws.sphere_stiffness(r1, r2, STEEL) == pytest.approx(sphere, rel=1e-15)
    # a = sqrt(R overlap)
    assert [h.kappa, h.a, h.b] == pytest.approx([1, np.sqrt(2e-3), np.sqrt(2e-3)], rel=2e-12)


@pytest.mark.parametrize("nearly", [1e-12, 1e-9, 1e-6, 1e-3])
def test_the_sphere_is_approached_linearly(nearly):
    # for a circular contact, K is symmetric in both curvatures: K(R, R(1+d)) = K(R, R)(1 + d/4 +
    # O(d^2))
    h = hertz_contact(2e-3, 2e-3 * (1 + nearly), STEEL)
    assert h.K == pytest.approx(
        2 / 3 * STEEL * np.sqrt(2e-3) * (1 + nearly / 4), rel=nearly**2 + ROUNDING
    )


@pytest.mark.parametrize("form", [EXACT, HAMROCK, PRINTED])
@pytest.mark.parametrize("ratio", [1.7, 33.0])
def test_below_one_the_axes_change_places(ratio, form):
    one, other = (
        hertz_contact(2e-3, 2e-3 * ratio, STEEL, form),
        hertz_contact(2e-3 * ratio, 2e-3, STEEL, form),
    )
    assert [other.kappa, other.K, other.a, other.b, other.p, other.radius] == pytest.approx(
        [1 / one.kappa, one.K, one.b, one.a, one.p, one.radius], rel=ROUNDING
    )
    assert one.kappa > 1 and one.a / one.b == pytest.approx(one.kappa, rel=ROUNDING)


def test_a_conformal_groove_gives_no_number():
    assert np.isnan(hertz_contact(5e-3, -0.16, STEEL).K)  # r_c < R_b: R_y is negative
    r_x, r_y = groove_radii(INNER, groove=0.99 * BALL)
    assert r_y < 0 and np.isnan(hertz_contact(r_x, r_y, STEEL).K)


@pytest.mark.parametrize("form", [HAMROCK, PRINTED])
def test_fits_as_written(form):
    alpha, q = 33.0, np.pi / 2 - 1
    h = hertz_contact(5e-3, 5e-3 * alpha, STEEL, form)
    kappa, second = alpha ** (2 / np.pi), 1 + q / alpha
    first = (1 if form == PRINTED else np.pi / 2) + q * np.log(alpha)
    assert [h.kappa, h.first, h.second] == pytest.approx([kappa, first, second], rel=1e-15)
    curve = 5e-3 * alpha / (1 + alpha)
    # eq 2 as in the paper: 2 pi kappa G/(1 - nu) sqrt(2 E R/(9 F^3)), where G = E/(2(1 + nu))
    shear = 210e9 / 2.6
    assert h.K == pytest.approx(
        2 * np.pi * kappa * shear / 0.7 * np.sqrt(2 * second * curve / (9 * first**3)), rel=ROUNDING
    )


@pytest.mark.parametrize("side", [INNER, OUTER])
def test_errata_the_printed_integral_is_32_per_cent_too_stiff(side):
    exact, fit, printed = (
        hertz_contact(*groove_radii(side), STEEL, form).K for form in (EXACT, HAMROCK, PRINTED)
    )
    assert fit == pytest.approx(exact, rel=0.03)  # the accuracy that Hamrock and Brewe state
    assert printed / exact == pytest.approx(1.32, abs=0.02)


def test_errata_equation_3_has_an_extra_factor():
    # for a PA66 cage ball on steel, E* as in eq 3; the printed factor 1/(1 - nu) is 1.43 for steel
    e_star = 1 / ((1 - 0.3**2) / 210e9 + (1 - 0.41**2) / 3.3e9)
    modulus = laws.reduced_modulus(210e9, 0.3, 3.3e9, 0.41)
    assert modulus == pytest.approx(2 * e_star, rel=1e-15)
    r_eq = 6.3e-3 * 4.19e-3 / (6.3e-3 + 4.19e-3)
    printed = 4 * e_star * np.sqrt(r_eq) / (3 * (1 - 0.3))
    assert printed / laws.sphere_stiffness(6.3e-3, 4.19e-3, modulus) == pytest.approx(
        1 / 0.7, rel=1e-15
    )
    assert 1 / 0.7 == pytest.approx(1.43, abs=0.005)


def test_like_bodies_have_the_plane_strain_modulus():
    assert laws.reduced_modulus(210e9, 0.3, 210e9, 0.3) == pytest.approx(STEEL, rel=1e-15)
    # in contact with a rigid body, only the elastic body deforms
    assert laws.reduced_modulus(3.3e9, 0.41, 1e30, 0.3) == pytest.approx(
        2 * 3.3e9 / (1 - 0.41**2), rel=1e-15
    )


@pytest.mark.parametrize("side, sign", [(INNER, -1), (OUTER, 1)])
@pytest.mark.parametrize("angle", [0.0, 0.5, 1.4, np.pi / 2])
def test_effective_radii_are_the_curvatures_of_the_surfaces(side, sign, angle):
    r_x, r_y = groove_radii(side, np.cos(angle))
    # in the rolling direction, the normal curvature of a raceway follows from its parallel by
    # Meusnier's theorem: it is cos(angle) divided by the radius of the contact point, and is convex
    # on the inner and concave on the outer raceway; the contact point is R_b cos(angle) away from
    # the pitch circle
    contact = PITCH + sign * BALL * np.cos(angle)
    curvature = 1 / BALL - sign * np.cos(angle) / contact
    assert [1 / r_x, 1 / r_y] == pytest.approx([curvature, 1 / BALL - 1 / 6.552e-3], rel=1e-13)


@pytest.mark.parametrize(
    "bodies", [((210e9, 0.3), (3.3e9, 0.41)), *(((2e11, nu), (2e11, nu)) for nu in (0.0, 0.3, 0.5))]
)
def test_mindlin_adds_compliances(bodies):
    # the compliance of each body, multiplied by a, is (2 - nu)/(8 G) tangentially and
    # (1 - nu^2)/(2 E) normally
    tangential = sum((2 - nu) * 2 * (1 + nu) / (8 * young) for young, nu in bodies)
    normal = sum((1 - nu**2) / (2 * young) for young, nu in bodies)
    (E1, nu1), (E2, nu2) = bodies
    found = laws.tangential_ratio(E1, nu1, E2, nu2)
    assert found == pytest.approx(normal / tangential, rel=1e-14)
