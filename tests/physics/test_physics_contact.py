# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of contact.h for one ball on one raceway, against moving rigid bodies in 40-digit
arithmetic and against the conservation laws.

Positions have rounding errors of 1e-17 m (an ulp of 0.03 m), and the ball is s = 0.2 mm away from
the circle of groove centres. Directions are therefore accurate to 1e-13, and speeds to 1e-12 of the
largest speed (at most 100 m/s here, with cancellation). The relative accuracy of the overlap (10
um) is 1e-12.
"""

import mpmath
import numpy as np
import pytest
from contact_reference import DIGITS, Reference
from physics_c import BALL, CONSTANT, FRICTIONLESS, INNER, OIL, OUTER, PITCH, STRIBECK, rolling
from raceway.core import laws

CIRCLE = {INNER: 30.552e-3, OUTER: 30.048e-3}
SLACK = 0.252e-3
SIDES = pytest.mark.parametrize("side", [INNER, OUTER])


def unit(v):
    return np.array(v) / np.linalg.norm(v)


AXES = {
    "straight": np.array([0.0, 0.0, 1.0]),
    "tilted": unit([0.03, -0.02, 1.0]),
    "aslant": unit([1.0, -2.0, 0.5]),
}


def scene(side, axis="tilted", angle=0.4, overlap=1e-5, azimuth=0.7, ring_w=(20.0, -35.0, 150.0)):
    """Return (ball, ring) for a ball with a given overlap at a given contact angle (rad), where all
    bodies are in motion."""
    e = AXES[axis]
    first = unit(np.cross(e, [0.3, 1.0, 0.1]))
    u = np.cos(azimuth) * first + np.sin(azimuth) * np.cross(e, first)
    sign = -1 if side == INNER else 1
    normal = sign * np.cos(angle) * u + np.sin(angle) * e
    ring = (np.array([3e-3, -2e-3, 1e-3]), np.array([0.02, -0.05, 0.03]), np.array(ring_w), e)
    place = ring[0] + CIRCLE[side] * u + (SLACK + overlap) * normal
    velocity = 2.0 * np.cross(e, u) + 0.03 * u - 0.02 * e
    rate = (velocity - ring[1] - np.cross(ring[2], place - ring[0])) @ normal
    velocity += (0.013 - rate) * normal  # the contact closes slowly, so it is loaded
    return (place, velocity, np.array([90.0, -60.0, -400.0])), ring


SCENES = pytest.mark.parametrize(
    "axis, angle, azimuth",
    [("straight", 0.0, 0.3), ("straight", 0.4, 2.0), ("tilted", -0.6, 4.0), ("aslant", 1.2, 1.0)],
)


def make(physics, side, friction=CONSTANT, **changes):
    return physics.raceway_6208(
        side, **(OIL | dict(friction=friction, mu=0.08, mu_boundary=0.12, mu_full=0.02) | changes)
    )


def biggest_speed(ball, ring):
    return np.linalg.norm(ball[1]) + BALL * np.linalg.norm(ball[2]) + 0.04 * np.linalg.norm(ring[2])


# ---- kinematics
# ---------------------------------------------------------------------------------------


@SIDES
@SCENES
@pytest.mark.parametrize("ring_w", [(20.0, -35.0, 150.0), (0.0, 0.0, 0.0), (300.0, 200.0, -100.0)])
def test_speeds_are_those_of_the_bodies(physics, side, axis, angle, azimuth, ring_w):
    ball, ring = scene(side, axis, angle, azimuth=azimuth, ring_w=ring_w)
    with mpmath.workdps(DIGITS):
        expected = Reference(ball, ring, CIRCLE[side], BALL).speeds()
    state = make(physics, side).contact(ball, ring)
    found = [state.overlap_rate, state.sliding_t, state.sliding_w, state.entrainment]
    assert found == pytest.approx(expected, abs=1e-12 * biggest_speed(ball, ring))


@SIDES
@pytest.mark.parametrize("turning", [(0.0, 0.0, 200.0), (150.0, -40.0, 60.0)])
def test_turning_the_whole_world_changes_no_speed(physics, side, turning):
    # rotating both bodies rigidly leaves overlap, slip and entrainment unchanged
    ball, ring = scene(side)
    spin, about = np.array(turning), np.array([0.01, 0.02, -0.01])
    moved = [(x, v + np.cross(spin, x - about), w + spin, *rest) for x, v, w, *rest in (ball, ring)]
    still, turned = make(physics, side).contact(ball, ring), make(physics, side).contact(*moved)
    for name in ("overlap_rate", "sliding_t", "sliding_w", "entrainment"):
        assert getattr(turned, name) == pytest.approx(
            getattr(still, name), abs=1e-12 * biggest_speed(*moved)
        ), name


@SIDES
def test_overlap_rate_along_the_motion(physics, side):
    # comparison with finite differences of the header's overlap, for a tilting ring
    ball, ring = scene(side)
    ring_model = make(physics, side)

    def overlap(t):
        e = physics.rotate(ring[3], ring[2] * t)
        return ring_model.touch(ball[0] + ball[1] * t - ring[0] - ring[1] * t, e)[1].overlap

    h = 3e-8
    found = (overlap(h) - overlap(-h)) / (2 * h)
    # the truncation error is h^2 v^3/(6 s^2), where v, the speed across n, is below 1 m/s; the
    # rounding error is 2e-17 m/h
    assert ring_model.contact(ball, ring).overlap_rate == pytest.approx(
        found, abs=h**2 / (6 * SLACK**2) + 2e-17 / h
    )


@SIDES
@pytest.mark.parametrize("inner, outer", [(50.0, 0.0), (50.0, -20.0), (0.0, 30.0)])
def test_pure_rolling_does_not_slide(physics, side, inner, outer):
    motion = rolling(inner, outer)
    ball = (
        np.array([0, -PITCH, 0]),
        np.array([motion.orbit * PITCH, 0, 0]),
        np.array([0, 0, motion.spin]),
    )
    ring = (
        np.zeros(3),
        np.zeros(3),
        np.array([0, 0, inner if side == INNER else outer]),
        AXES["straight"],
    )
    state = make(physics, side).contact(
        (ball[0] * (1 + (1e-12 if side == OUTER else -1e-12)), *ball[1:]), ring
    )
    # the ball is 3e-14 m away from the pitch circle, so that it just touches the raceways
    assert state.sliding_t == pytest.approx(0, abs=1e-10)
    # the textbook formula for the speed difference of the rings is (1 - gamma^2)/2 omega r_pitch
    gamma = BALL / PITCH
    assert state.entrainment == pytest.approx(
        abs(inner - outer) * PITCH * (1 - gamma**2) / 2, abs=1e-10
    )


# ---- loads
# --------------------------------------------------------------------------------------------


@SIDES
@pytest.mark.parametrize("angle", [0.0, 0.4, -1.1])
def test_load_and_stiffness(physics, side, angle):
    ball, ring = scene(side, angle=angle)
    raceway = make(physics, side)
    state = raceway.contact(ball, ring)
    assert state.overlap == pytest.approx(1e-5, rel=3e-12)
    assert state.cos_angle == pytest.approx(np.cos(angle), abs=1e-12)
    exact = raceway.exact(np.cos(angle)).K
    assert state.load == pytest.approx(exact * 1e-5**1.5, rel=1e-9)  # accuracy of the table
    assert state.root**2 == pytest.approx(state.overlap, rel=1e-15)
    # stiffness = dQ/d(overlap), so the ball is displaced along the normal at a constant contact
    # angle
    normal, h = state.nu * state.u + state.ne * ring[3], 2e-9
    loads = [raceway.contact((ball[0] + step * normal, *ball[1:]), ring).load for step in (h, -h)]
    # the truncation error is (h/overlap)^2/24 for a power of 3/2; the rounding error is 2e-17 m/h
    assert state.stiffness == pytest.approx(
        (loads[0] - loads[1]) / (2 * h), rel=(h / 1e-5) ** 2 / 24 + 2e-17 / h * 3
    )


@SIDES
def test_damping_is_the_slope_of_the_normal_force(physics, side):
    ball, ring = scene(side)
    raceway = make(physics, side, friction=FRICTIONLESS)
    state = raceway.contact(ball, ring)
    normal, step = state.nu * state.u + state.ne * ring[3], 1e-3
    pushed = raceway.contact((ball[0], ball[1] + step * normal, ball[2]), ring)
    # N is linear in the rate, and a motion along n changes only U_r; the error is thus the rounding
    # error of forces of 1e3 N (1e-12 of the force), divided by C step
    found = (pushed.normal - state.normal) / step
    assert found == pytest.approx(state.damping, rel=1e-10 + 1e-9 / (state.damping * step))
    assert pushed.overlap_rate - state.overlap_rate == pytest.approx(step, abs=1e-12)


@SIDES
@pytest.mark.parametrize("angle", [0.0, 0.5])
def test_damping_is_the_sum_of_both_laws(physics, side, angle):
    ball, ring = scene(side, angle=angle)
    raceway = make(physics, side, film_floor=1e-9)
    state, c = raceway.contact(ball, ring), raceway.exact(np.cos(angle))
    h_min = np.exp(c.min_lnA) * state.entrainment**c.min_p * state.load**c.min_m
    fluid = (
        3
        * np.pi
        * OIL["viscosity"]
        * c.a
        * np.sqrt(state.overlap)
        / np.sqrt(2)
        * (BALL / h_min) ** 1.5
    )
    # the error is that of the table, multiplied by ln U and ln Q
    assert state.h_min == pytest.approx(h_min, rel=1e-8)
    assert state.lam == pytest.approx(h_min / 50e-9, rel=1e-8)
    assert state.damping == pytest.approx(1.5 * 0.08 * state.load + fluid, rel=3e-8)  # h^-1.5
    dry = make(physics, side, viscosity=0.0).contact(ball, ring)
    assert [dry.damping, dry.h_min, dry.lam] == pytest.approx(
        [1.5 * 0.08 * dry.load, 0, 0], rel=1e-14
    )


@SIDES
def test_at_rest_the_film_is_gone_and_the_damper_stays_finite(physics, side):
    ball, ring = scene(side, angle=0.0, axis="straight")
    still = [(q[0], np.zeros(3), np.zeros(3), *q[3:]) for q in (ball, ring)]
    raceway = make(physics, side)
    state, c = raceway.contact(*still), raceway.radial()
    assert [state.entrainment, state.h_min, state.lam, state.overlap_rate] == [0] * 4
    expected = (
        1.5 * 0.08 * state.load + c.film_damper * c.a * state.root * raceway.derived().floor ** -1.5
    )
    assert state.damping == pytest.approx(expected, rel=1e-14)
    assert state.normal == state.load
    assert make(physics, side, film_floor=1e-7).contact(*still).damping < state.damping


@SIDES
def test_no_adhesion(physics, side):
    ball, ring = scene(side)
    state = make(physics, side).contact(ball, ring)
    normal = state.nu * state.u + state.ne * ring[3]
    # N vanishes if the separation speed increases by this amount
    critical = state.load / state.damping + state.overlap_rate
    for factor, sign in ((0.99, 1), (1.01, 0), (100.0, 0)):
        away = make(physics, side).contact(
            (ball[0], ball[1] - factor * critical * normal, ball[2]), ring
        )
        assert np.sign(away.normal) == sign
        assert away.load > 0
    # the friction is also zero
    assert away.force.tolist() == [0, 0, 0] and away.ball_torque.tolist() == [0, 0, 0]


@SIDES
def test_touch_ends_where_the_overlap_does(physics, side):
    raceway = make(physics, side)
    for overlap, expected in ((1e-9, True), (-1e-9, False)):
        ball, ring = scene(side, overlap=overlap)
        touching, state = raceway.touch(ball[0] - ring[0], ring[3])
        assert touching is expected and state.overlap == pytest.approx(overlap, abs=3e-17)


# ---- friction
# -----------------------------------------------------------------------------------------


@SIDES
def test_friction_constants(physics, side):
    ball, ring = scene(side)
    state = make(physics, side, tangential_ratio=0.8, tangential_zeta=0.25, mu=0.05).contact(
        ball, ring
    )
    assert [state.mu, state.kt] == pytest.approx([0.05, 0.8 * state.stiffness], rel=1e-15)
    mass = make(physics, side).data["ball_mass"]
    assert state.ct == pytest.approx(2 * 0.25 * np.sqrt(state.kt * 2 / 7 * mass), rel=1e-14)
    # sliding
    assert np.hypot(state.friction_t, state.friction_w) == pytest.approx(
        0.05 * state.normal, rel=1e-13
    )


@SIDES
@pytest.mark.parametrize("roughness", [20e-9, 120e-9, 900e-9])
def test_stribeck_friction_follows_the_film(physics, side, roughness):
    ball, ring = scene(side)
    state = make(
        physics, side, friction=STRIBECK, ring_roughness=roughness, ball_roughness=0.0
    ).contact(ball, ring)
    assert state.lam == pytest.approx(state.h_min / roughness, rel=1e-15)
    assert state.mu == laws.stribeck(0.12, 0.02, 1.0, 3.0, state.lam)


@SIDES
def test_the_spring_is_wound_by_the_slip(physics, side):
    ball, ring = scene(side)
    raceway, before, dt = make(physics, side, mu=1e6), np.array([1e-7, -2e-7]), 1e-8
    state = raceway.contact(ball, ring, dt=dt, xi=before)
    slip = np.array([state.sliding_t, state.sliding_w])
    assert state.xi == pytest.approx(before + dt * slip, rel=1e-14)
    assert [state.friction_t, state.friction_w] == pytest.approx(
        state.kt * state.xi + state.ct * slip, rel=1e-14
    )
    assert raceway.contact(ball, ring, dt=0.0, xi=before).xi.tolist() == before.tolist()


@SIDES
@pytest.mark.parametrize("direction", ["sliding_t", "sliding_w"])
def test_friction_opposes_the_slip(physics, side, direction):
    ball, ring = scene(side)
    state = make(physics, side, friction=CONSTANT).contact(ball, ring)
    free = make(physics, side, friction=FRICTIONLESS).contact(ball, ring)
    normal = state.nu * state.u + state.ne * ring[3]
    along = state.t if direction == "sliding_t" else np.cross(normal, state.t)
    slip, force = getattr(state, direction), (state.force - free.force) @ along
    assert force == pytest.approx(
        -0.08 * state.normal * slip / np.hypot(state.sliding_t, state.sliding_w), rel=1e-9
    )
    assert [free.friction_t, free.friction_w, free.mu] == [0] * 3


# ---- balances
# -----------------------------------------------------------------------------------------


@SIDES
@SCENES
def test_force_and_torque_act_at_the_contact_point(physics, side, axis, angle, azimuth):
    ball, ring = scene(side, axis, angle, azimuth=azimuth)
    state = make(physics, side).contact(ball, ring, dt=1e-7)
    with mpmath.workdps(DIGITS):
        frame = Reference(ball, ring, CIRCLE[side], BALL).vectors()
    force = (
        -state.normal * frame["n"] - state.friction_t * frame["t"] - state.friction_w * frame["w"]
    )
    size = np.linalg.norm(force)
    assert size > 100 and np.linalg.norm(state.ball_torque) > 0
    assert state.force == pytest.approx(force, abs=1e-12 * size)
    assert state.ball_torque == pytest.approx(
        np.cross(BALL * frame["n"], force), abs=1e-12 * size * BALL
    )
    assert state.ring_torque == pytest.approx(
        np.cross(frame["point"] - ring[0], -force), abs=1e-12 * size * PITCH
    )


@SIDES
@SCENES
def test_momentum_is_conserved(physics, side, axis, angle, azimuth):
    # the forces on ball and ring are opposite, and their moments about any point cancel
    ball, ring = scene(side, axis, angle, azimuth=azimuth)
    state = make(physics, side).contact(ball, ring, dt=1e-7)
    for about in (np.zeros(3), np.array([0.2, -0.1, 0.4])):
        moment = (
            state.ball_torque
            + np.cross(ball[0] - about, state.force)
            + state.ring_torque
            + np.cross(ring[0] - about, -state.force)
        )
        # rounding errors for lever arms below 1 m
        assert moment == pytest.approx(0, abs=1e-14 * np.linalg.norm(state.force))


@SIDES
@SCENES
def test_power_is_that_of_the_contact(physics, side, axis, angle, azimuth):
    # the power supplied to both bodies equals the power of spring, damper and friction; this test
    # therefore relates rates to forces
    ball, ring = scene(side, axis, angle, azimuth=azimuth)
    state = make(physics, side).contact(ball, ring, dt=1e-7)
    received = (
        state.force @ (ball[1] - ring[1])
        + state.ball_torque @ ball[2]
        + state.ring_torque @ ring[2]
    )
    taken = (
        state.normal * state.overlap_rate
        + state.friction_t * state.sliding_t
        + state.friction_w * state.sliding_w
    )
    scale = np.linalg.norm(state.force) * biggest_speed(ball, ring)
    assert abs(taken) > 1e-4 * scale
    assert received == pytest.approx(-taken, abs=1e-12 * scale)


@SIDES
def test_the_sense_of_the_axis_does_not_matter(physics, side):
    ball, ring = scene(side)
    one, other = (
        make(physics, side).contact(ball, (*ring[:3], e), dt=1e-7) for e in (ring[3], -ring[3])
    )
    for name in ("force", "ball_torque", "ring_torque"):
        assert getattr(other, name) == pytest.approx(
            getattr(one, name), abs=1e-12 * np.linalg.norm(one.force)
        )
    assert [other.entrainment, other.overlap_rate] == pytest.approx(
        [one.entrainment, one.overlap_rate], rel=1e-12
    )
