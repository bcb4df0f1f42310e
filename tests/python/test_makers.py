# SPDX-License-Identifier: GPL-2.0-or-later
"""Makers' formulas for the friction torque give the published values. Their limits and continuity
are tested too, and the bearings that they imply."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from raceway import inputs, makers, static

BEARINGS = Path(__file__).resolve().parents[2] / "inputs/bearings"

B6208 = makers.Boundary(40.0, 80.0, 18.0, "62", 19e3)
SPEEDS = np.array([48.0, 477.5, 1910.0, 9549.0])


def test_skf():
    found = makers.skf(B6208, 5000.0, 0.0, SPEEDS, 46.0)
    for value, expected, half in zip(found.rolling, [12.0, 46.48, 96.84, 140.6],
                                     [0.05, 0.005, 0.005, 0.05]):  # fmt: skip
        assert value == pytest.approx(expected, abs=half)
    for value, expected, half in zip(found.sliding, [187.2, 99.03, 81.43, 81.43],
                                     [0.05, 0.005, 0.005, 0.005]):  # fmt: skip
        assert value == pytest.approx(expected, abs=half)
    assert found.shear == pytest.approx([0.9994, 0.9893, 0.9400, 0.6665], abs=5e-5)
    assert found.starvation == pytest.approx([0.9984, 0.9846, 0.9396, 0.7325], abs=5e-5)
    assert found.total == pytest.approx(found.rolling + found.sliding, rel=1e-15)


def test_sums_with_a_bath_to_mid_ball():
    """The torques are those in section 1, for oil up to the middle of the lowest ball, which is
    half a ball diameter above the raceway."""
    found = makers.skf(B6208, 5000.0, 0.0, SPEEDS, 46.0, level=6.3)
    assert found.total == pytest.approx([199, 147, 181, 246], abs=0.5)


def test_a_bearing_at_rest():
    """The sliding torque remains; the drag of the oil vanishes, as it does at low speeds."""
    slow, still = (makers.skf(B6208, 5000.0, 0.0, speed, 46.0, level=6.3) for speed in (1e-9, 0.0))
    assert still.drag == 0 and slow.drag < 1e-4
    assert still.total == pytest.approx(slow.total, rel=1e-4)


def test_palmgren():
    # the printed row was written from memory with a rounded viscosity, hence the tolerance of 0.6 %
    speed, load = makers.palmgren(B6208, 5000.0, SPEEDS, 46.0)
    assert speed + load == pytest.approx([65, 92, 143, 308], rel=0.006)
    slow, _ = makers.palmgren(B6208, 5000.0, np.array([1.0, 2000 / 46 * 0.999]), 46.0)
    assert slow == pytest.approx(160e-7 * 2 * 60**3, rel=1e-14)
    # at nu n = 2000 the two forms agree within their rounding
    assert 2000 ** (2 / 3) == pytest.approx(160, rel=0.01)


def test_axial_load_joins_on():
    alone = makers.skf(B6208, 5000.0, 0.0, 477.5, 46.0)
    little = makers.skf(B6208, 5000.0, 1e-3, 477.5, 46.0)
    assert little.rolling == pytest.approx(alone.rolling, rel=1e-4)
    assert makers.skf(B6208, 5000.0, -800.0, 477.5, 46.0) == makers.skf(
        B6208, 5000.0, 800.0, 477.5, 46.0
    )
    sine = np.sin(np.radians(24.6 * (800 / 19e3) ** 0.24))
    found = makers.skf(B6208, 5000.0, 800.0, 1e-9, 46.0, boundary=1.0)
    expected = 3.23e-3 * 60**-0.145 * (5000.0**5 + 36.5 * 60**1.5 * 800.0**4 / sine) ** (1 / 3)
    assert found.sliding == pytest.approx(expected, rel=1e-6)


def hertz_sums(zone, angle, power):
    """Return (radial load, thrust, sum of Q^`power`) per ball for balls at a constant contact
    `angle` in rad with loads up to 1, of which the load parameter of Sjoevall is `zone`."""
    azimuth = (np.arange(3600) + 0.5) * np.pi / 1800
    load = np.maximum(1 - (1 - np.cos(azimuth)) / (2 * zone), 0.0) ** 1.5
    radial = np.mean(load * np.cos(azimuth)) * np.cos(angle)
    return radial, load.mean() * np.sin(angle), np.mean(load**power)


def test_rolling_under_thrust_is_that_of_a_load_zone_of_half_the_balls():
    """R2 of deep groove bearings, the radial load that rolls as heavily as a thrust times sin
    alpha, follows from a bearing without clearance whose contacts resist with Q^0.54."""
    radial, _, rolled = hertz_sums(0.5, 0.0, 0.54)
    for _, r2, *_ in makers.CONSTANTS.values():
        assert r2 == pytest.approx(radial / rolled ** (1 / 0.54), rel=1e-3)


@pytest.mark.parametrize("name", ["6204", "6205", "6208", "6308", "6310"])
@pytest.mark.parametrize("thrust", [0.02, 0.1, 0.4])  # over C0
def test_contact_angle_of_deep_groove_bearings(name, thrust):
    """SKF's contact angle is that of a bearing without clearance whose groove radii add up to 1.046
    ball diameters; `tests/bench/torque_points.py` uses such grooves."""
    path = BEARINGS / name
    own, rating = inputs.bearing(path), inputs.boundary(path).static_rating
    size = own.ball_diameter
    bearing = replace(own, inner_groove=0.518 * size, outer_groove=0.528 * size)

    def angle(clearance):
        loads = 0.0, thrust * rating
        state = static.equilibrium(bearing, *loads, clearance=clearance, held=static.STRAIGHT)
        return np.degrees(state.inner.angle[0])

    assert angle(0.0) == pytest.approx(makers.contact_angle(rating, thrust * rating), rel=0.03)
    assert angle(13e-6) > makers.contact_angle(rating, thrust * rating) * 1.03


@pytest.mark.parametrize("zone", [0.5, 0.6, 0.8, 1.0, 1.5, 2.0, 3.0, 5.0, 20.0])
def test_thrust_of_angular_contact_bearings(zone):
    """The torques under a radial load and a thrust are those of the loads of the balls: Q^0.54 for
    rolling and Q^(4/3) for spin. A radial load alone loads half of the balls, and the thrust that
    this requires is part of it."""
    bearing, angle = makers.Boundary(40.0, 80.0, 18.0, "72", 21.3e3), np.radians(40.0)
    point = 1e-3, 46.0  # at low speed, without centrifugal forces

    def torque(radial, axial):
        return makers.skf(bearing, radial, axial, *point)

    half = [hertz_sums(0.5, angle, power) for power in (0.54, 4 / 3)]
    scale = 1000 / half[0][0]  # N
    alone = torque(1000.0, 0.0)
    for power, (*_, sum_at_half), part in zip((0.54, 4 / 3), half, ("rolling", "sliding")):
        radial, axial, total = hertz_sums(zone, angle, power)
        found = getattr(torque(scale * radial, scale * axial), part) / getattr(alone, part)
        assert found == pytest.approx(total / sum_at_half, rel=0.15)
    # the induced thrust follows from the same loads
    assert half[0][1] / half[0][0] == pytest.approx(makers.INDUCED, rel=0.03)
    assert torque(1000.0, 1000.0 * makers.INDUCED) == alone


def test_drag():
    assert makers.drag(B6208, 1000.0, 46.0, 0.0) == 0
    levels = np.linspace(0.5, 72.0, 60)
    found = [makers.drag(B6208, 5000.0, 46.0, level) for level in levels]
    assert np.all(np.diff(found) > 0)
    # continuous at t = pi, where the whole lower half is wetted
    ends = [makers.drag(B6208, 5000.0, 46.0, 36.0 + side) for side in (-1e-6, 1e-6)]
    assert ends[0] == pytest.approx(ends[1], rel=1e-6)
    with pytest.raises(ValueError, match="oil level 73.0 mm must lie between 0 and 72 mm"):
        makers.drag(B6208, 5000.0, 46.0, 73.0)


def test_unknown_series():
    with pytest.raises(ValueError, match="series '32' is not one of 60, 62"):
        makers.Boundary(40.0, 80.0, 18.0, "32", 19e3)
    wide = makers.Boundary(40.0, 80.0, 18.0, "622", 19e3)
    point = 5000.0, 1000.0, SPEEDS, 46.0
    assert (makers.skf(wide, *point).total == makers.skf(B6208, *point).total).all()
