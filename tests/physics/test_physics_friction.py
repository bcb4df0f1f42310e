# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of friction.h: the Stribeck transition and the limited tangential spring."""

import numpy as np
import pytest
from raceway.core import laws

CURVE = dict(mu_boundary=0.12, mu_full=0.02, lambda_1=0.8, lambda_2=2.9)


def mu(lam):
    return laws.stribeck(**CURVE, ratio=lam)


def test_stribeck_ends():
    assert [mu(lam) for lam in (0.0, 0.5, 0.8)] == [0.12] * 3
    assert [mu(lam) for lam in (2.9, 4.0, 1e9)] == [0.02] * 3
    assert mu((0.8 + 2.9) / 2) == pytest.approx((0.12 + 0.02) / 2, rel=1e-14)  # half-way


def test_stribeck_is_the_cubic():
    # s^2 (3 - 2 s) is the only cubic with these end values and with zero slope at both ends
    for s in np.linspace(0.0, 1.0, 201):
        expected = 0.12 - 0.10 * (3 * s**2 - 2 * s**3)
        assert mu(0.8 + 2.1 * s) == pytest.approx(expected, rel=1e-14)


def spring(physics, xi, velocity, cap, k=1e7, c=30.0):
    xi = np.array(xi, dtype=float)
    vt, vw = velocity
    force = physics.call("friction_spring", k=k, c=c, cap=cap, vt=vt, vw=vw, xi=xi)
    return np.array([force.ft, force.fw]), xi


def test_stick_is_a_spring_and_a_dashpot(physics):
    force, xi = spring(physics, (3e-7, -2e-7), (0.01, 0.02), cap=100.0)
    assert force == pytest.approx([1e7 * 3e-7 + 30 * 0.01, -1e7 * 2e-7 + 30 * 0.02], rel=1e-14)
    assert xi.tolist() == [3e-7, -2e-7]


def test_slip_keeps_the_direction_and_the_size_of_the_cap(physics):
    trial = np.array([1e7 * 3e-7 + 30 * 0.01, -1e7 * 2e-7 + 30 * 0.02])
    force, xi = spring(physics, (3e-7, -2e-7), (0.01, 0.02), cap=1.5)
    assert force == pytest.approx(1.5 * trial / np.linalg.norm(trial), rel=1e-14)
    # the spring is reset such that spring and dashpot together exert exactly this force
    again, same = spring(physics, xi, (0.01, 0.02), cap=1.5 * (1 + 1e-12))
    assert again == pytest.approx(force, rel=1e-12) and same == pytest.approx(xi, rel=1e-12)


def test_without_load_no_friction(physics):
    force, xi = spring(physics, (3e-7, -2e-7), (0.01, 0.02), cap=0.0)
    assert force.tolist() == [0, 0]
    assert xi == pytest.approx([-30 * 0.01 / 1e7, -30 * 0.02 / 1e7], rel=1e-14)


def test_steady_sliding_reaches_coulomb(physics):
    # the order is that of contact.h: xi += dt v, then the force
    xi, velocity, dt = np.zeros(2), np.array([0.3, -0.4]), 1e-7
    for _ in range(200):
        xi += dt * velocity
        force, xi = spring(physics, xi, velocity, cap=5.0)
    assert force == pytest.approx(5.0 * velocity / 0.5, rel=1e-12)


def test_a_sticking_ball_swings_on_the_spring(physics):
    # x'' = -k x/m, starting from rest on one side: after half a period, the mass is on the other
    # side, at the same distance because there is no damping
    k, m, steps = 1e7, 1e-3, 2000
    period = 2 * np.pi * np.sqrt(m / k)
    dt, xi, v = period / 2 / steps, np.array([1e-6, 0.0]), 0.0

    def force():
        return physics.call("friction_spring", k=k, c=0.0, cap=1e3, vt=v, vw=0.0, xi=xi).ft

    for _ in range(steps):
        v -= dt / 2 * force() / m
        xi[0] += dt * v
        v -= dt / 2 * force() / m
    assert xi[0] == pytest.approx(-1e-6, rel=(np.pi / steps) ** 2)  # Verlet is of second order
