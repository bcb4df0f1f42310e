# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of groove.h: the position of a ball in a torus groove is compared with the surfaces of both
bodies."""

import mpmath
import numpy as np
import pytest
from bearings import B6208
from contact_reference import DIGITS, Reference
from physics_c import BALL, INNER, OUTER, PITCH
from raceway.theory.clearance import free_contact_angle, free_endplay, groove_distance
from scipy.optimize import minimize, minimize_scalar

CIRCLE = {INNER: 24.0e-3 + 6.552e-3, OUTER: 36.6e-3 - 6.552e-3}
TILTED = np.array([0.1, -0.05, 1.0]) / np.linalg.norm([0.1, -0.05, 1.0])


def place(azimuth, radius, height, axis=TILTED):
    """Return the point with the given cylindrical coordinates about `axis`."""
    first = np.cross(axis, [0.0, 1.0, 0.0])
    first /= np.linalg.norm(first)
    return (
        radius * (np.cos(azimuth) * first + np.sin(azimuth) * np.cross(axis, first)) + height * axis
    )


@pytest.mark.parametrize("side", [INNER, OUTER])
def test_numbers_of_the_groove(physics, side):
    radius = 24.0e-3 if side == INNER else 36.6e-3
    # lengths are of order 1e-2 m, so their rounding errors are 1e-18 m
    assert physics.call(
        "groove_circle", side=side, raceway_radius=radius, groove=6.552e-3, ball=BALL
    ) == pytest.approx(CIRCLE[side], abs=1e-17)
    assert physics.call("groove_slack", 6.552e-3, BALL) == pytest.approx(0.252e-3, abs=1e-17)


@pytest.mark.parametrize("side, radial", [(INNER, -1.0), (OUTER, 1.0)])
def test_a_ball_on_the_pitch_circle_just_touches_both_grooves(physics, side, radial):
    touching, state = physics.raceway_6208(side).touch([0.0, PITCH, 0.0], [0.0, 0.0, 1.0])
    assert state.overlap == pytest.approx(0, abs=2e-17)
    # the normal points towards the axis on the inner ring, and outwards on the outer ring
    assert [state.nu, state.ne] == pytest.approx([radial, 0], abs=1e-12)
    assert [*state.u, *state.t] == pytest.approx([0, 1, 0, -1, 0, 0], abs=3e-16)


@pytest.mark.parametrize("side", [INNER, OUTER])
@pytest.mark.parametrize(
    "azimuth, radius, height", [(0.3, PITCH, 1e-4), (2.0, PITCH + 3e-5, -7e-5), (4.4, 30.2e-3, 0.0)]
)
def test_against_high_precision(physics, side, azimuth, radius, height):
    d = place(azimuth, radius, height)
    with mpmath.workdps(DIGITS):
        reference = Reference(
            (d, [0] * 3, [0] * 3), ([0] * 3, [0] * 3, [0] * 3, TILTED), CIRCLE[side], BALL
        )
        expected, distance = reference.vectors(), float(reference.frame()["s"])
    g = physics.locate(d, TILTED, CIRCLE[side])
    assert g.s == pytest.approx(distance, abs=3e-17)  # a few rounding errors of 0.03 m
    assert np.concatenate([g.u, g.t]) == pytest.approx(
        np.concatenate([expected["u"], expected["t"]]), abs=1e-15
    )
    normal = g.nu * g.u + g.ne * TILTED
    assert normal == pytest.approx(expected["n"], abs=5e-13)  # rounding divided by s = 0.2 mm
    assert g.r * g.u + g.z * TILTED == pytest.approx(d, abs=2e-17)


@pytest.mark.parametrize("side", [INNER, OUTER])
@pytest.mark.parametrize(
    "azimuth, radius, height", [(0.3, PITCH, 8e-5), (2.0, PITCH + 4e-6, -7e-5)]
)
def test_overlap_is_the_depth_of_the_ball_in_the_ring(physics, side, azimuth, radius, height):
    d = place(azimuth, radius, height)

    def depth(angles):  # m, how far a point of the ball is behind the surface of the groove
        theta, phi = angles
        point = d + BALL * np.array(
            [np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)]
        )

        def away(psi):
            return np.linalg.norm(point - place(psi, CIRCLE[side], 0.0))

        nearest = minimize_scalar(
            away, bounds=(azimuth - 1.0, azimuth + 1.0), method="bounded", options=dict(xatol=1e-10)
        ).fun
        return nearest - 6.552e-3

    touching, state = physics.raceway_6208(side).touch(d, TILTED)
    normal = state.nu * state.u + state.ne * TILTED
    start = [np.arccos(normal[2]) + 0.02, np.arctan2(normal[1], normal[0]) - 0.02]
    found = minimize(
        lambda a: -1e3 * depth(a),
        start,
        method="Nelder-Mead",
        options=dict(xatol=1e-8, fatol=1e-13, maxiter=2000),
    )
    # at a smooth maximum, the error is the square of the angular error (1e-7) times 30 mm
    assert -1e-3 * found.fun == pytest.approx(state.overlap, abs=1e-14)
    assert touching == (state.overlap > 0)


def test_free_contact_angle_and_endplay(physics):
    # eqs A.2-A.4: the inner ring is at its axial stop, and the centre of the ball is on the line
    # through the groove centres
    clearance = 20e-6
    bearing = B6208
    angle, endplay = free_contact_angle(bearing, clearance), free_endplay(bearing, clearance)
    inner, outer = physics.raceway_6208(INNER, clearance), physics.raceway_6208(OUTER, clearance)
    centres = {
        side: np.array([ring.derived().centre_circle, 0, height])
        for side, ring, height in ((INNER, inner, endplay / 2), (OUTER, outer, 0.0))
    }
    line = centres[INNER] - centres[OUTER]
    # rounding errors of lengths of 0.03 m, relative to a distance of 0.5 mm
    assert np.linalg.norm(line) == pytest.approx(groove_distance(bearing), abs=3e-17)
    ball = (centres[INNER] + centres[OUTER]) / 2
    for ring, centre, sign in ((inner, endplay / 2, -1), (outer, 0.0, 1)):
        _, state = ring.touch(ball - [0, 0, centre], [0.0, 0.0, 1.0])
        assert state.overlap == pytest.approx(0, abs=3e-17)
        assert [state.nu, state.ne] == pytest.approx(
            [sign * np.cos(angle), sign * np.sin(angle)], abs=1e-12
        )
    # a ball that is slightly farther away is compressed
    _, state = inner.touch(ball - [0, 0, endplay / 2 + 1e-7], [0.0, 0.0, 1.0])
    assert state.overlap > 0
