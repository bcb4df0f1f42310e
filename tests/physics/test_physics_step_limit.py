# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of step_limit.h with velocity Verlet as in the host, at steps just below and just above the
limit."""

import numpy as np
import pytest
from physics_c import BALL_MASS
from raceway.core import laws

SPRING, DAMPER = 4.19e8, 2 * 8.7e3


def verlet(k, c, m, step, steps):
    """Return the largest norm of (x, v in natural units) near the end of a run in which the force
    is computed from x and from the velocity half a step earlier."""
    x, v, force, unit = 1.0, 0.0, -k * 1.0, step
    sizes = []
    for _ in range(steps):
        v += step / 2 * force / m
        x += step * v
        force = -k * x - c * v
        v += step / 2 * force / m
        sizes.append(np.hypot(x, unit * v))
        if sizes[-1] > 1e6:
            break
    return max(sizes[-20:])


@pytest.mark.parametrize(
    "k, c", [(SPRING, 0.0), (SPRING, 500.0), (SPRING, DAMPER), (1.0, DAMPER), (SPRING, 2e6)]
)
def test_the_limit_divides_growth_from_decay(physics, k, c):
    limit = physics.call("largest_step", k=k, c=c, m=BALL_MASS)
    # one per cent away from the limit, the multiplier differs from one by about one per cent (by
    # the square root of this if there is only a spring)
    assert verlet(k, c, BALL_MASS, 0.99 * limit, 4000) < 100
    assert verlet(k, c, BALL_MASS, 1.01 * limit, 4000) > 1e6


def test_closed_forms(physics):
    m = BALL_MASS
    assert physics.call("largest_step", k=SPRING, c=0.0, m=m) == pytest.approx(
        2 * np.sqrt(m / SPRING), rel=1e-15
    )
    assert physics.call("largest_step", k=0.0, c=DAMPER, m=m) == pytest.approx(
        2 * m / DAMPER, rel=1e-15
    )
    h = physics.call("largest_step", k=SPRING, c=DAMPER, m=m)
    assert h**2 * SPRING / m + 2 * h * DAMPER / m == pytest.approx(4, rel=1e-14)
    # a negligible spring must not cause cancellation: (sqrt(c^2 + 4 k m) - c)/k would be 0
    assert physics.call("largest_step", k=1e-12, c=DAMPER, m=m) == pytest.approx(
        2 * m / DAMPER, rel=1e-15
    )
    assert physics.call("largest_step", k=0.0, c=0.0, m=m) == np.inf


def test_numbers_of_the_6208(physics):  # values as printed in docs/theory, Numbers to reproduce
    assert physics.call("largest_step", k=SPRING, c=0.0, m=BALL_MASS) == pytest.approx(
        8.8e-6, abs=0.05e-6
    )
    # film dampers of both raceways at h = 100 nm
    axes = np.array([2.059e-3, 1.993e-3])
    both = laws.film_damping(0.04, axes, 6.3e-3, 100e-9, 0.0).sum()
    assert physics.call("largest_step", k=0.0, c=both, m=BALL_MASS) == pytest.approx(
        0.94e-6, abs=0.02e-6
    )
