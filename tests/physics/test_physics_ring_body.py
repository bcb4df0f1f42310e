# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of ring_body.h: a ring moves as a symmetric top."""

import numpy as np
import pytest

AXIAL, TRANSVERSE = 3.1e-4, 1.7e-4
AXIS = np.array([0.2, -0.3, 1.0]) / np.linalg.norm([0.2, -0.3, 1.0])
SPIN = np.array([30.0, -50.0, 400.0])


def momentum(physics, w=SPIN, e=AXIS):
    return physics.call("ring_momentum", axial=AXIAL, transverse=TRANSVERSE, w=w, e=e)


def drift(physics, L, e, h, steps=1):
    for _ in range(steps):
        e = physics.call("ring_drift", axial=AXIAL, transverse=TRANSVERSE, L=L, e=e, h=h)
    return e


def precessed(physics, L, e, time):
    """Return the closed-form solution for a free symmetric top, whose axis precesses about L at the
    rate |L|/I_t (Goldstein 5.6)."""
    return physics.rotate(e, L * time / TRANSVERSE)


def test_momentum_is_the_inertia_tensor_times_the_velocity(physics):
    tensor = TRANSVERSE * np.eye(3) + (AXIAL - TRANSVERSE) * np.outer(AXIS, AXIS)
    size = AXIAL * np.linalg.norm(SPIN)
    assert momentum(physics) == pytest.approx(tensor @ SPIN, abs=1e-15 * size)
    velocity = physics.call(
        "ring_velocity", axial=AXIAL, transverse=TRANSVERSE, L=tensor @ SPIN, e=AXIS
    )
    assert velocity == pytest.approx(SPIN, abs=2e-15 * np.linalg.norm(SPIN))


def test_a_ring_spinning_about_its_axis_stays(physics):
    L = momentum(physics, 400.0 * AXIS)
    assert drift(physics, L, AXIS, 1e-3, 10) == pytest.approx(AXIS, abs=1e-14)


def test_free_precession_is_of_second_order(physics):
    L, time = momentum(physics), 5e-3
    expected = precessed(physics, L, AXIS, time)
    assert np.linalg.norm(expected - AXIS) > 0.1
    errors = [
        np.linalg.norm(drift(physics, L, AXIS, time / n, n) - expected) for n in (200, 400, 800)
    ]
    # the ratio is 4 up to higher-order terms, (w h)^2 = 1e-4
    assert errors[0] / errors[1] == pytest.approx(4, rel=0.02)
    assert errors[1] / errors[2] == pytest.approx(4, rel=0.01)
    assert errors[2] > 0


def test_one_step_misses_by_the_third_power(physics):
    L = momentum(physics)
    errors = [
        np.linalg.norm(drift(physics, L, AXIS, h) - precessed(physics, L, AXIS, h))
        for h in (2e-5, 1e-5)
    ]
    assert errors[0] / errors[1] == pytest.approx(8, rel=0.05)  # higher-order terms: w h = 1e-2


def test_the_axis_stays_a_unit_vector_and_keeps_its_angle_to_the_momentum(physics):
    L, steps = momentum(physics), 5000
    e = drift(physics, L, AXIS, 1e-5, steps)
    assert np.linalg.norm(e) == pytest.approx(1, abs=steps * 4e-16)  # one rounding error per step
    # nutation: L.e is constant in the closed-form solution; here it oscillates with an error of
    # second order, but does not drift
    assert L @ e / np.linalg.norm(L) == pytest.approx(L @ AXIS / np.linalg.norm(L), abs=2e-5)


def test_drift_can_be_undone_to_third_order(physics):
    L, h = momentum(physics), 1e-5
    back = drift(physics, L, drift(physics, L, AXIS, h), -h)
    forth = drift(physics, L, AXIS, h)
    turned = np.linalg.norm(forth - AXIS)
    assert np.linalg.norm(back - AXIS) < 10 * turned**3 + 1e-15


def test_a_sphere_turns_about_its_momentum(physics):
    L = np.array([1.0, 2.0, 3.0]) * 1e-2
    found = physics.call("ring_drift", axial=2e-4, transverse=2e-4, L=L, e=AXIS, h=1e-3)
    # exact if I_a = I_t
    assert found == pytest.approx(physics.rotate(AXIS, L * 1e-3 / 2e-4), abs=2e-15)
