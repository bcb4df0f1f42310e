# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of the balls' initial rotation (start_rotation.h) against its definition. By definition, a
ball rolls on both raceways such that the potential of the spin couples is smallest; the tests
search for the minimum with vectors in 40-digit arithmetic. Contact angles and loads follow from the
equilibrium of a ball under thrust."""

from types import SimpleNamespace

import mpmath
import numpy as np
import pytest
from mpmath import mpf
from physics_c import BALL, BALL_MASS, INNER, OUTER, PITCH
from raceway.core import laws
from references import hertz

GROOVE, YOUNG = 6.552e-3, laws.reduced_modulus(210e9, 0.3, 210e9, 0.3)
WIDTH = 0.78  # omega a divided by s_e (docs/tribology, Spin)


def contact(side, cosine, load):
    """Return the compression (m), the spin couple divided by the friction coefficient (N m), and
    the half-width a (m) of a contact."""
    gamma = BALL / PITCH * cosine * (-1 if side == INNER else 1)
    r_x, r_y = BALL * (1 + gamma), BALL * GROOVE / (GROOVE - BALL)
    found = hertz.contact(r_x, r_y, YOUNG, load)
    squeezed = (load / found["stiffness"]) ** (2 / 3)
    return SimpleNamespace(
        squeezed=squeezed, couple=0.375 * load * found["a"] * found["second"], a=found["a"]
    )


def under_thrust(thrust, centrifugal, clearance):
    """Return the contact angles (rad), the contacts, and the radius (m) of the path of the ball."""
    slack = GROOVE - BALL

    def at(angle):
        angles = angle, mpmath.atan2(thrust, thrust / mpmath.tan(angle) + centrifugal)
        each = [
            contact(side, float(mpmath.cos(a)), float(thrust / mpmath.sin(a)))
            for side, a in zip((INNER, OUTER), angles)
        ]
        lines = [(slack + c.squeezed) * mpmath.cos(a) for c, a in zip(each, angles)]
        return angles, each, lines

    apart = 2 * slack - clearance / 2
    angle = mpmath.findroot(lambda a: sum(at(a)[2]) - apart, (0.05, 1.4), solver="anderson")
    angles, each, lines = at(angle)
    return angles, each, 36.6e-3 + clearance / 2 - GROOVE + lines[1]


def least(angles, contacts, path, speeds, orbit):
    """Return (radial, axial, orbit) in rad/s for the motion with the smallest potential, which is
    found by golden-section search."""
    normals = [(-mpmath.cos(angles[0]), -mpmath.sin(angles[0]))]
    normals.append((mpmath.cos(angles[1]), mpmath.sin(angles[1])))

    def motion(radial):
        # along rolling, ball and ring have equal surface speeds, which are linear in (axial, orbit)
        rows, right = [], []
        for (u, e), speed in zip(normals, speeds):
            # BALL (axial - orbit) u - BALL radial e = (speed - orbit) (path + BALL u)
            rows.append([BALL * u, -BALL * u + path + BALL * u])
            right.append(speed * (path + BALL * u) + BALL * radial * e)
        axial, turns = mpmath.lu_solve(mpmath.matrix(rows), mpmath.matrix(right))
        return axial, turns

    def potential(radial):
        axial, _ = motion(radial)
        total = mpf(0)
        for (u, e), speed, c in zip(normals, speeds, contacts):
            spin = abs(radial * u + (axial - speed) * e)
            roll = abs(speed - orbit) * path / BALL
            width = WIDTH * roll * c.a / (2 * laws.deformed_radius(GROOVE, BALL))
            total += c.couple * (spin**2 / (2 * width) if spin < width else spin - width / 2)
        return total

    low, high, share = mpf(-5000), mpf(5000), (mpmath.sqrt(5) - 1) / 2
    for _ in range(130):
        one, two = high - share * (high - low), low + share * (high - low)
        low, high = (low, two) if potential(one) < potential(two) else (one, high)
    axial, turns = motion((low + high) / 2)
    return float((low + high) / 2), float(axial), float(turns)


def start(physics, clearance, **words):
    raceways = [physics.raceway_6208(side, clearance) for side in (INNER, OUTER)]
    scene = dict(radius=BALL, mass=BALL_MASS, path=PITCH, outer_speed=0.0, thrust=0.0, angle=0.0)
    return physics.call(
        "start_rotation",
        **dict(zip(("inner", "outer"), (one._handle for one in raceways))),
        **(scene | words),
    )


@pytest.mark.parametrize(
    ("thrust", "speeds", "clearance"),
    [
        (5.0, (1500.0, 0.0), 200e-6),  # outer control, because of centrifugal force
        (300.0, (50.0, 0.0), 100e-6),  # inner control
        (60.0, (600.0, 0.0), 300e-6),
        (100.0, (-400.0, 300.0), 50e-6),
        (30.0, (0.0, -900.0), 20e-6),
    ],
)
def test_least_loss_under_thrust(physics, thrust, speeds, clearance):
    orbit = laws.pure_rolling(BALL, PITCH, *speeds).orbit
    given = dict(inner_speed=speeds[0], outer_speed=speeds[1], orbit=orbit)
    with mpmath.workdps(40):
        centrifugal = BALL_MASS * PITCH * orbit**2
        angles, contacts, path = under_thrust(thrust, centrifugal, clearance)
        radial, axial, turns = least(angles, contacts, path, speeds, orbit)
    for sense in (1, -1):  # direction of the thrust
        found = start(physics, clearance, thrust=sense * thrust, **given)
        np.testing.assert_allclose(
            [found.radial, found.axial, found.orbit], [sense * radial, axial, turns], rtol=1e-8
        )
        assert abs(radial) > 0.01 * abs(axial)


def test_without_contact_angle_about_the_axis(physics):
    """Without a contact angle, the balls rotate about the axis of the bearing, even if the thrust
    exceeds the capacity of the grooves."""
    rolling = laws.pure_rolling(BALL, PITCH, 90.0, -20.0)
    for thrust in (0.0, 1e12):
        found = start(
            physics,
            20e-6,
            **dict(inner_speed=90.0, outer_speed=-20.0, orbit=rolling.orbit, thrust=thrust),
        )
        assert found.radial == 0
        np.testing.assert_allclose([found.axial, found.orbit], [rolling.spin, rolling.orbit])


@pytest.mark.parametrize("angle", [0.7, -0.3])
def test_of_a_seated_ball_one_raceway_has_hardly_any_spin(physics, angle):
    found = start(physics, 0.0, inner_speed=100.0, orbit=40.0, angle=angle)
    assert min(abs(found.spin)) < 0.15 * max(abs(found.spin))
    # the axis of rotation is perpendicular to the line of contact
    assert found.radial * angle * found.axial < 0
