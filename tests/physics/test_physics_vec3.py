# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of the rotation in vec3.h against scipy."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

A, B = np.array([0.3, -1.2, 2.5]), np.array([-0.7, 0.4, 1.1])
ROUNDING = 1e-15  # error of a few operations on numbers of order one


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
