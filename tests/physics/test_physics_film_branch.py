# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of the film branch, a spring and dashpot in series: step, damping and step limit."""

import mpmath
import numpy as np
import pytest
from film_scene import ROUNDING, SPEEDS
from mpmath import mpf
from raceway import film_damping
from raceway.core import laws
from scipy.linalg import expm


def series(k, h_c, elastic, b, speed, force, rate, step):
    """Return (k_m, 1/tau, force after a step, slope of this force) for a spring and a dashpot in
    series, in 40-digit arithmetic:
    f(t) = f_0 e^(-t/tau) + k_m tau (1 - e^(-t/tau)) d(overlap)/dt."""
    with mpmath.workdps(40):
        k_m = mpf("0.44") * k * min(mpf(h_c) / elastic, 1)
        decay = mpf(speed) / (mpf("1.33") * b)
        part = step * decay
        slope = k_m * step * (-mpmath.expm1(-part) / part if part else 1)
        return [float(v) for v in (k_m, decay, mpmath.exp(-part) * force + slope * rate, slope)]


@pytest.mark.parametrize("speed", [0.0, 1e-6, *SPEEDS])
@pytest.mark.parametrize("step", [1e-9, 1e-6, 1e-4, 1e-2])
@pytest.mark.parametrize("h_c", [160e-9, 3e-5])
def test_branch_against_high_precision(speed, step, h_c):
    k, elastic, b = 2e8, 17e-6, 150e-6
    expected = series(k, h_c, elastic, b, speed, 3.0, 2e-4, step)
    branch = film_damping.branch(k, h_c, elastic, b, speed)
    found = branch.stiffness, 1 / branch.time, *film_damping.advance(3.0, branch, 2e-4, step)
    assert found == pytest.approx(expected, rel=ROUNDING)


@pytest.mark.parametrize("step", [1e-6, 1e-4, 1e-2])
def test_branch_in_a_stage_is_backward_euler(step):
    """The force of the branch satisfies f = f_0 + dt (k_m d(overlap)/dt - f/tau), as required in
    the stages of a second-order implicit method."""
    stiffness, decay = laws.film_branch(2e8, 160e-9, 17e-6, 150e-6, 0.7)
    left, slope = laws.film_branch_step(stiffness, decay, step, True)
    force = left * 3.0 + slope * 2e-4
    assert force == pytest.approx(3.0 + step * (stiffness * 2e-4 - force * decay), rel=1e-12)
    assert slope == pytest.approx((force - 3.0 / (1 + step * decay)) / 2e-4, rel=1e-9)


@pytest.mark.parametrize("time", [1e-7, 3e-6, 1e-5, 1e-4, 1e-2])
@pytest.mark.parametrize("c", [0.0, 300.0])
def test_step_limit_of_the_branch(physics, time, c):
    """The spectral radius shows that the scheme is stable up to the limit, and unstable at 1.25
    times the limit."""
    k, k_m, m = 2e8, 8e7, 8e-3

    def radius(h):
        left = np.exp(-h / time)
        slope = k_m * time * (1 - left)
        # v' = v - h/m (k x + f + c v), x' = x + h v', f' = left f + slope v'
        a = np.array([1 - h * c / m, -h * k / m, -h / m])
        return max(abs(np.linalg.eigvals(
            np.array([a, [h * a[0], 1 + h * a[1], h * a[2]], [slope * a[0], slope * a[1],
                                                             left + slope * a[2]]])
        )))  # fmt: skip

    limit = physics.call("largest_step_with_branch", k=k, c=c, m=m, k_m=k_m, rate=1 / time)
    for part in (0.1, 0.5, 0.9, 0.999):
        assert radius(part * limit) <= 1 + 1e-9
    assert radius(1.25 * limit) > 1
    assert limit > 0.8 * physics.call("largest_step", k=k, c=c, m=m)


def test_branch_is_a_spring_and_a_dashpot_in_series():
    """The exact step of the branch agrees with the matrix exponential of its equation."""
    branch = film_damping.Branch(3e7, 2e-4)
    rate = np.array([[-1 / branch.time, branch.stiffness], [0, 0]])
    for step in (1e-6, 1e-4, 1e-2):
        expected = expm(rate * step) @ [5.0, 1e-4]
        assert film_damping.advance(5.0, branch, 1e-4, step)[0] == pytest.approx(expected[0])
