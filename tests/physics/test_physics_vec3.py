# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of vec3.h against numpy and the rotations in scipy."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

A, B = np.array([0.3, -1.2, 2.5]), np.array([-0.7, 0.4, 1.1])
ROUNDING = 1e-15  # error of a few operations on numbers of order one


def test_algebra(physics):
    expected = np.concatenate([A + B, A - B, 3.5 * A, 3.5 * A, -A, A + B, A - B, A + B])
    assert physics.call("vec3_algebra", pa=A, pb=B, s=3.5) == pytest.approx(
        expected, abs=4 * ROUNDING
    )


def test_products(physics):
    assert physics.call("vec3_cross", A, B) == pytest.approx(np.cross(A, B), abs=4 * ROUNDING)
    assert physics.call("vec3_dot", A, B) == pytest.approx(A @ B, abs=4 * ROUNDING)
    assert physics.call("vec3_norm", A) == pytest.approx(np.linalg.norm(A), abs=4 * ROUNDING)


@pytest.mark.parametrize("angle", [1e-9, 1e-3, 0.5, 3.0, 7.0])
def test_rotation_is_the_right_handed_one(physics, angle):
    w = angle * B / np.linalg.norm(B)
    # the angle is rounded before its sine is evaluated
    assert physics.rotate(A, w) == pytest.approx(
        Rotation.from_rotvec(w).apply(A), abs=10 * ROUNDING * (1 + angle)
    )


def test_no_rotation_is_exact(physics):
    assert np.array_equal(physics.rotate(A, np.zeros(3)), A)


def test_derivative_of_a_rotation_is_the_cross_product(physics):
    h = 1e-5  # the error is h^2/6 |w|^3 |a| + rounding/h, both terms below 1e-10
    slope = (physics.rotate(A, h * B) - physics.rotate(A, -h * B)) / (2 * h)
    assert slope == pytest.approx(
        np.cross(B, A), abs=h**2 * np.linalg.norm(B) ** 3 * np.linalg.norm(A) + 1e-10
    )
