# SPDX-License-Identifier: GPL-2.0-or-later
"""Fixed points are found by Anderson acceleration (core/numbers/fixed_point.h)."""

import numpy as np
import pytest
from raceway.core import library


def search(g, x, values, reach=1e9, weights=None):
    """Return the points x at which the map `g` is evaluated, and the library's result after
    each."""
    starts, images, said = [], [], []
    weights = np.ones(len(x)) if weights is None else weights
    for _ in range(values):
        starts, images = [*starts, x], [*images, g(x)]
        x = np.zeros(len(x))
        said.append(
            library().call(
                "fixed_point",
                starts=len(starts),
                n=len(x),
                reach=reach,
                x=np.array(starts),
                g=np.array(images),
                weights=weights,
                next=x,
            )
        )
    return [*starts, x], said


def affine(seed=3, slow=(0.9, -0.8, 0.6), n=12):
    """Return a map and its fixed point. The map has a few slow modes; all other modes converge
    after one evaluation."""
    numbers = np.random.default_rng(seed)
    modes = numbers.normal(size=(n, n))
    shares = np.zeros(n)
    shares[: len(slow)] = slow
    matrix = modes @ np.diag(shares) @ np.linalg.inv(modes)
    point = numbers.normal(size=n)
    return lambda x: point + matrix @ (x - point), point


def test_slow_modes_take_a_value_each():
    """As in GMRES, the search needs one evaluation of the map for all fast modes, one for each slow
    mode, and one more."""
    g, point = affine()
    starts, said = search(g, np.zeros(12), 5)
    assert np.abs(starts[-1] - point).max() < 1e-8 < 1e-2 < np.abs(starts[3] - point).max()
    marched = np.zeros(12)
    for _ in range(100):
        marched = g(marched)
    assert np.abs(marched - point).max() > 1e-6  # iterating the map alone converges slowly


def test_distance_is_the_way_to_the_fixed_point():
    g, point = affine(slow=(0.9,))
    starts, said = search(g, g(np.zeros(12)), 2)
    assert said[1].distance == pytest.approx(np.linalg.norm(starts[1] - point), rel=1e-6)
    assert said[0].distance == np.inf and said[0].contraction == 0.0


def test_weights():
    """The search also updates components of x with zero weight, but they do not affect the other
    components."""
    g, point = affine(slow=(0.9,))
    wide = lambda x: np.append(g(x[:12]), 1e6 * np.sin(1e3 * x[12]))  # noqa: E731
    starts, said = search(wide, np.zeros(13), 4, weights=np.append(2.0 * np.ones(12), 0.0))
    alone, own = search(g, np.zeros(12), 4)
    np.testing.assert_allclose(starts[-1][:12], alone[-1], atol=1e-9)
    assert said[1].residual == pytest.approx(2.0 * own[1].residual, rel=1e-9)


def test_reach():
    """If the residuals do not change, the search moves along them by up to `reach`."""
    step = np.array([1e-3, -2e-3, 0.0])
    starts, said = search(lambda x: x + step, np.zeros(3), 3, reach=0.5)
    for k in (2, 3):
        moved = starts[k] - (starts[k - 1] + step)
        np.testing.assert_allclose(moved, 0.5 * step / np.linalg.norm(step), rtol=1e-9)
    assert said[-1].contraction == pytest.approx(1.0) and said[-1].distance > 1e3


def test_nonlinear_map():
    """With quadratic terms, the search converges to rounding error, and faster than by iterating
    the map alone."""
    g = lambda x: np.array([0.9 * x[0] + 0.1 * x[1] ** 2, 0.5 * np.cos(x[0])])  # noqa: E731
    starts, said = search(g, np.array([1.0, 1.0]), 12)
    assert said[-1].residual < 1e-12
    marched = np.array([1.0, 1.0])
    for _ in range(12):
        marched = g(marched)
    assert np.abs(g(marched) - marched).max() > 1e-3
