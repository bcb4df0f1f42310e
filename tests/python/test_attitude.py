# SPDX-License-Identifier: GPL-2.0-or-later
"""The rotation of a ball that touches both raceways. The rate of change of its angular momentum is
compared with the moments of its contacts, computed with vectors, and the limits of a light and a
heavy ball are tested."""

import numpy as np
import pytest
from raceway import sliding, spin
from raceway.theory import attitude
from raceway.theory.bearing import Bearing

BODY = Bearing(13, 5.953e-3, 24.0e-3, 36.0e-3, 6.19e-3, 6.31e-3)
RING, STEEL = 1047.2, 7800.0


def drawn(balls=40):
    """Return contacts (2, Z) of balls that range from firmly held to grossly sliding."""
    draw = np.random.default_rng(3)
    angle = draw.uniform((0.3, 0.1), (0.9, 0.6), (balls, 2)).T
    load = 10 ** draw.uniform(0.7, 3.3, balls) * np.array([[1.0], [1.2]])
    limit, a = 0.05 * load, 1.5e-4 * np.cbrt(load)
    return dict(
        angle=angle,
        limit=limit,
        a=a,
        pure=spin.moment(load, 0.05, a, 1.02),
        edge=draw.uniform(0.02, 0.5, (2, balls)),
    )


def found(density=STEEL, **contacts):
    return attitude.balanced(BODY, ring=RING, density=density, **contacts)


@pytest.mark.parametrize("ring", [RING, -RING])
def test_moments_change_the_angular_momentum(ring):
    """In axes (radial, along the path, axial) that turn with the ball, dL/dt = Omega x L equals the
    sum of all moments about the ball's centre. For a virtual rotation that rolls on both raceways,
    the forces along the rolling direction do no work and therefore drop out."""
    contacts = drawn()
    motion = attitude.balanced(BODY, ring=ring, density=STEEL, **contacts)
    none, turn = attitude.rolling(BODY, contacts["angle"], ring)
    radial = (motion.spin[0] - none[1]) / turn[1]
    assert motion.orbit == pytest.approx(none[0] + turn[0] * radial, rel=1e-12)
    inertia = 8 / 15 * np.pi * BODY.ball_radius**5 * STEEL
    way = np.array([-1.0, 1.0])[:, None]
    zero = np.zeros(radial.shape)
    moments, normals = 0, []
    about = -np.sign(motion.orbit * radial) * motion.across / BODY.ball_radius  # about the path
    for k in range(2):
        cosine, sine = np.cos(contacts["angle"][k]), np.sin(contacts["angle"][k])
        normal = way[k] * np.array([cosine, zero, sine])
        slides = np.cross(np.array([zero, about, zero]), BODY.ball_radius * normal, axis=0)
        assert np.linalg.norm(slides, axis=0) == pytest.approx(motion.across, rel=1e-12)
        force = -motion.force[k] * slides / motion.across
        moments = moments + np.cross(BODY.ball_radius * normal, force, axis=0)
        moments = moments - np.sign(motion.spin[k]) * motion.moment[k] * normal
        normals.append(normal)
    change = inertia * np.cross([0, 0, 1.0], np.array([radial, about, zero]).T).T * motion.orbit
    assert moments[1] == pytest.approx(change[1], rel=1e-5)
    # a virtual rotation about this vector rolls on both raceways
    spins = turn[1:]
    rotation = np.array([np.ones(radial.shape), zero, zero])
    # its axial component follows from the spin at the outer raceway: turn = rotation . normal
    rotation[2] = (spins[1] - normals[1][0]) / normals[1][2]
    work = (moments * rotation).sum(0) - (change * rotation).sum(0)
    scale = np.abs(contacts["pure"] * spins).sum(0)
    assert np.abs(work / scale).max() < 1e-5


def test_friction_across_follows_the_law_of_slip():
    contacts = drawn()
    motion = found(**contacts)
    width = contacts["edge"] / sliding.LEAN
    force = contacts["limit"] * motion.across / np.hypot(motion.across, width)
    assert motion.force == pytest.approx(force, rel=1e-12)
    shares = motion.force.sum(0) / contacts["limit"].sum(0)
    assert shares.min() < 0.1 and shares.max() > 0.9, "some balls are held, others slide"
    assert np.all(motion.force <= contacts["limit"])


def test_light_balls_only_spin():
    """Without inertia, the spin moments balance and no contact slides across its groove."""
    contacts = drawn()
    motion = found(density=1e-3, **contacts)
    turn = attitude.rolling(BODY, contacts["angle"], RING)[1][1:]
    balance = (np.sign(motion.spin) * motion.moment * turn).sum(0)
    scale = (contacts["pure"] * np.abs(turn)).sum(0)
    assert np.abs(balance / scale).max() < 1e-4
    assert motion.across.max() < 1e-3


def test_heavy_balls_turn_about_the_axis_of_the_bearing():
    """If friction cannot balance the gyroscopic moment, this moment turns the ball until it
    vanishes. The sliding speed then decreases as 1/J. At low sliding speeds the friction force is
    proportional to the sliding speed, so the radial component of the rotation decreases as
    1/J^2."""
    contacts = drawn()
    none, turn = attitude.rolling(BODY, contacts["angle"], RING)
    radial = [
        np.abs((found(density, **contacts).spin[0] - none[1]) / turn[1]).max()
        for density in (1e9, 1e10)
    ]
    assert radial[1] == pytest.approx(0.01 * radial[0], rel=0.05)


def test_without_contact_angle_nothing_turns():
    contacts = drawn()
    contacts["angle"] = np.zeros((2, 40))
    motion = found(**contacts)
    assert np.abs(motion.spin).max() < 1e-9 * RING and motion.across.max() < 1e-12
