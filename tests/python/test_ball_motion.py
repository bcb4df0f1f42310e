# SPDX-License-Identifier: GPL-2.0-or-later
"""The motion of a ball on several grooves is compared with closed-form solutions, and the minimum
of the power loss with linear programming."""

import numpy as np
import pytest
from bearings import B6208
from raceway import (
    ball_motion,
    catalogue,
    contact_friction,
    friction_torque,
    hertz,
    inputs,
    kinematics,
    lubrication,
    static,
)
from raceway.theory.bearing import INNER, OUTER
from scipy.optimize import linprog

ANGLE, RING = np.radians(35), 200.0
FOUR = B6208.four_point(ANGLE)
SIDES = np.array([INNER, INNER, OUTER, OUTER])
ANGLES = np.array([-ANGLE, ANGLE, ANGLE, -ANGLE])
R, PITCH = FOUR.ball_radius, FOUR.pitch_radius


def test_contacts_alike_roll_and_spin():
    """With four equal contacts, the ball rotates about an axis parallel to that of the bearing and
    rolls at all contacts. At each contact it spins at the relative speed of ball and ring
    multiplied by the sine of the contact angle."""
    lines, goal, _ = ball_motion.rates(FOUR, SIDES, ANGLES, RING)
    motion = ball_motion.least(lines, goal, np.repeat([1.0, 1e-4], 4), R)
    gamma = R * np.cos(ANGLE) / PITCH
    cage = RING * (1 - gamma) / 2
    assert motion == pytest.approx([0.0, -cage * PITCH / (R * np.cos(ANGLE)), cage * PITCH])
    slides, spins = np.split(lines @ motion - goal, 2)
    assert slides == pytest.approx(np.zeros(4), abs=1e-12)
    against = np.where(SIDES == INNER, motion[1] - RING, motion[1]) * np.sin(ANGLE)
    assert np.abs(spins) == pytest.approx(np.abs(against))


def test_least_power_of_linear_programming():
    """For random loads and angles, the minimum of w |A m - g| is the solution of a linear
    program."""
    draw = np.random.default_rng(3)
    for _ in range(20):
        lines, goal, _ = ball_motion.rates(FOUR, SIDES, ANGLES + draw.normal(0, 0.05, 4), RING)
        weight = draw.uniform(0, 1, 4) ** 3
        weight = np.concatenate([weight, weight * draw.uniform(3e-4, 9e-4, 4)])
        lost = np.abs(lines @ ball_motion.least(lines, goal, weight, R) - goal) @ weight
        size = np.array([R, R, 1.0])
        slack = np.eye(8)
        bounds = np.block([[lines / size, -slack], [-lines / size, -slack]])
        free = [(None, None)] * 3 + [(0, None)] * 8
        cost = np.concatenate([np.zeros(3), weight])
        best = linprog(cost, bounds, np.concatenate([goal, -goal]), bounds=free)
        assert lost == pytest.approx(best.fun, rel=1e-6)


def test_light_contacts_are_drawn_over_by_the_heavy_ones():
    """Under a thrust, the ball rolls on one inner and one outer groove. In addition to its spin, it
    rotates relative to the cage about an axis perpendicular to the line through both contacts. At
    the other two grooves, the surface speed of the ball is therefore cos(2 alpha) times as large,
    and the entrainment speed of the film is the mean of this speed and the speed of the ring."""
    state = static.equilibrium(FOUR, axial_load=2000.0, clearance=5e-6)
    entrained, rolling = ball_motion.speeds(FOUR, RING, state)
    heavy, alpha = [1, 2], state.inner.angle[1, 0]
    own = RING * PITCH * (1 - (R * np.cos(alpha) / PITCH) ** 2) / 2
    assert entrained[heavy] == pytest.approx(np.full((2, 9), own), rel=1e-9)
    assert rolling[heavy] == pytest.approx(entrained[heavy], rel=1e-9)
    # for the lightly loaded outer contact, whose angle is measured from the line through the
    # heavily loaded contacts
    other = -state.outer.angle[1, 0]
    drawn = own * (1 + np.cos(alpha + other)) / 2
    # the ball spins on one of the raceways at the ring's speed multiplied by the sine
    spun = RING * np.sin(alpha) * R * np.sin(alpha + other) / 2
    assert np.all(np.abs(entrained[3] - drawn) < spun)
    assert np.all(rolling[3] < 0.6 * entrained[3])


@pytest.mark.parametrize("law", friction_torque.SPIN_LAWS)
def test_four_points_lose_little_more_than_their_spin(law):
    """Under preload alone there are four equal contacts, which spin as in the first test. The power
    dissipated by combined slip and spin is smaller than the sum of the powers for slip and spin
    treated separately, but by less than a fifth."""
    state = static.equilibrium(FOUR, clearance=-20e-6)
    path = catalogue.find("lubricants", "vg46")
    oil, fluid = inputs.oil(path), inputs.fluid(path)
    films = lubrication.lubricate(FOUR, state, oil, RING, -20e-6)
    orbit = lubrication.orbit(FOUR, state, RING)
    surfaces = contact_friction.Surfaces(film=0.05, boundary=0.05)
    lost = friction_torque.losses(
        FOUR, state, films, fluid, RING, orbit, clearance=-20e-6, surfaces=surfaces, spin_law=law
    )
    angle = state.inner.angle[1, 0]
    gamma = R * np.cos(angle) / PITCH
    spins = RING * (1 + np.array([1, -1]) * gamma) / 2 / gamma * np.sin(angle)
    each = []
    for side, contact, rate in zip((INNER, OUTER), (state.inner, state.outer), spins):
        shape = hertz.exact(*FOUR.effective_radii(side, angle, -20e-6))
        moment = 3 / 8 * 0.05 * contact.load * contact.a * shape.second
        each.append(moment.sum() * rate)
    assert lost.spin.sum() == pytest.approx(sum(each), rel=0.01)
    assert lost.power > sum(each)


@pytest.mark.parametrize("light", [1e-4, 1e-2, 0.1])
def test_a_cage_drives_a_ball_that_hardly_touches_the_inner_ring(light):
    """Contacts with both grooves of the outer ring spin, which would stop the ball. It rolls on
    them instead, as it does without any inner contact."""
    sides, angles = SIDES[1:], ANGLES[1:]
    load, a = np.array([light, 12.0, 12.0]), np.full(3, 1e-4)
    weight = np.concatenate([load, 0.4 * load * a])
    motion = ball_motion.driven(FOUR, sides, angles, RING, weight, np.full(3, 1e-3), a)
    gamma = R * np.cos(ANGLE) / PITCH
    cage = RING * (1 - gamma) / 2 * PITCH
    assert motion[2] == pytest.approx(cage, rel=ball_motion.LAG)
    lines, goal, _ = ball_motion.rates(FOUR, sides, angles, RING)
    assert (lines @ motion - goal)[1:3] == pytest.approx(np.zeros(2), abs=1e-3 * cage)


def test_motion_between_two_minima():
    """While the load of one contact grows, the ball goes from sliding at this contact to rolling at
    it, and its motion changes by small steps if the load does. The minimum of the power jumps."""
    sides, angles = SIDES, ANGLES + np.array([0.0, 0.02, 0.0, -0.02])
    lines, goal, _ = ball_motion.rates(FOUR, sides, angles, RING)
    a = np.array([1e-4, 3e-4, 3e-4, 1e-4])

    def weight(last):
        load = np.array([1.0, 160.0, 160.0, last])
        return np.concatenate([load, 0.4 * load * a])

    def least(last):
        return ball_motion.least(lines, goal, weight(last), R)

    def moved(last):
        return ball_motion.driven(FOUR, sides, angles, RING, weight(last), np.full(4, 1e-2), a)

    def largest_step(of, loads):
        return np.ptp([(of(one) * [R, R, 1.0])[:2] for one in loads], axis=0).max()

    low, high = 1.0, 100.0
    whole = largest_step(least, [low, high])
    assert whole > 0.1  # m/s
    while high - low > 1e-9:  # the load at which the minimum jumps most
        middle = (low + high) / 2
        if largest_step(least, [low, middle]) > largest_step(least, [middle, high]):
            high = middle
        else:
            low = middle
    assert largest_step(least, [low, high]) > 0.2 * whole
    assert largest_step(moved, [low, high]) < 1e-6 * whole


def test_balls_pressed_into_both_outer_grooves_roll_with_their_cage():
    """At 89,000 rpm the centrifugal load presses the balls into both outer grooves, where they
    spin. In a run with a cage ring they nevertheless roll: after 3000 ball passes they orbit within
    0.2 % of the speed of rolling, and without a cage at 0.70 of it."""
    four, ring = inputs.bearing("6208", four_point=ANGLE), 89062.8 * np.pi / 30
    state, _ = lubrication.turning(four, ring, 0.0, 900.0, held=static.STRAIGHT)
    assert np.all(state.outer.load > 10 * state.inner.load.max(0))
    entrained, _ = ball_motion.speeds(four, ring, state)
    rolling = kinematics.entrainment(four, ring, np.vstack([state.inner.angle, state.outer.angle]))
    assert entrained[2:] == pytest.approx(rolling[2:], rel=2 * ball_motion.LAG)
