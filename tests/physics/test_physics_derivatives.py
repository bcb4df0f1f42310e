# SPDX-License-Identifier: GPL-2.0-or-later
"""Derivatives of contacts in the implicit step, compared with finite differences."""

import numpy as np
import pytest


def ball(overlap=20e-6, angle=0.0, v=(0, 0, 0), w=(0, 0, 0)):
    """Return a ball at azimuth 0.7 rad that is pressed into the outer groove at a contact angle."""
    circle, s, phi = 36.6e-3 - 6.552e-3, 0.252e-3 + overlap, 0.7
    r, z = circle + s * np.cos(angle), s * np.sin(angle)
    u, t = np.array([np.cos(phi), np.sin(phi), 0]), np.array([-np.sin(phi), np.cos(phi), 0])
    v = v[0] * u + v[1] * t + v[2] * np.array([0, 0, 1])
    return np.concatenate([r * u + [0, 0, z], v, w]).astype(float)


def force(physics, state, spin, mu, frozen):
    return physics.call("contact_force", state=state, spin=spin, mu=mu, frozen=frozen)


def derivatives(physics, state, spin, mu):
    """Return the derivatives D and K as matrices, and the normal of the contact."""
    D, K, n = physics.call("contact_derivatives", state=state, spin=spin, mu=mu)
    return D.reshape(3, 3), K.reshape(3, 3), n


def differences(physics, state, spin, mu, first, step):
    """Return -df/ds for three entries of the state, from `first` on; C, mu and the friction's
    denominator keep their values in `state`."""
    frozen = np.array([-1.0, 0, 0])
    force(physics, state, spin, mu, frozen)
    columns = []
    for k in range(3):
        up, down = state.copy(), state.copy()
        up[first + k] += step
        down[first + k] -= step
        ends = (force(physics, one, spin, mu, frozen) for one in (down, up))
        columns.append(np.subtract(*ends) / (2 * step))
    return np.array(columns).T


ROLLING = dict(v=(2e-3, 0.6, 1e-3), w=(3.0, -2.0, -95.5))


@pytest.mark.parametrize("angle", [0.0, 0.4])
@pytest.mark.parametrize("mu", [0.0, 0.07])
def test_velocity_derivative_is_exact(physics, angle, mu):
    state = ball(angle=angle, **ROLLING)
    D, _, n = derivatives(physics, state, 0.0, mu)
    numeric = differences(physics, state, 0.0, mu, 3, 1e-7)
    assert np.abs(D - numeric).max() < 1e-6 * np.abs(D).max()
    # the spin moves the contact point: w x R n
    R = 6.3e-3
    arm = R * np.array([[0, -n[2], n[1]], [n[2], 0, -n[0]], [-n[1], n[0], 0]])
    spin = differences(physics, state, 0.0, mu, 6, 1e-5)
    assert np.abs(-D @ arm - spin).max() < 1e-6 * np.abs(D @ arm).max() + 1e-9 * np.abs(D).max()


@pytest.mark.parametrize("angle, tolerance", [(0.0, 1e-6), (0.4, 1e-2)])
def test_position_derivative(physics, angle, tolerance):
    """The derivative is exact for a radial contact. With a contact angle, it does not include the
    derivative of the constants, which are frozen."""
    state = ball(angle=angle)
    _, K, _ = derivatives(physics, state, 0.0, 0.0)
    numeric = differences(physics, state, 0.0, 0.0, 0, 1e-9)
    assert np.abs(K - numeric).max() < tolerance * np.abs(K).max()


def test_turn_of_the_normal(physics):
    """The two terms due only to the rotation of the normal are N/s across the groove and N/r along
    it."""
    state = ball()
    frozen = np.array([-1.0, 0, 0])
    N = np.linalg.norm(force(physics, state, 0.0, 0.0, frozen))
    _, K, n = derivatives(physics, state, 0.0, 0.0)
    along = np.array([-n[1], n[0], 0])
    assert K[2, 2] == pytest.approx(N / 0.272e-3, rel=1e-6)
    assert along @ K @ along == pytest.approx(N / np.hypot(*state[:2]), rel=1e-6)


def test_friction_slope_is_a_dashpot(physics):
    """A sliding contact resists motion in every direction: except for the cross term mu C, the
    slope has no negative eigenvalue."""
    state = ball(v=(0, 0.65, 2e-3), w=(0, 0, -95.5))
    D = derivatives(physics, state, 0.0, 0.07)[0]
    assert np.linalg.eigvalsh(D + D.T).min() > -1e-3 * np.abs(D).max()


def flawed(physics, overlap, off_middle, width, of_ball):
    """Return the matrix of a ball on a flaw, its differences and its transposed part."""
    found = physics.call(
        "flawed_system",
        notch=np.array([1e-3, width, 1e-4, 5e-5]),
        of_ball=of_ball,
        off_middle=off_middle,
        overlap=overlap,
        h=1e-5,
    )
    return [part.reshape(6, -1) for part in found]


@pytest.mark.parametrize("width", [0, 3e-4], ids=["full", "pit"])
@pytest.mark.parametrize("off_middle", [-4e-4, 1e-5, 2e-4, 2e-3])
def test_derivatives_over_a_flaw(physics, off_middle, width):
    """The matrix of the implicit step includes the slope and the curvature of a flaw, on a flank,
    at an edge and on a wave. It also includes the motion of the ring with the flaw."""
    matrix, differences, transposed = flawed(physics, 2.5e-5, off_middle, width, 0)
    mass, frame, _ = flawed(physics, -2e-4, off_middle, width, 0)  # without contact
    force, want = (matrix - mass)[:3], (differences - frame)[:3]
    stiff = want[0, 0]
    # the matrix rotates the force as the ball moves around, whereas the ball's frame already does
    # so: h^2 N/r
    assert np.abs(force[1, 1] - want[1, 1]) < 7e-4 * stiff
    force[1, 1] = want[1, 1]
    assert np.abs(force - want)[:, [0, 1, 2, 6, 7]].max() < 5e-5 * stiff
    assert force[:, 8] == pytest.approx(want[:, 8], abs=1e-8 * stiff)  # spin of the ring
    assert transposed[:3, :2] == pytest.approx(force[:, 6:8], abs=1e-12 * stiff)
    if off_middle < 1e-3:
        assert np.abs(want[0, 1]) > 1e-3 * stiff  # the slope is not negligible


@pytest.mark.parametrize("width", [5e-3, 3e-4], ids=["wide", "narrow"])
@pytest.mark.parametrize("off_middle", [-4e-4, 1e-5, 2e-4, 2e-3])
def test_derivatives_over_a_flaw_of_the_ball(physics, off_middle, width):
    """For a flaw of a ball, the ball's spin about the axis replaces its motion along the
    raceway.
    """
    matrix, differences, transposed = flawed(physics, 2.5e-5, off_middle, width, 1)
    mass, frame, _ = flawed(physics, -2e-4, off_middle, width, 1)  # without contact
    force, want = matrix - mass, differences - frame
    stiff, radius = want[0, 0], 6.3e-3
    for row, unit_row in ((0, 1.0), (1, 1.0), (5, radius)):
        for column, unit in ((0, 1.0), (5, radius)):
            off = force[row, column] - want[row, column]
            assert abs(off) < 5e-5 * stiff * unit_row * unit, (row, column)
    assert np.abs(force - want)[0, 6:8].max() < 5e-5 * stiff  # x, y of the ring
    assert np.abs(force[:, 8]).max() < 1e-8 * stiff  # spin of the ring
    assert transposed[0, :2] == pytest.approx(force[0, 6:8], abs=1e-12 * stiff)
    if off_middle < 1e-3:
        assert np.abs(want[0, 5]) > 1e-3 * stiff * radius  # the slope is not negligible
