# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of damped_hertz.h: a Hertzian spring with critical damping and no adhesion."""

import numpy as np
import pytest

K, MASS = 3.3e8, 2.1e-4


def contact(physics, overlap, rate=0.0):
    return physics.call("cage_contact", K=K, overlap=overlap, rate=rate, m=MASS)


def test_spring(physics):
    assert contact(physics, 2e-6).force == pytest.approx(K * 2e-6**1.5, rel=1e-15)


def test_stiffness_is_the_slope_of_the_spring(physics):
    overlap, h = 2e-6, 1e-9
    slope = (contact(physics, overlap + h).force - contact(physics, overlap - h).force) / (2 * h)
    # the truncation error is (h/overlap)^2/24 for a power of 3/2, the rounding error eps overlap/h
    bound = (h / overlap) ** 2 / 24 + 1e-15 * overlap / h
    assert contact(physics, overlap).stiffness == pytest.approx(slope, rel=bound)


def test_growth_is_the_slope_of_the_force_of_a_closing_contact(physics):
    overlap, rate, h = 2e-6, 0.01, 1e-9
    up, down = (contact(physics, overlap + off, rate).force for off in (h, -h))
    # of the powers 3/2 and 1/4, the latter has the larger truncation error, 7/32 (h/overlap)^2
    bound = 7 / 32 * (h / overlap) ** 2 + 1e-15 * overlap / h
    assert contact(physics, overlap, rate).growth == pytest.approx((up - down) / (2 * h), rel=bound)
    # while the contact opens, the force is still that of the spring
    assert contact(physics, overlap, -rate).growth == contact(physics, overlap).stiffness


def test_damping_is_critical(physics):
    c = contact(physics, 2e-6)
    # m x'' + c x' + k x = 0 has a double root, i.e. its discriminant is zero
    assert c.damping**2 == pytest.approx(4 * c.stiffness * MASS, rel=1e-15)


def test_damper_is_linear_and_resists_closing(physics):
    still, closing = contact(physics, 2e-6), contact(physics, 2e-6, 0.01)
    assert closing.force - still.force == pytest.approx(still.damping * 0.01, rel=1e-13)
    assert closing.damping == still.damping


def test_no_adhesion(physics):
    c = contact(physics, 2e-6)
    edge = c.force / c.damping
    assert contact(physics, 2e-6, -0.99 * edge).force > 0
    assert contact(physics, 2e-6, -1.01 * edge).force == 0


def test_nothing_at_first_touch(physics):
    c = contact(physics, 0.0, 1.0)
    assert [c.stiffness, c.damping, c.growth, c.force] == [0, 0, 0, 0]
    assert np.isfinite(contact(physics, 1e-30, 1.0).force)
