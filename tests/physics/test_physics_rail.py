# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of rail.h: the seats of cage balls, and the stiffness of a ball on a torus."""

import numpy as np
import pytest
from physics_c import PITCH
from raceway import hertz as package
from scipy.optimize import brentq

BALL, TUBE, MODULUS = 4.19e-3, 1.0e-3, 7.9e9


def seat(physics, gap=0.0, sign=1.0, tube=TUBE):
    return physics.call("rail_seat", pitch=PITCH, ball=BALL, tube=tube, gap=gap, sign=sign)


def clearance(rail, radius, height):
    """Return the distance (m) between the surfaces of the ball and the tube when the ball's centre
    is at (radius, height)."""
    return np.hypot(radius - rail.circle, height - rail.offset) - BALL - rail.tube


@pytest.mark.parametrize("margin", [0.0, 1e-9])
def test_a_ball_that_touches_is_never_left_out(physics, margin):
    """A ball is detected as touching for overlaps between a few ulps and a few per cent of the
    distance, anywhere around the tube."""
    rail = seat(physics)
    reach = BALL + TUBE + margin
    for angle in np.linspace(0.1, 6.2, 50):
        for share in (1e-16, 1e-14, 1e-9, 1e-6, 0.02):
            for sign, touches in ((-1, True), (1, share < 1e-12)):
                distance = reach * (1 + sign * share)
                r = rail.circle + distance * np.cos(angle)
                z = rail.offset + distance * np.sin(angle)
                near = physics.call("rail_may_touch", rail=rail, r=r, z=z, ball=BALL, margin=margin)
                assert near == touches


@pytest.mark.parametrize("gap", [0.0, 20e-6, -5e-6])
@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_a_centred_ball_is_a_gap_away(physics, gap, sign):
    rail = seat(physics, gap, sign)
    assert clearance(rail, PITCH, 0.0) == pytest.approx(gap, abs=2e-17)  # ulps of 0.03 m
    # the rails are outside the pitch circle, at 45 degrees to it, on the side given by the sign
    assert rail.circle - PITCH == pytest.approx(sign * rail.offset, rel=1e-14)
    assert rail.circle > PITCH and np.sign(rail.offset) == sign and rail.tube == TUBE


def test_the_pair_of_rails_is_a_stable_seat(physics):
    # energy of the springs in both rails for an outward or a sideways displacement; an inward
    # displacement requires no energy
    rails = [seat(physics, 0.0, sign) for sign in (1.0, -1.0)]

    def squeeze(dr, dz):
        return np.array([max(0.0, -clearance(rail, PITCH + dr, dz)) for rail in rails])

    step = 1e-6
    outwards = squeeze(step, 0.0)
    # since the rails are at 45 degrees, a displacement p closes the gap of each rail by p/sqrt(2),
    # minus p^2 divided by twice the distance
    assert outwards == pytest.approx([step / np.sqrt(2)] * 2, abs=step**2 / (BALL + TUBE))
    for sign in (1, -1):
        up = squeeze(0.0, sign * step)
        assert up[::sign] == pytest.approx([step / np.sqrt(2), 0.0], abs=step**2 / (BALL + TUBE))
    # a cage ball that moves inwards leaves the rails, and is pushed back by the bearing balls
    assert squeeze(-step, 0.0).tolist() == [0, 0]


def curvature_along(rail, angle):
    """Return the curvature of the tube's surface in the direction around the ring axis, at the
    point that is seen at `angle` (rad) from the ball's seat.

    The curvature follows from differences of the gap between the torus and its tangent plane at the
    point nearest to the ball, in the direction of the parallel.
    """
    direction = np.array([np.cos(angle), np.sin(angle)])  # from the ball to the rail, in (r, z)
    foot = np.array([rail.circle, rail.offset]) - rail.tube * direction
    point, normal = np.array([foot[0], 0.0, foot[1]]), np.array([direction[0], 0.0, direction[1]])

    def height(
        y,
    ):  # position of the surface along the normal, for y along the circle: |q - circle| = tube
        def outside(t):
            q = point + y * np.array([0, 1, 0]) + t * normal
            return np.hypot(np.hypot(q[0], q[1]) - rail.circle, q[2] - rail.offset) - rail.tube

        return brentq(outside, -0.2 * rail.tube, 0.2 * rail.tube, xtol=1e-18, rtol=1e-14)

    y = 2e-5
    # height = c y^2/2 with a relative error of y^2/(4 r tube), which is 7e-6 for the thinnest tube;
    # the rounding error, 1e-17/y^2, is smaller
    return 2 * height(y) / y**2


def spring(physics, rail, pitch=PITCH):
    return physics.call("rail_spring", rail=rail, ball=BALL, pitch=pitch, Eprime=MODULUS)


def hertz_of(along, across=1 / (1 / BALL + 1 / TUBE)):
    """Return the stiffness of a contact with these effective radii."""
    return package.stiffness(package.exact(along, across), MODULUS)


@pytest.mark.parametrize("tube", [0.5e-3, 1.0e-3, 3.0e-3])
def test_stiffness_is_hertz_of_the_true_curvatures(physics, tube):
    rail = seat(physics, tube=tube)
    # a positive height along the normal means that the surface curves away from the ball; a
    # negative height means that it curves towards the ball
    along = 1 / BALL + curvature_along(rail, np.pi / 4)
    across = 1 / BALL + 1 / tube
    assert 1 / BALL - along == pytest.approx(
        np.cos(np.pi / 4) / (PITCH + BALL * np.cos(np.pi / 4)), rel=2e-5
    )
    # the error of 7e-6 is relative to this curvature, which is a tenth of `along`
    assert spring(physics, rail) == pytest.approx(hertz_of(1 / along, 1 / across), rel=1e-5)


def test_a_rail_straight_overhead_and_one_at_the_side(physics):
    for rail, curvature in (
        # concave, with the full curvature of the parallel
        (dict(circle=PITCH + BALL + TUBE, tube=TUBE, offset=0.0), 1 / BALL - 1 / (PITCH + BALL)),
        # above the circle, the parallel has no curvature in this plane
        (dict(circle=PITCH, tube=TUBE, offset=BALL + TUBE), 1 / BALL),
    ):
        assert spring(physics, rail) == pytest.approx(hertz_of(1 / curvature), rel=1e-12)


def test_a_thin_ball_far_out_meets_a_straight_cylinder(physics):
    # in the limit of an infinite ring radius: cylinder and sphere, to order BALL/pitch
    pitch = 1e6 * BALL
    rail = physics.call("rail_seat", pitch=pitch, ball=BALL, tube=TUBE, gap=0.0, sign=1.0)
    assert spring(physics, rail, pitch) == pytest.approx(hertz_of(BALL), rel=2e-6)
