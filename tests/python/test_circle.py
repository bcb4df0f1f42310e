# SPDX-License-Identifier: GPL-2.0-or-later
"""The distance of the balls from the circle of the inner groove is compared with closed-form
geometry, and its derivatives with finite differences."""

import numpy as np
import pytest
from raceway.theory import circle
from scipy.spatial.transform import Rotation

RADIUS = 30.552e-3
AZIMUTH = np.array([0.1, 1.3, 2.9, 4.4])
BALL = np.array([[30.3e-3, 0.02e-3], [30.27e-3, -0.05e-3], [30.35e-3, 0.11e-3], [30.31e-3, 0.0]])
PLACE = np.array([21e-6, -34e-6, 90e-6, 4e-3, -5.8e-3])


def axis(tilt):
    """Return the axis e of a ring; the ring's reported tilts are arcsines of components of e."""
    x, y = np.sin(tilt[1]), -np.sin(tilt[0])
    return np.array([x, y, np.sqrt(1 - x * x - y * y)])


def test_exact_circle_is_the_nearest_of_its_points():
    """The points of the circle are rotated with scipy. A fine search and a parabola through three
    points find the nearest point."""
    e = axis(PLACE[3:])
    turn, _ = Rotation.align_vectors([e], [[0, 0, 1]])
    phi = np.linspace(0, 2 * np.pi, 40001)
    points = PLACE[:3] + turn.apply(
        RADIUS * np.stack([np.cos(phi), np.sin(phi), np.zeros_like(phi)], 1)
    )
    reach = circle.exact(BALL, PLACE, AZIMUTH, RADIUS)
    for ball, psi, distance, line in zip(BALL, AZIMUTH, reach.distance, reach.line):
        centre = np.array([ball[0] * np.cos(psi), ball[0] * np.sin(psi), ball[1]])
        squared = ((points - centre) ** 2).sum(1)
        k = int(np.argmin(squared))
        low, mid, high = squared[[k - 1, k, k + 1]]
        least = mid - (high - low) ** 2 / (8 * (high - 2 * mid + low))
        # the parabola's error in the squared distance is (step r)^4/s^2, here a fraction of 1e-9
        assert distance**2 == pytest.approx(least, rel=1e-7)
        assert line == pytest.approx(
            (centre - points[k]) / np.sqrt(mid), abs=2 * np.pi / 40000 * RADIUS / distance
        )


def test_straight_circle_is_harris():
    """A_1 is the displacement along z plus tilt times radius, and A_2 is the radius plus the
    displacement along the ball's radius (Harris, ch. 7)."""
    x, y, z, tx, ty = PLACE
    reach = circle.straight(BALL, PLACE, AZIMUTH, RADIUS)
    radial = BALL[:, 0] - (RADIUS + x * np.cos(AZIMUTH) + y * np.sin(AZIMUTH))
    axial = BALL[:, 1] - (z + RADIUS * (tx * np.sin(AZIMUTH) - ty * np.cos(AZIMUTH)))
    assert reach.distance == pytest.approx(np.hypot(radial, axial), rel=1e-12)
    assert reach.section * reach.distance[:, None] == pytest.approx(
        np.stack([radial, axial], 1), rel=1e-12
    )


def test_both_agree_without_shift_and_tilt():
    here = [f(BALL, np.zeros(5), AZIMUTH, RADIUS) for f in (circle.straight, circle.exact)]
    for name in ("distance", "slope", "section", "line"):
        assert getattr(here[0], name) == pytest.approx(getattr(here[1], name), rel=1e-11, abs=1e-12)


@pytest.mark.parametrize("reach", [circle.straight, circle.exact])
def test_derivatives(reach):
    """Central differences with steps of 0.1 um and 1 urad have a relative error of
    (step/distance)^2 = 2e-7 and a rounding error of 1e-9."""
    now = reach(BALL, PLACE, AZIMUTH, RADIUS)
    for k in range(7):
        step = np.zeros(7)
        step[k] = 1e-6 if k > 4 else 1e-7
        ahead, back = (
            reach(BALL + sign * step[:2], PLACE + sign * step[2:], AZIMUTH, RADIUS)
            for sign in (1, -1)
        )
        slope = (ahead.distance - back.distance) / (2 * step[k])
        curve = (ahead.slope - back.slope) / (2 * step[k])
        assert now.slope[:, k] == pytest.approx(
            slope, rel=1e-6, abs=1e-6 * np.abs(now.slope[:, k]).max()
        )
        assert now.curve(7)[:, :, k] == pytest.approx(
            curve, rel=1e-6, abs=1e-6 * np.abs(now.curve(7)[:, :, k]).max()
        )


def test_conjugate_moment():
    """The conjugate moment is the work of a fixed moment during a small rotation of the axis,
    M . (e x de), divided by the change of one tilt."""
    moment, tilt = np.array([3.0, -7.0, 0.0]), PLACE[3:]
    for k in range(2):
        step = 1e-6 * np.eye(2)[k]
        e, turned = axis(tilt), (axis(tilt + step) - axis(tilt - step)) / 2e-6
        assert circle.conjugate(moment[:2], tilt)[k] == pytest.approx(
            moment @ np.cross(e, turned), rel=1e-8
        )
    assert circle.conjugate(moment[:2], np.zeros(2)) == pytest.approx(moment[:2])
