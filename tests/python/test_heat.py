# SPDX-License-Identifier: GPL-2.0-or-later
"""Cooling, heat balance, clearance and flash temperature are compared with published values and
closed-form solutions."""

import numpy as np
import pytest
from raceway import heat, hertz, makers, sliding
from raceway.theory.bearing import INNER

BOUNDARIES = {
    "6208": makers.Boundary(40.0, 80.0, 18.0, "62", 19e3),
    "6205": makers.Boundary(25.0, 52.0, 15.0, "62", 7.8e3),
    "6306": makers.Boundary(30.0, 72.0, 19.0, "63", 16e3),
}
CATALOGUE = {"6208": 18000, "6205": 28000, "6306": 20000}


def test_cooling():
    assert heat.cooling(40.0, 80.0, 18.0) == pytest.approx(2.17, abs=0.005)


def test_cooling_over_size():
    """The heat flow density is constant up to an area of 50 000 mm2, and falls above it without a
    jump (ISO 15312)."""
    area = np.array([1e4, 5e4, 5e4 + 1e-6, 1e5, 2e5])
    ring = np.sqrt(area / (0.6 * np.pi))  # mm, mean diameter of a bearing with B = 0.3 d_m
    cooled = [heat.cooling(0.5 * one, 1.5 * one, 0.3 * one) for one in ring]
    assert cooled[1] / cooled[0] == pytest.approx(5, rel=1e-12)
    assert cooled[2] == pytest.approx(cooled[1], rel=1e-9)
    assert cooled[4] / cooled[3] == pytest.approx(2**0.66, rel=1e-12)
    assert cooled[3] / cooled[1] == pytest.approx(2**0.66, rel=1e-12)


@pytest.mark.parametrize(("name", "made", "carried"), [("6208", 93.7, 108.6), ("6205", 46.6, 58.1),
                                                       ("6306", 72.1, 97.4)])  # fmt: skip
def test_friction_and_cooling_together(name, made, carried):
    one, speed = BOUNDARIES[name], CATALOGUE[name]
    torque = makers.skf(one, 0.05 * one.static_rating, 0.0, speed, 12.0)
    assert 1e-3 * torque.total * speed * np.pi / 30 == pytest.approx(made, abs=0.05)
    assert 50 * heat.cooling(one.bore, one.outside, one.width) == pytest.approx(carried, abs=0.05)


def test_reference_speed():
    assert heat.reference_speed(BOUNDARIES["6208"]) == pytest.approx(20890, rel=5e-4)
    assert heat.reference_speed(BOUNDARIES["6208"], 6.3) == pytest.approx(12700, abs=50)


@pytest.mark.parametrize("name", BOUNDARIES)
def test_reference_speed_near_the_catalogue_s(name):
    """The oil reaches the middle of the lowest ball. Without drag, the computed reference speed is
    higher than that in the catalogue."""
    ball = {"6208": 12.6, "6205": 7.94, "6306": 12.3}[name]
    found = heat.reference_speed(BOUNDARIES[name], ball / 2)
    assert found == pytest.approx(CATALOGUE[name], rel=0.30)
    assert found < CATALOGUE[name] < heat.reference_speed(BOUNDARIES[name])


def test_balance():
    # for a power that decreases linearly: W (T - 20) = 100 - 0.5 T
    found = heat.balance(lambda t: 100 - 0.5 * t, 2.0)
    assert found == pytest.approx((100 + 40) / 2.5, abs=1e-5)
    with pytest.raises(ValueError, match="exceeds the cooling by 0.1 W/K to 20 C"):
        heat.balance(lambda t: 100.0, 0.1)


def test_three_nodes():
    found = heat.three_nodes(20.0, 10.0, shaft=1.0, housing=2.0, contact=0.7, ambient=25.0)
    assert (found.inner - 25) + 2 * (found.outer - 25) == pytest.approx(30, rel=1e-12)
    # the heat from the balls and half of the outer contacts' losses leave through the housing
    assert 0.7 * (found.balls - found.outer) + 5 == pytest.approx(2 * (found.outer - 25))
    # with perfect contact there is a single temperature, as in the model with one node
    tight = heat.three_nodes(20.0, 10.0, shaft=1.0, housing=2.0, contact=1e9)
    assert list(tight) == pytest.approx([30.0] * 3, abs=1e-6)


def test_clearance_by_temperature(bearing):
    assert 1e6 * heat.clearance_change(bearing, 10.0, 5.0, 0.0) == pytest.approx(-7.3, abs=0.05)
    change = heat.clearance_change(bearing, 10.0, 10.0, 10.0)
    # at equal temperatures only the clearance itself expands, and it is zero here
    assert change == pytest.approx(0, abs=1e-12)


def test_flash(bearing):
    """At 477.5 rpm and at 9549 rpm, the flash temperature rise is 2 K and 8 K under the largest
    heat flux of free rolling, 0.317 mu p s_e."""
    r_x, r_y = bearing.effective_radii(INNER)
    modulus, ellipse = bearing.effective_modulus, hertz.exact(r_x, r_y)
    a, b = hertz.semi_axes(ellipse, modulus, 2436.2)
    r_d = sliding.deformed_radius(bearing.inner_groove, bearing.ball_radius)
    peak = hertz.pressure(ellipse, modulus, 2436.2)
    for speed, share, surface in ((0.724764, 1.0, 2), (14.4946, 0.86, 8)):
        edge = sliding.edge_slip(speed, a, r_d, r_x)
        flux = share * 0.317 * 0.05 * peak * edge
        assert heat.flash(flux / 2, b, speed) == pytest.approx(surface, abs=0.5)
