# SPDX-License-Identifier: GPL-2.0-or-later
"""Contact derivatives against finite differences, the block arrow solver against a dense one, the turning frame."""

import ctypes
import subprocess
from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="module")
def lib():
    source, target = ROOT / "tests/implicit/implicit_c.cpp", ROOT / "build/test/libimplicit.so"
    target.parent.mkdir(parents=True, exist_ok=True)
    subprocess.run(["g++", "-std=c++17", "-O2", "-ffp-contract=off", "-Wall", "-Wextra", "-fPIC", "-shared",
                    str(source), "-o", str(target)], check=True)
    return ctypes.CDLL(str(target))


def pointer(a):
    return a.ctypes.data_as(ctypes.POINTER(ctypes.c_int if a.dtype == np.int32 else ctypes.c_double))


def ball(overlap=20e-6, angle=0.0, v=(0, 0, 0), w=(0, 0, 0)):
    """A ball at azimuth 0.7 pressed into the outer groove under a contact angle."""
    circle, s, phi = 36.6e-3 - 6.552e-3, 0.252e-3 + overlap, 0.7
    r, z = circle + s * np.cos(angle), s * np.sin(angle)
    u, t = np.array([np.cos(phi), np.sin(phi), 0]), np.array([-np.sin(phi), np.cos(phi), 0])
    v = v[0] * u + v[1] * t + v[2] * np.array([0, 0, 1])
    return np.concatenate([r * u + [0, 0, z], v, w]).astype(float)


def force(lib, state, spin, mu, frozen):
    f = np.zeros(3)
    lib.contact_force(pointer(state), ctypes.c_double(spin), ctypes.c_double(mu), pointer(frozen), pointer(f))
    return f


def derivatives(lib, state, spin, mu, secant):
    D, K, n = np.zeros(9), np.zeros(9), np.zeros(3)
    lib.contact_derivatives(pointer(state), ctypes.c_double(spin), ctypes.c_double(mu), int(secant), pointer(D),
                            pointer(K), pointer(n))
    return D.reshape(3, 3), K.reshape(3, 3), n


def differences(lib, state, spin, mu, first, step):
    """-df/ds over three entries of the state from `first`, with C, mu and v_0 held at their values here."""
    frozen = np.array([-1.0, 0, 0])
    force(lib, state, spin, mu, frozen)
    columns = []
    for k in range(3):
        up, down = state.copy(), state.copy()
        up[first + k] += step
        down[first + k] -= step
        columns.append((force(lib, down, spin, mu, frozen) - force(lib, up, spin, mu, frozen)) / (2 * step))
    return np.array(columns).T


ROLLING = dict(v=(2e-3, 0.6, 1e-3), w=(3.0, -2.0, -95.5))


@pytest.mark.parametrize("angle", [0.0, 0.4])
@pytest.mark.parametrize("mu", [0.0, 0.07])
def test_velocity_derivative_is_exact(lib, angle, mu):
    state = ball(angle=angle, **ROLLING)
    D, _, n = derivatives(lib, state, 0.0, mu, secant=False)
    numeric = differences(lib, state, 0.0, mu, 3, 1e-7)
    assert np.abs(D - numeric).max() < 1e-6 * np.abs(D).max()
    # the spin moves the contact point: w x R n
    R = 6.3e-3
    arm = R * np.array([[0, -n[2], n[1]], [n[2], 0, -n[0]], [-n[1], n[0], 0]])
    spin = differences(lib, state, 0.0, mu, 6, 1e-5)
    assert np.abs(-D @ arm - spin).max() < 1e-6 * np.abs(D @ arm).max() + 1e-9 * np.abs(D).max()


@pytest.mark.parametrize("angle, tolerance", [(0.0, 1e-6), (0.4, 1e-2)])
def test_position_derivative(lib, angle, tolerance):
    """Exact for a radial contact; under an angle the constants' own change with it is left out."""
    state = ball(angle=angle)
    _, K, _ = derivatives(lib, state, 0.0, 0.0, secant=False)
    numeric = differences(lib, state, 0.0, 0.0, 0, 1e-9)
    assert np.abs(K - numeric).max() < tolerance * np.abs(K).max()


def test_turn_of_the_normal(lib):
    """The two terms that move the normal, seen alone: across the groove N/s, along it N/r."""
    state = ball()
    frozen = np.array([-1.0, 0, 0])
    N = np.linalg.norm(force(lib, state, 0.0, 0.0, frozen))
    _, K, n = derivatives(lib, state, 0.0, 0.0, secant=False)
    along = np.array([-n[1], n[0], 0])
    assert K[2, 2] == pytest.approx(N / 0.272e-3, rel=1e-6)
    assert along @ K @ along == pytest.approx(N / np.hypot(*state[:2]), rel=1e-6)


def test_secant_is_dissipative(lib):
    """The secant friction slope has no negative direction, and never less resistance than the tangent."""
    state = ball(v=(0, 0.65, 2e-3), w=(0, 0, -95.5))
    tangent, secant = (derivatives(lib, state, 0.0, 0.07, s)[0] for s in (False, True))
    assert np.linalg.eigvalsh(secant - tangent + (secant - tangent).T).min() > -1e-9 * np.abs(secant).max()
    assert np.linalg.eigvalsh(secant + secant.T).min() > -1e-3 * np.abs(secant).max()


@pytest.mark.parametrize("links", ["none", "circle", "open", "broken"])
@pytest.mark.parametrize("border", [0, 1, 2, 5, 7])
@pytest.mark.parametrize("balls", [1, 2, 3, 9])
def test_arrow_against_dense(lib, balls, border, links):
    rng = np.random.default_rng(7)
    n = 2 * balls    # ball, cage ball, ball, ...
    size = np.array([6, 3] * balls, dtype=np.int32)
    A, B, C = np.zeros((n, 6, 6)), np.zeros((n, border, 6)), np.zeros((n, border, 6))
    r, ry = np.zeros((n, 6)), rng.normal(size=border)
    D = rng.normal(size=(border, border)) + 20 * np.eye(border)
    for k, m in enumerate(size):
        A[k, :m, :m] = rng.normal(size=(m, m)) * 0.3 + 3 * np.eye(m)
        B[k, :, :m], C[k, :, :m] = rng.normal(size=(2, border, m)) * 0.5
        r[k, :m] = rng.normal(size=m)
    pairs = [(k, (k + 1) % n) if k % 2 == 0 else ((k + 1) % n, k) for k in range(n)]
    if links == "open":
        pairs = pairs[:-1]
    if links == "broken":
        pairs = [p for k, p in enumerate(pairs) if k % 5 not in (2, 3)]
    if links == "none" or n == 2 and links != "circle" and not pairs:
        pairs = []
    order = rng.permutation(len(pairs))
    pairs = np.array([pairs[i] for i in order], dtype=np.int32).reshape(-1, 2)
    normals = rng.normal(size=(len(pairs), 3))
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    a = rng.uniform(0.5, 50, size=len(pairs))

    at = np.concatenate([[0], np.cumsum(size)])
    full = np.zeros((at[-1] + border,) * 2)
    rhs = np.zeros(len(full))
    for k, m in enumerate(size):
        full[at[k]:at[k] + m, at[k]:at[k] + m] = A[k, :m, :m]
        full[at[k]:at[k] + m, at[-1]:] = B[k, :, :m].T
        full[at[-1]:, at[k]:at[k] + m] = C[k, :, :m]
        rhs[at[k]:at[k] + m] = r[k, :m]
    full[at[-1]:, at[-1]:] = D
    rhs[at[-1]:] = ry
    for (i, j), e, s in zip(pairs, normals, a):
        g = np.zeros(len(full))
        g[at[i]:at[i] + 3] += e
        g[at[j]:at[j] + 3] -= e
        full += s * np.outer(g, g)
    expected = np.linalg.solve(full, rhs)

    x, y = np.zeros((n, 6)), np.zeros(border)
    assert lib.arrow_solve(n, pointer(size), pointer(A), border, pointer(B), pointer(C), pointer(D), pointer(r),
                           pointer(ry), len(pairs), pointer(pairs), pointer(normals), pointer(a), pointer(x),
                           pointer(y)) == 1
    found = np.concatenate([x[k, :m] for k, m in enumerate(size)] + [y])
    assert np.abs(found - expected).max() < 1e-10 * np.abs(expected).max()


def test_turning_frame_keeps_a_circle(lib):
    x, v = np.array([30e-3, 0, 1e-3]), np.array([0, 0.6, 0])
    x1, v1 = np.zeros(3), np.zeros(3)
    for _ in range(1000):
        lib.drift(pointer(x), pointer(v), ctypes.c_double(1e-3), pointer(x1), pointer(v1))
        x, v = x1.copy(), v1.copy()
    assert np.hypot(*x[:2]) == pytest.approx(30e-3, rel=1e-13)
    assert np.arctan2(x[1], x[0]) % (2 * np.pi) == pytest.approx(20.0 % (2 * np.pi), rel=1e-10)
    assert v @ x == pytest.approx(0, abs=1e-15) and np.linalg.norm(v) == pytest.approx(0.6, rel=1e-13)
