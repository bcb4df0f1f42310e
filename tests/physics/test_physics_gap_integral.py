# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of gap_integral.h and groove_shoulder.h: the integral over the gap around a contact is
compared with exact integrals, and the reach of a groove with its geometry."""

import numpy as np
import pytest
from physics_c import BALL, INNER, OUTER, PITCH, groove_radii
from raceway import capacitance_outside, groove_width, hertz
from raceway.core import laws
from raceway.theory.bearing import Bearing
from raceway.theory.groove_width import HalfWidths
from references import capacitance_integral
from references import surroundings as reference

SMALL = dict(
    ball_radius=7.938e-3 / 2, pitch_radius=39.04e-3 / 2, groove_radius=0.515 * 7.938e-3, side=OUTER
)
TINY = dict(
    ball_radius=3.968e-3 / 2, pitch_radius=7.5e-3, groove_radius=0.53 * 3.968e-3, side=INNER
)


SIZES = pytest.mark.parametrize("size", [{}, SMALL, TINY], ids=["12.6 mm", "7.9 mm", "4.0 mm"])


def groove(physics, size, side, conformity):
    """Return (raceway, ball radius, half-width of the groove, effective radii along and across)."""
    ball = size.get("ball_radius", BALL)
    raceway = physics.raceway(**(size | dict(side=side, groove_radius=2 * conformity * ball)))
    gamma = ball / raceway.data["pitch_radius"]
    r_x = ball * (1 - gamma if side == INNER else 1 + gamma)
    r_y = ball * 2 * conformity / (2 * conformity - 1)
    return raceway, ball, raceway.reach(0.36 * ball)[0], r_x, r_y


@SIZES
@pytest.mark.parametrize("side", [INNER, OUTER])
@pytest.mark.parametrize("conformity", [0.505, 0.52, 0.54])
def test_total_over_the_range_of_the_closed_form(physics, size, side, conformity):
    """The total capacitance of plates and surroundings is accurate to 1.5 % for film thicknesses
    from 20 nm to 2 um, with loads of up to 3 kN on a ball of 12.6 mm, and up to the same pressure
    on smaller balls."""
    raceway, ball, edge, r_x, r_y = groove(physics, size, side, conformity)
    derived, modulus = raceway.radial(), 210e9 / 0.91
    ellipse, widths = hertz.exact(r_x, r_y), HalfWidths(edge, edge)
    for load in np.array([0.1, 30, 900, 3000]) * (ball / BALL) ** 2:
        overlap = (load / derived.K) ** (2 / 3)
        a, b = derived.a * np.sqrt(overlap), derived.b * np.sqrt(overlap)
        for h in (20e-9, 200e-9, 2e-6):
            exact = capacitance_integral.parabola(r_x, r_y, modulus, load, h, edge)
            found = capacitance_outside.loaded(ellipse, modulus, r_x, load, h, widths)
            assert abs(found - exact) < 0.015 * (np.pi * a * b / h + exact), (load, h)


@SIZES
@pytest.mark.parametrize("side", [INNER, OUTER])
def test_closed_forms_in_40_digits(physics, size, side):
    """Closed-form solutions are accurate for rigid surfaces with a clearance below, at and above
    that of concentric circles, and for loaded contacts with thin to thick films."""
    _, ball, edge, r_x, r_y = groove(physics, size, side, 0.505)
    ellipse, widths = hertz.exact(r_x, r_y), HalfWidths(edge, edge)
    for play in 0.01 * ball * np.array([0.01, 0.3, 0.999, 1.0, 1.001, 1.7]):
        exact = reference.rigid(r_x, r_y, 0.01 * ball, play, play, edge)
        package = capacitance_outside.rigid(ellipse, r_x, ball, 1.01 * ball, play, widths)
        assert package == pytest.approx(exact, rel=1e-7), play
    modulus = 210e9 / 0.91
    for load in np.array([0.1, 30, 900]) * (ball / BALL) ** 2:
        for h in (20e-9, 200e-9, 2e-6):
            exact = reference.loaded(r_x, r_y, modulus, load, h, edge)
            package = capacitance_outside.loaded(ellipse, modulus, r_x, load, h, widths)
            assert package == pytest.approx(exact, rel=1e-11)


@pytest.mark.parametrize("side", [INNER, OUTER])
def test_rigid_form_is_that_of_two_parabolas(side):
    """For two parabolas, the integral is 4 pi sqrt(R_x R_y) asinh(S/sqrt(2 R_y g)); the radius
    across the groove deviates from R_y by less than 1 %."""
    gap, edge = 5e-6, 5e-3
    r_x, r_y = groove_radii(side)
    exact = 4 * np.pi * np.sqrt(r_x * r_y) * np.arcsinh(edge / np.sqrt(2 * r_y * gap))
    found = laws.gap_open(*hertz.exact(r_x, r_y), r_x, gap, 1.0, edge, edge)
    assert found == pytest.approx(exact, rel=0.005)


@pytest.mark.parametrize("side", [INNER, OUTER])
def test_reach_of_a_groove(physics, side):
    """With a contact angle, the reach differs between the two sides: it is 4 times the tangent of a
    quarter of the angle between contact and shoulder."""
    raceway = physics.raceway_6208(side)
    gamma = 0.09 * (BALL / PITCH) * (1 if side == INNER else -1)
    cosine = 1 - 2.3e-3 / 6.552e-3
    across = 6.552e-3 * np.sqrt(1 - cosine**2)
    shoulder = np.arctan2(across, BALL - 2.3e-3)
    for angle in (0.0, 0.3, 1.2):
        near, far = raceway.reach(2.3e-3, angle) / BALL
        curved = gamma * np.cos(angle)
        assert near == pytest.approx(4 * np.tan((shoulder - angle) / 4) + curved, rel=1e-12)
        assert far == pytest.approx(4 * np.tan((shoulder + angle) / 4) + curved, rel=1e-12)


@pytest.mark.parametrize("side", [INNER, OUTER])
@pytest.mark.parametrize("angle", [0.0, 0.3])
def test_reach_around_an_ellipse(physics, side, angle):
    """The reach agrees with the Python package: a narrow ellipse does not change the reach, and a
    wide one reduces it by the arc within the ellipse."""
    raceway = physics.raceway_6208(side)
    bearing = Bearing(9, 2 * BALL, 24e-3, 36.6e-3, 6.552e-3, 6.552e-3)
    plain = raceway.reach(2.3e-3, angle)
    for semi_axis in (1e-6, 1e-3, 3e-3, 5e-3):
        found = raceway.reach(2.3e-3, angle, semi_axis)
        exact = groove_width.half_widths(bearing, side, 2.3e-3, angle, semi_axis=semi_axis)
        np.testing.assert_allclose(found, exact, rtol=1e-6)
        assert np.all(np.abs(found - plain) < 4e-5 + 0.03 * semi_axis)
