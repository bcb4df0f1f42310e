# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of exp_log.h and arctangent.h against mpmath, and of lanes against scalars."""

import mpmath
import numpy as np
import pytest

# The bound stated at the top of the headers, in units in the last place (ulp) of the result.
UNITS = 2.0


def numbers():
    random = np.random.default_rng(20261121)
    near_one = 1 + np.concatenate(
        [
            random.uniform(-0.3, 0.42, 300),
            10.0 ** random.uniform(-15, -2, 100),
            -(10.0 ** random.uniform(-15, -2, 100)),
        ]
    )
    return {
        "exponential": np.concatenate(
            [
                random.uniform(-708, 709, 500),
                random.uniform(-40, 5, 500),
                random.uniform(-1e-3, 1e-3, 100),
                [0.0],
            ]
        ),
        "logarithm": np.concatenate(
            [
                near_one,
                10.0 ** random.uniform(-307, 308, 500),
                10.0 ** random.uniform(-9, 4, 500),
                [2.0**-1022, 1.0, 2.0],
            ]
        ),
        "arctangent": np.concatenate(
            [
                random.uniform(-1.2, 1.2, 1000),
                random.choice([-1.0, 1.0], 500) * 10.0 ** random.uniform(-300, 300, 500),
                [-0.0, 0.2361, 0.7208, 1.0, 1 / 0.7208, 1 / 0.2361],
            ]
        ),
    }


@pytest.mark.parametrize(
    "name, exact",
    [("exponential", mpmath.exp), ("logarithm", mpmath.log), ("arctangent", mpmath.atan)],
)
def test_last_place(physics, name, exact):
    x = numbers()[name]
    found = physics.elementary(name, x)[0]
    with mpmath.workprec(160):
        miss = [
            abs(
                float(
                    (mpmath.mpf(float(f)) - exact(mpmath.mpf(float(v))))
                    / mpmath.mpf(float(np.spacing(abs(f))))
                )
            )
            for f, v in zip(found, x)
        ]
    assert max(miss) < UNITS


def test_rough_ones(physics):
    """The errors of the rough functions are within the bounds stated at the top of the header, and
    vanish at 0 and 1."""
    x = np.append(np.linspace(-1, 0, 2001), -1e3)
    one, four = physics.elementary("rough_exponential", x)
    assert np.abs(one[:-1] / np.exp(x[:-1]) - 1).max() < 0.02
    assert one[-1] == one[0] and one[-2] == 1
    assert one.tobytes() == four.tobytes()
    x = np.append(np.geomspace(1e-6, 1e6, 20001), 1.0)
    one, four = physics.elementary("rough_logarithm", x)
    assert np.abs(one - np.log(x)).max() < 3e-4
    assert one[-1] == 0
    assert one.tobytes() == four.tobytes()


@pytest.mark.parametrize("name", ["exponential", "logarithm", "arctangent"])
def test_lanes_have_the_bits_of_one_number(physics, name):
    x = numbers()[name]
    one, four = physics.elementary(name, x)
    assert one.tobytes() == four.tobytes()


def test_ends_of_the_range(physics):
    for found in physics.elementary(
        "exponential", np.array([-709.0, -np.inf, 709.1, np.inf, np.nan, -0.0])
    ):
        np.testing.assert_array_equal(found, [0, 0, np.inf, np.inf, np.nan, 1])
    for found in physics.elementary("logarithm", np.array([0.0, 5e-324, 2.0**-1023, np.nan, 1.0])):
        np.testing.assert_array_equal(found, [-np.inf, -np.inf, -np.inf, np.nan, 0])
