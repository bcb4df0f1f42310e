# SPDX-License-Identifier: GPL-2.0-or-later
"""Implicit steps of one or two bodies, compared with theory and with scipy."""

import numpy as np
import pytest
import scipy.integrate

INERTIA, SPIN, MOMENT = np.array([3e-4, 1.6e-4]), 800.0, np.array([0.4, -0.2, 0.1])


def lone_ring(physics, order, steps, time):
    return physics.call(
        "lone_ring", order=order, n=steps, h=time / steps, spin=SPIN, inertia=INERTIA, moment=MOMENT
    )


def gyroscope(time):
    """Return the axis and its rate of change from L' = M + reaction along e, which scipy integrates
    with the complete kinematics."""
    axial, transverse = INERTIA

    def slope(_, y):
        e, L = y[:3], y[3:]
        along = e * (L @ e)
        turn = np.cross((L - along) / transverse, e)
        # the spin is imposed, so the momentum along e remains I_a spin, and the drive supplies the
        # other part of the moment
        return np.concatenate([turn, MOMENT - e * (MOMENT @ e)])

    start = np.array([0, 0, 1, 0, 0, axial * SPIN])
    y = scipy.integrate.solve_ivp(slope, (0, time), start, rtol=1e-12, atol=1e-14).y[:, -1]
    across = (y[3:] - y[:3] * (y[3:] @ y[:3])) / transverse
    return y[:3], across[:2]


@pytest.mark.parametrize("order, method", [(1, 1), (2, 2), (1, 0)], ids=["1", "2", "dampers only"])
def test_gyroscope(physics, order, method):
    """A spinning ring under a moment precesses and nutates as in theory, with errors at the order
    of the method."""
    time = 5e-3
    axis, rate = gyroscope(time)
    errors = []
    for steps in (400, 800, 1600):
        out = lone_ring(physics, method, steps, time)
        errors.append(
            max(
                np.abs(out.e - axis).max() / np.abs(axis[:2]).max(),
                np.abs(out.rate - rate).max() / np.abs(rate).max(),
            )
        )
    for coarse, fine in zip(errors, errors[1:]):
        assert 0.85 * 2**order < coarse / fine < 1.15 * 2**order
    assert errors[-1] < (0.1, 1e-3)[order - 1]


@pytest.mark.parametrize("method", [2, 0], ids=["order 2", "dampers only"])
def test_free_fall_is_exact(physics, method):
    """Under a constant force, order 2 reproduces the parabola to rounding accuracy. The same
    applies to `solve damping`, which treats springs in the same way as velocity Verlet."""
    out, time = lone_ring(physics, method, 7, 2e-3), 2e-3
    acceleration = np.array([1.0, 2.0, 3.0]) / 0.5
    np.testing.assert_allclose(out.v, acceleration * time, rtol=1e-12)
    np.testing.assert_allclose(out.x, 0.5 * acceleration * time**2, rtol=1e-12)


def estimated(physics, n, h, place, velocity, relative=0.0, **loads):
    """Return the largest error estimated in a step, and position and velocity at the end."""
    x, v = np.array([place, 0.0]), np.array([velocity, 0.0])
    named = dict(relative=relative, n=n, h=h, place=x, velocity=v, stiffness=0.0, force=0.0)
    error = physics.call("estimated_errors", **named | loads)
    return error, x[1], v[1]


# relative tolerance, and the smallest error that is assumed, relative to that of a first-order
# method
SHARES = pytest.mark.parametrize("relative, share", [(0.0, 0.7), (2e-4, 0.3)])


RATE, SWING = 2000.0, 1e-6  # vibration of a ring of 0.5 kg on a spring: rate (rad/s), amplitude (m)
SPRING = 0.5 * RATE**2
GAMMA = 1 - np.sqrt(0.5)


@pytest.mark.parametrize("turn", [0.1, 0.05, 0.02])
def test_estimate_of_a_step_of_a_vibration(physics, turn):
    """The velocity is the same at both ends of each stage, so the error bound is 0. The relevant
    error is the distance of the end point from the exact one in the plane of position and velocity:
    R(z) of the method lacks c z^3, and the first stage has the second difference gamma z^2 v
    instead of z^2 v/2. Four times the error for a velocity that is a given function of time is 0.59
    of this distance."""
    h = turn / RATE
    start = -0.5 * (1 + GAMMA) * turn
    error, x, v = estimated(
        physics, 1, h, SWING * np.sin(start), SWING * RATE * np.cos(start), stiffness=SPRING
    )
    end = start + turn
    off = np.hypot(x - SWING * np.sin(end), v / RATE - SWING * np.cos(end))
    c = GAMMA**2 * (3 - 2 * GAMMA) - 1 / 6
    given = GAMMA + (1 - GAMMA) * GAMMA**2 - 1 / 3  # for v = t^2
    assert off == pytest.approx(c * turn**3 * SWING, rel=turn, abs=0)
    assert error == pytest.approx(4 * given * GAMMA / c * off, rel=2 * turn, abs=0)


@SHARES
def test_estimate_of_a_constant_force_is_a_share_of_the_bound(physics, relative, share):
    """The method has no error under a constant force, so the estimate is a share of the error of a
    first-order method."""
    h, acceleration = 1e-4, 3.0 / 0.5
    error, x, _ = estimated(physics, 1, h, 0.0, 0.0, relative, force=3.0)
    bound = GAMMA * (1 - GAMMA) * h**2 * acceleration
    assert x == pytest.approx(0.5 * acceleration * h**2, rel=1e-12, abs=0)
    assert error == pytest.approx(share * bound, rel=1e-12, abs=0)


@SHARES
@pytest.mark.parametrize("periods", [1, 10])
def test_vibration_lags_by_less_than_the_stated_bound(physics, periods, relative, share):
    """After s radians of a vibration that determines the step, the error is below 0.195 s/share
    times the largest error estimated in a step (docs/fix_bearing_implicit). In theory it is
    c/(share gamma (1 - gamma)) s times this estimate."""
    turn = 0.02
    n = round(2 * np.pi * periods / turn)
    error, x, v = estimated(physics, n, turn / RATE, SWING, 0.0, relative, stiffness=SPRING)
    s = n * turn
    off = np.hypot(x - SWING * np.cos(s), v / RATE + SWING * np.sin(s))
    assert 0.18 * s * error < share * off < 0.1956 * s * error


@pytest.mark.parametrize("swing, lost", [(10, 0.04), (3, 0.13), (1, 0.27)])
def test_share_of_a_small_vibration_that_is_filtered_out(physics, swing, lost):
    """A vibration of `swing` times the tolerance loses the stated share per period, if its steps
    have the length at which its error reaches the tolerance (docs/fix_bearing_implicit)."""
    turn = 1 / np.sqrt(0.3 * GAMMA * (1 - GAMMA) * swing)
    _, x, v = estimated(physics, 1, turn / RATE, SWING, 0.0, 2e-4, stiffness=SPRING)
    left = np.hypot(x, v / RATE) / SWING
    assert 1 - left ** (2 * np.pi / turn) == pytest.approx(lost, abs=0.005)


def resting(physics, steps=1, **words):
    """Return the number of corrections, the estimated error (m) and the overlap (m) for each step
    of a ball on a raceway."""
    found = np.zeros((3, steps))
    words |= zip(("corrections", "error", "overlap"), found)
    physics.call("resting", n=steps, **words)
    return found


def test_a_ball_that_rests_stays(physics):
    """A ball of 8 g that rolls around at 2 rad/s is pressed on its raceway by 1 mN, up to an
    overlap of 1 nm. It starts a nanometre away from the raceway. The tolerance is 5 nm, and a step
    lasts a few periods of the ball's vibration. One correction per stage brings the ball to its
    equilibrium position, and it does not jump off the raceway and back."""
    scene = dict(speed=2 * 30.3e-3, gap=1e-9, heavy=0.0, h=4e-3, steps=10)
    corrections, _, overlap = resting(physics, newton=5e-9, **scene)
    assert corrections.tolist() == [2] * 10
    exact = resting(physics, newton=1e-13, **scene)[2][-1]
    assert 0 < exact < 2e-9
    assert overlap[-1] == pytest.approx(exact, rel=1e-6)


def test_a_light_ball_counts_a_tenth(physics):
    """The error of an unloaded ball has a weight of only a tenth if another ball has an overlap of
    0.1 um."""
    scene = dict(speed=30.0, gap=1e-6, newton=1e-9, h=1e-7)
    alone, beside = (resting(physics, heavy=heavy, **scene)[1][0] for heavy in (0.0, 1e-7))
    assert alone > 1e-11
    assert beside == pytest.approx(0.1 * alone, rel=1e-12)


@pytest.mark.parametrize(
    "gap, speed, h", [(1e-8, 3e-4, 2e-4), (6e-8, 1e-3, 1e-3), (6.5e-8, 1e-2, 3e-5)]
)
def test_a_contact_that_opens_and_closes_in_turn_is_met_half_way(physics, gap, speed, h):
    """A ball reaches a cage ball within a step. Full corrections would alternate between the open
    and the closed contact."""
    assert physics.call("meeting", gap=gap, speed=speed, h=h, newton=1e-9) <= 16
