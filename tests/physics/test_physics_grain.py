# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of grain_contact.h for a sphere that collides with a wall."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

K, M, R, V = 2.0e4, 2.26e-3, 6.0e-3, 0.7
INERTIA = 0.4 * M * R**2
TIME = np.pi * np.sqrt(M / K)  # duration of an undamped collision
STEP = TIME / 500


def collide(physics, restitution=1.0, friction=0.0, along=0.0, spin=0.0, dt=STEP):
    return physics.formula("grain_collision")(
        stiffness=K,
        restitution=restitution,
        friction=friction,
        m=M,
        R=R,
        normal=V,
        along=along,
        spin=spin,
        dt=dt,
    )


def energy(normal, along, spin):
    return 0.5 * M * (normal**2 + along**2) + 0.5 * INERTIA * spin**2


def test_a_bounce_without_damping(physics):
    after = collide(physics)
    assert after.normal == pytest.approx(V, rel=(np.pi * STEP / TIME) ** 2)  # velocity Verlet
    assert after.time == pytest.approx(TIME, abs=2 * STEP)
    assert after.lost == pytest.approx(0, abs=(np.pi * STEP / TIME) ** 2 * energy(V, 0, 0))


@pytest.mark.parametrize("restitution", [0.2, 0.5, 0.9])
def test_damping_against_the_equation_of_motion(physics, restitution):
    """The rebound agrees with an independent integration of m x'' = max(0, k x - c x'). c follows
    from `restitution`, which is the decay of a free vibration over half a period."""
    decay = -np.log(restitution) / TIME  # to first order; the next line is exact
    decay = -np.log(restitution) * np.sqrt(K / M / (np.pi**2 + np.log(restitution) ** 2))

    def motion(_, y):
        return y[1], -max(0.0, K * y[0] + 2 * M * decay * y[1]) / M

    def apart(_, y):
        return y[0]

    apart.terminal, apart.direction = True, -1
    exact = solve_ivp(motion, (0, 1), (1e-14, V), events=apart, rtol=1e-10, atol=1e-16)
    after = collide(physics, restitution)
    # the end is detected one step late, when the force is small; because of the damper, the error
    # is of first order in the step
    assert after.normal == pytest.approx(-exact.y[1][-1], rel=4 * STEP / TIME)
    # without adhesion, the sphere leaves slightly faster than in a free vibration
    assert restitution <= after.normal / V < restitution + 0.2 * (1 - restitution)


@pytest.mark.parametrize("restitution", [0.3, 1.0])
def test_a_sliding_collision_in_closed_form(physics, restitution):
    """Friction stays at its limit, so its impulse is mu times the impulse of the normal force."""
    mu, along = 0.2, 5 * V
    after = collide(physics, restitution, mu, along=along)
    impulse = M * (V + after.normal)
    # friction is below its limit until the spring is stretched, for a fraction mu F/(kt v) of the
    # collision; the missing part of the impulse is the square of this fraction
    assert after.along == pytest.approx(along - mu * impulse / M, rel=1e-3)
    # the lever arm of friction is the radius minus the overlap
    overlap = V * np.sqrt(M / K)
    expected = -mu * impulse * R / INERTIA
    assert after.spin == pytest.approx(expected, rel=overlap / R + 1e-2)


def test_a_rolling_collision_reverses_the_surface(physics):
    """If the ratio of tangential to normal stiffness is 2/7, the tangential and normal vibrations
    of a solid sphere have the same period."""
    along = 0.01 * V
    after = collide(physics, friction=100.0, along=along)
    surface = after.along + after.spin * R
    # the overlap reduces the lever arm
    assert surface == pytest.approx(-along, rel=3 * V * np.sqrt(M / K) / R)


@pytest.mark.parametrize("friction", [0.0, 0.3, 100.0])
@pytest.mark.parametrize("restitution", [0.3, 1.0])
def test_the_loss_is_what_motion_has_lost(physics, restitution, friction):
    before = energy(V, 2 * V, 30.0)
    after = collide(physics, restitution, friction, along=2 * V, spin=30.0)
    left = energy(after.normal, after.along, after.spin)
    # the lever arm changes by the overlap during a collision, whereas the loss is computed with the
    # lever arm at the end of each step
    change = V * np.sqrt(M / K) / R
    assert after.lost == pytest.approx(before - left, abs=change * STEP / TIME * before)
    coarse = collide(physics, restitution, friction, along=2 * V, spin=30.0, dt=10 * STEP)
    left = energy(coarse.normal, coarse.along, coarse.spin)
    assert coarse.lost == pytest.approx(before - left, abs=change * 10 * STEP / TIME * before)
