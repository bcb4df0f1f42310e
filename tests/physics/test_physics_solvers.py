# SPDX-License-Identifier: GPL-2.0-or-later
"""Solvers of linear systems in the implicit step, compared with numpy."""

import numpy as np
import pytest


@pytest.mark.parametrize("n", [3, 6])
def test_blocks_against_numpy(physics, n):
    rng = np.random.default_rng(5)
    A, r = np.zeros((4, 6, 6)), np.zeros((4, 6))
    A[:, :n, :n] = rng.normal(size=(4, n, n)) * 0.3 + 3 * np.eye(n)
    r[:, :n] = rng.normal(size=(4, n))
    expected = np.linalg.solve(A[:, :n, :n], r[:, :n, None])[..., 0]
    physics.call("blocks", n=n, A=A, r=r)
    np.testing.assert_allclose(r[:, :n], expected, rtol=1e-13, atol=1e-14)


@pytest.mark.parametrize("n", [1, 2, 5, 12])
def test_dense_against_numpy(physics, n):
    rng = np.random.default_rng(6)
    A, y = rng.normal(size=(n, n)), rng.normal(size=n)
    expected = np.linalg.solve(A, y)
    physics.call("dense", n=n, A=A, y=y)
    np.testing.assert_allclose(y, expected, rtol=1e-11, atol=1e-12)


@pytest.mark.parametrize("links", ["circle", "open", "broken"])
@pytest.mark.parametrize("balls", [1, 2, 3, 9])
def test_chain_against_dense(physics, balls, links):
    rng = np.random.default_rng(7)
    n = 2 * balls  # ball, cage ball, ball, ...
    inverse = rng.normal(size=(n, 3, 3)) * 0.1 + np.eye(3)
    pairs = [(k, (k + 1) % n) if k % 2 == 0 else ((k + 1) % n, k) for k in range(n)]
    if links == "open":
        pairs = pairs[:-1]
    if links == "broken":
        pairs = [p for k, p in enumerate(pairs) if k % 5 not in (2, 3)]
    order = rng.permutation(len(pairs))
    pairs = np.array([pairs[i] for i in order], dtype=np.int32).reshape(-1, 2)
    m = len(pairs)
    normals = rng.normal(size=(m, 3))
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    a, x = rng.uniform(0.5, 50, size=m), rng.normal(size=m)
    matrix = np.diag(1 / a)
    for i in range(m):
        for j in range(m):
            for end, body in enumerate(pairs[i]):
                for other, same in enumerate(pairs[j]):
                    if body == same:
                        matrix[i, j] += (
                            (1 if end == other else -1) * normals[i] @ inverse[body] @ normals[j]
                        )
    expected = np.linalg.solve(matrix, x)
    found = physics.call(
        "chain", bodies=n, inverse=inverse, links=m, pairs=pairs, normals=normals, a=a, x=x
    )
    assert found == 1
    np.testing.assert_allclose(x, expected, rtol=1e-11, atol=1e-12)


def test_a_third_link_is_no_chain(physics):
    pairs = np.array([[0, 1], [0, 2], [0, 3]], dtype=np.int32)
    inverse, normals = np.tile(np.eye(3), (4, 1, 1)), np.tile([1.0, 0, 0], (3, 1))
    a, x = np.ones(3), np.ones(3)
    found = physics.call(
        "chain", bodies=4, inverse=inverse, links=3, pairs=pairs, normals=normals, a=a, x=x
    )
    assert found == 0


def test_old_factors_stay(physics):
    """Corrections that reuse earlier factors solve with exactly these factors and do not add masses
    a second time."""
    h = 1e-4
    found = physics.call("old_factors", h=h)
    assert found.reshape(3, 3) == pytest.approx(
        np.array([[1.0, 2.0, 3.0]] * 3) * h / 0.5, rel=1e-14
    )


@pytest.mark.parametrize("again", [0, 1])
def test_corrections_of_the_cage_alone_start_from_the_matrix_of_the_raceways(physics, again):
    """The matrix is restored even after a correction that used the factors of an earlier matrix."""
    want = np.random.default_rng(4).standard_normal(48)
    want[:36:7] += 10.0
    np.testing.assert_array_equal(physics.call("matrix_kept", again=again, matrix=want), want)
