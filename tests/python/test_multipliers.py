# SPDX-License-Identifier: GPL-2.0-or-later
"""The multipliers of a map follow from some of its values (core/numbers/multipliers.h)."""

import numpy as np
import pytest
from raceway.core import library

STABLE, UNSTABLE, WHIRL = 1, 2, 4
STARTS = 5  # as many as a search for a fixed point stores


def multipliers(x, g, noise=0.0):
    """Return the multipliers, their errors, and their kinds."""
    found = [np.full(STARTS, np.nan) for _ in range(3)]
    kind = np.zeros(STARTS, np.int32)
    count = library().call(
        "multipliers",
        starts=len(x),
        n=x.shape[1],
        noise=noise,
        x=x,
        g=g,
        weights=np.ones(x.shape[1]),
        **dict(zip(("real", "imaginary", "error"), found)),
        kind=kind,
    )
    real, imaginary, error = (one[:count] for one in found)
    return real + 1j * imaginary, error, kind[:count]


def matrix(numbers, values, n=20):
    """Return a matrix whose eigenvalues are `values`, with conjugates of complex ones, and zeros.
    Its modes are not orthogonal."""
    block, at = np.zeros((n, n)), 0
    for one in values:
        size = 2 if np.imag(one) else 1
        turn = [[np.real(one), np.imag(one)], [-np.imag(one), np.real(one)]]
        block[at : at + size, at : at + size] = np.array(turn)[:size, :size]
        at += size
    modes = np.eye(n) + 0.5 * numbers.normal(size=(n, n)) / n**0.5
    return modes @ block @ np.linalg.inv(modes)


def marched(a, start, starts=STARTS):
    """Return successive starts and the values of the map."""
    x = [start]
    for _ in range(starts):
        x.append(a @ x[-1])
    return np.array(x[:-1]), np.array(x[1:])


@pytest.mark.parametrize(
    "values, kind",
    [
        ((0.9,), STABLE),
        ((-0.7, 0.3), STABLE),
        ((0.6 + 0.5j, 0.4), STABLE | WHIRL),
        ((1.1, 0.6), UNSTABLE),
        ((0.9 + 0.6j, 0.8), UNSTABLE | WHIRL),
    ],
)
@pytest.mark.parametrize("jumps", [False, True])
def test_multipliers_are_the_eigenvalues(values, kind, jumps):
    """They are exact for chosen starts. If each value of the map is the next start, the faster
    modes are hardly visible, and the error of the slowest is estimated."""
    numbers = np.random.default_rng(5)
    a = matrix(numbers, values)
    x, g = marched(a, a @ numbers.normal(size=20))
    if jumps:
        x = (a @ numbers.normal(size=(20, STARTS))).T
        g = x @ a.T
    found, error, kinds = multipliers(x, g)
    exact = np.concatenate([np.unique([one, np.conj(one)]) for one in values])
    largest = np.abs(exact).max()
    assert kinds[0] == kind
    assert np.abs(found[0]) == pytest.approx(largest, abs=max(1e-9, 2 * error[0]))
    assert error[0] < 0.01 * largest
    if jumps:
        assert all(np.abs(found - one).min() < 1e-9 for one in exact)


def test_noise_is_no_multiplier():
    """Values that agree with no map have no multiplier with a small error, and a scene is called
    unstable only if its multiplier exceeds 1 by more than its error."""
    numbers = np.random.default_rng(2)
    for _ in range(50):
        _, error, kind = multipliers(*numbers.normal(size=(2, STARTS, 20)))
        assert error[0] > 0.3 and kind[0] == 0


def test_the_last_values_may_be_too_close_to_each_other():
    """If the last values differ by little more than noise, the multipliers follow from earlier
    ones."""
    numbers = np.random.default_rng(4)
    a = matrix(numbers, (0.8,))
    far, value = marched(a, a @ numbers.normal(size=20), 3)
    near = 1e-6 * far[:2]
    x = np.concatenate([far, near])
    g = np.concatenate([value, near @ a.T]) + 1e-7 * numbers.normal(size=(5, 20))
    found, error, kind = multipliers(x, g)
    assert found[0] == pytest.approx(0.8, rel=1e-3) and error[0] < 1e-3 and kind[0] == STABLE


def test_errors_include_that_of_the_values():
    """After a fast decay, the last values differ by little more than their own errors. If these are
    given, the errors of the multipliers include them."""
    numbers = np.random.default_rng(6)
    size, exact, wrong = 1e-7, np.array([0.02, 0.01, 0.0]), [0, 0]
    for _ in range(300):
        a = matrix(numbers, exact[:2])
        x, g = marched(a, 1e-4 * a @ numbers.normal(size=20), 4)
        g = g + size / 20**0.5 * numbers.normal(size=g.shape)
        x[1:] = g[:-1]
        for k, noise in enumerate((0.0, 3.0 * size)):
            found, error, _ = multipliers(x, g, noise)
            wrong[k] += np.abs(found[0] - exact).min() > error[0]
    assert wrong[0] > 30 and wrong[1] == 0


def test_starts_that_do_not_differ_have_no_multipliers():
    x = np.ones((3, 20))
    found, _, _ = multipliers(x, 2 * x)
    assert len(found) == 0
