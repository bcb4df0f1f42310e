# SPDX-License-Identifier: GPL-2.0-or-later
"""The equilibrium of the bearing is compared with values in docs/theory, with closed-form
solutions, and with independently written equations of equilibrium."""

import numpy as np
import pytest
from raceway import clearance, hertz, inputs
from raceway.theory.bearing import INNER, OUTER
from raceway.theory.static import STRAIGHT, equilibrium
from scipy.optimize import brentq


def test_numbers_of_the_6208(bearing):  # docs/theory, Numbers to reproduce
    state = equilibrium(bearing, 5000.0)
    assert state.inner.load[[0, 1, 2, 8]] == pytest.approx(
        [2436.2, 1633.4, 176.3, 1633.4], abs=0.05
    )
    assert state.inner.load[0] / 5000 == pytest.approx(0.48725, abs=5e-6)
    assert state.shift == pytest.approx([34.87e-6, 0, 0], abs=0.005e-6)
    assert [state.inner.a[0], state.inner.b[0]] == pytest.approx([2.059e-3, 0.2197e-3], rel=3e-4)
    assert [state.outer.a[0], state.outer.b[0]] == pytest.approx([1.993e-3, 0.2749e-3], rel=3e-4)
    assert [state.inner.pressure[0], state.outer.pressure[0]] == pytest.approx(
        [2571e6, 2123e6], abs=0.6e6
    )
    springs = sum(1.5 * side.load[0] / side.overlap[0] for side in (state.inner, state.outer))
    assert springs == pytest.approx(4.19e8, rel=2e-3)


@pytest.mark.parametrize(
    "relative, low, high",
    [
        (-0.0045, 1.699, 1.699),
        (-0.0035, 1.317, 1.317),
        (0, 0.5, 0.5),
        (0.0035, 0.318, 0.320),
        (0.0045, 0.291, 0.293),
    ],
)
def test_load_parameter_of_any_ball_phase(bearing, relative, low, high):  # docs/errata
    pd = relative * bearing.ball_diameter
    found = [
        clearance.load_parameter(
            pd, equilibrium(bearing, 5000.0, clearance=pd, phase=phase).shift[0]
        )
        for phase in np.linspace(0, np.pi / 9, 4)
    ]
    assert (min(found), max(found)) == pytest.approx((low, high), abs=6e-4)


@pytest.mark.parametrize("axial", [50.0, -3000.0])
@pytest.mark.parametrize("pd", [0.0, 30e-6])
def test_thrust(bearing, axial, pd):
    """All balls carry the same load, F_a = Z Q sin(alpha), and the distance between the groove
    centres is C cos(alpha_0)/cos(alpha) (Harris 7.33)."""
    free, c = clearance.free_contact_angle(bearing, pd), clearance.groove_distance(bearing)

    def load(angle):
        k = [
            hertz.stiffness(
                hertz.exact(*bearing.effective_radii(side, angle, pd)), bearing.effective_modulus
            )
            for side in (INNER, OUTER)
        ]
        return (k[0] ** (-2 / 3) + k[1] ** (-2 / 3)) ** -1.5 * (
            c * (np.cos(free) / np.cos(angle) - 1)
        ) ** 1.5

    angle = brentq(lambda a: 9 * load(a) * np.sin(a) - abs(axial), free + 1e-9, 1.2, xtol=1e-14)
    state = equilibrium(bearing, 0.0, axial, clearance=pd)
    # overlaps are differences of lengths a thousand times larger, so a rounding of 1e-13 becomes
    # 1e-9
    assert state.inner.load == pytest.approx(np.full(9, load(angle)), rel=1e-8)
    assert state.inner.angle == pytest.approx(np.full(9, np.sign(axial) * angle), rel=1e-8)
    assert state.shift[:2] == pytest.approx([0, 0], abs=1e-12)


def test_centrifugal_load_alone_on_the_outer_raceway(bearing):
    state = equilibrium(bearing, 1000.0, clearance=20e-6, orbital_speed=500.0, ball_density=7800.0)
    expected = 7800 * 4 / 3 * np.pi * 6.3e-3**3 * 30.3e-3 * 500.0**2
    idle = state.inner.load == 0
    assert idle.sum() >= 4
    assert state.outer.load[idle] == pytest.approx(np.full(idle.sum(), expected), rel=1e-9)
    assert np.all(state.outer.load[~idle] > state.inner.load[~idle])


def test_preload_without_load_is_centred(bearing):
    state = equilibrium(bearing, 0.0, clearance=-20e-6)
    assert state.shift == pytest.approx(np.zeros(3), abs=1e-12)
    assert np.ptp(state.inner.load) < 1e-6 * state.inner.load[0]


def test_circle_keeps_its_shape_under_a_finite_shift(bearing):
    """The component x_t of the ring's displacement perpendicular to a ball's radius reduces the
    overlap by x_t^2/(2 r), which relieves the ball at 80 degrees."""
    straight, circle = equilibrium(bearing, 5000.0), equilibrium(bearing, 5000.0, finite_shift=True)
    sideways = circle.shift[0] * np.sin(np.radians(80))
    squeeze = (circle.inner.overlap + circle.outer.overlap)[2]
    expected = circle.shift[0] * np.cos(np.radians(80)) - sideways**2 / (2 * bearing.pitch_radius)
    assert squeeze == pytest.approx(expected, rel=1e-5)
    assert circle.inner.load[2] / straight.inner.load[2] == pytest.approx(0.996, abs=5e-4)


def test_ring_on_one_ball_rolls_off(bearing):
    loaded = equilibrium(bearing, 1.0, clearance=150e-6, finite_shift=True).inner.load > 0
    assert loaded.sum() == 2


@pytest.mark.parametrize(
    "name, load, axial", [("7205B", 300.0, 50.0), ("7208B", 300.0, 500.0), ("6208", 1000.0, 300.0)]
)
def test_slow_balls(name, load, axial):
    """The slower a bearing turns, the closer its equilibrium is to that at standstill, whatever
    equilibrium the search starts from. Newton's method used to crawl along the grooves towards the
    places of unloaded balls with tiny centrifugal loads."""
    body = inputs.bearing(name)
    still = near = equilibrium(body, load, axial, held=STRAIGHT)
    for orbit in (10.0, 1.0, 0.03, 1e-3, 1e-5):  # rad/s
        turns = {"orbital_speed": orbit, "held": STRAIGHT}
        near = equilibrium(body, load, axial, near=near, **turns)
        afresh = equilibrium(body, load, axial, **turns)
        size = np.linalg.norm(still.shift)
        assert np.linalg.norm(near.shift - afresh.shift) < 1e-9 * size
        assert np.linalg.norm(near.shift - still.shift) < (1e-9 + 1e-4 * orbit**2) * size
