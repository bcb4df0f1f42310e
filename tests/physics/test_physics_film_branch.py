# SPDX-License-Identifier: GPL-2.0-or-later
"""The film's branch, a spring and a dashpot in series: its step, its damping and its step limit."""

import numpy as np
import pytest
from film_scene import OIL, ROUNDING, SPEEDS
from raceway import film, film_damping
from scipy.linalg import expm


@pytest.mark.parametrize("speed", [0.0, 1e-6, *SPEEDS])
@pytest.mark.parametrize("step", [1e-9, 1e-6, 1e-4, 1e-2])
@pytest.mark.parametrize("h_c", [160e-9, 3e-5])
def test_branch_as_in_python(physics, speed, step, h_c):
    k, elastic, b = 2e8, 17e-6, 150e-6
    branch = film_damping.branch(k, h_c, elastic, b, speed)
    expected = film_damping.advance(3.0, branch, 2e-4, step)
    found = physics.call(
        "film_step",
        k=k,
        h_c=h_c,
        compression=elastic,
        b=b,
        speed=speed,
        force=3.0,
        rate=2e-4,
        dt=step,
        stage=0,
    )
    assert found[0] == pytest.approx(branch.stiffness, rel=1e-14)
    assert found[1] == pytest.approx(1 / branch.time, rel=1e-14)
    assert found[2:] == pytest.approx(expected, rel=ROUNDING)


@pytest.mark.parametrize("step", [1e-6, 1e-4, 1e-2])
def test_branch_in_a_stage_is_backward_euler(physics, step):
    """Its force solves f = f_0 + dt (k_m d(overlap)/dt - f/tau), the form that an implicit method
    of second order needs of its stages."""
    found = physics.call(
        "film_step",
        k=2e8,
        h_c=160e-9,
        compression=17e-6,
        b=150e-6,
        speed=0.7,
        force=3.0,
        rate=2e-4,
        dt=step,
        stage=1,
    )
    stiffness, decay, force, slope = found
    assert force == pytest.approx(3.0 + step * (stiffness * 2e-4 - force * decay), rel=1e-12)
    assert slope == pytest.approx((force - 3.0 / (1 + step * decay)) / 2e-4, rel=1e-9)


def test_dashpot_of_the_top_ball(physics, inner):
    """659, 331, 219, 135 N s/m (0.59 for 0.44 x 1.33, so 0.6 % more than the branch)."""
    for speed, expected in zip((0.072476, 0.724764, 2.899, 14.4946), (659, 331, 219, 135)):
        load = 2436.2
        elastic = (load / inner.stiffness) ** (2 / 3)
        g = film.group(*OIL, inner.modulus, inner.r_x, inner.kappa, speed, load)
        k_m, rate, *_ = physics.call(
            "film_step",
            k=1.5 * load / elastic,
            h_c=film.h_c(inner.r_x, g),
            compression=elastic,
            b=inner.raceway.radial().b * np.sqrt(elastic),
            speed=speed,
            force=0.0,
            rate=0.0,
            dt=1e-6,
            stage=0,
        )
        assert k_m / rate * 0.59 / (0.44 * 1.33) == pytest.approx(expected, abs=1.5)


@pytest.mark.parametrize("time", [1e-7, 3e-6, 1e-5, 1e-4, 1e-2])
@pytest.mark.parametrize("c", [0.0, 300.0])
def test_step_limit_of_the_branch(physics, time, c):
    """Stable at the limit: spectral radius of the scheme; unstable at 1.5 times it or twice it."""
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
    """The exact step of the branch against the matrix exponential of its equation."""
    branch = film_damping.Branch(3e7, 2e-4)
    rate = np.array([[-1 / branch.time, branch.stiffness], [0, 0]])
    for step in (1e-6, 1e-4, 1e-2):
        expected = expm(rate * step) @ [5.0, 1e-4]
        assert film_damping.advance(5.0, branch, 1e-4, step)[0] == pytest.approx(expected[0])
