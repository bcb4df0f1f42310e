# SPDX-License-Identifier: GPL-2.0-or-later
"""Motion within steps: frames rotate with the balls, and positions are cubics in time."""

import numpy as np
import pytest


@pytest.mark.parametrize("angle", [0.0, 1e-9, 1e-3, -0.1, 0.37, -0.6, 0.6])
def test_small_turn(physics, angle):
    expected = [np.cos(angle), np.sin(angle)]
    assert physics.call("turn", angle) == pytest.approx(expected, rel=3e-16)


def test_turning_frame_keeps_a_circle(physics):
    x, v = np.array([30e-3, 0, 1e-3]), np.array([0, 0.6, 0])
    for _ in range(1000):
        x, v = physics.call("drift", x=x, v=v, h=1e-3)
    assert np.hypot(*x[:2]) == pytest.approx(30e-3, rel=1e-13)
    assert np.arctan2(x[1], x[0]) % (2 * np.pi) == pytest.approx(20.0 % (2 * np.pi), rel=1e-10)
    assert v @ x == pytest.approx(0, abs=1e-15) and np.linalg.norm(v) == pytest.approx(
        0.6, rel=1e-13
    )


def test_between_steps_a_cubic_is_exact(physics):
    place = np.polynomial.Polynomial([0.3, -2.0, 1.5, 4.0])
    t, h = 0.7, 0.4
    for s in (0.0, 0.25, 0.6, 1.0):
        speed = place.deriv()
        ends = dict(x_from=place(t), v_from=speed(t), x_to=place(t + h), v_to=speed(t + h))
        found = physics.call("cubic", s=s, h=h, **ends)
        assert found == pytest.approx(place(t + s * h), rel=1e-14)


def test_between_steps_an_axis_turns_to_fourth_order(physics):
    """Half-way between two instants h apart, the axis of a precessing ring has an error of order
    h^4."""
    errors = []
    for h in (2e-3, 1e-3, 5e-4):
        miss = physics.call("axis_between", [40.0, -60.0, 30.0], h)
        errors.append(np.linalg.norm(miss))
    for coarse, fine in zip(errors, errors[1:]):
        assert 15 < coarse / fine < 17
