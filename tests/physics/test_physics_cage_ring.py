# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of cage_drag.h and cage_ring.h. The laws agree with closed-form solutions. A pocket and a
land anywhere in space conserve momentum, angular momentum and energy, and their results do not
depend on the orientation of the bearing in the lab frame."""

import numpy as np
import pytest
from raceway.core import laws
from scipy.spatial.transform import Rotation

OIL = 0.04
# A running bearing: diameters of ball and pitch circle (m), cage speed and ball spin relative to
# the cage (rad/s).
BEARINGS = {
    "6205": (7.940e-3, 39.04e-3, 74.954, 443.50),
    "MFPT": (5.969e-3, 31.62e-3, 63.076, 397.22),
}


@pytest.mark.parametrize("name, couple", [("6205", 0.09691e-3), ("MFPT", 0.02772e-3)])
def test_oil_in_a_pocket_shears_over_its_band(name, couple):
    ball, _, _, spin = BEARINGS[name]
    found = laws.pocket_shear(OIL, ball / 2, 2 * 0.1e-3, 1.0) * spin
    assert found == pytest.approx(couple, rel=2e-4)
    # integral of (eta v/c) r over the band, where v = w R |cos|
    angle = (np.arange(400) + 0.5) * 2 * np.pi / 400
    r = ball / 2 * np.abs(np.cos(angle))
    band = 0.35 * ball * ball / 2 * 2 * np.pi / 400
    assert found == pytest.approx(np.sum(OIL * spin * r / 0.1e-3 * r * band), rel=1e-12)


@pytest.mark.parametrize(
    "name, outer, inner", [("6205", 2.905e-3, 2.209e-3), ("MFPT", 1.270e-3, 0.985e-3)]
)
def test_a_centred_land_is_petroffs_bearing(name, outer, inner):
    ball, pitch, cage, _ = BEARINGS[name]
    shaft = {"6205": 1797, "MFPT": 1485}[name] * np.pi / 30
    at = pitch / 2 + 0.28 * ball * np.array([1, -1])
    centred, off = (laws.land_couple(OIL, at, 0.2e-3, 3e-3, 1.0, share) for share in (0.0, 0.6))
    assert centred * [cage, shaft - cage] == pytest.approx([outer, inner], rel=1e-3)
    assert off / centred == pytest.approx([1.25, 1.25])


def film(physics, e, angle=0.0, speed=74.954, whirl=0.0, v=(0.0, 0.0)):
    """Return the radial force (outwards) and the tangential force (in the direction of rotation) on
    the cage of a 6205 with the relative eccentricity `e` in the direction `angle` (rad)."""
    ball, pitch, _, _ = BEARINGS["6205"]
    c = 0.2e-3
    out, along = np.array([np.cos(angle), np.sin(angle)]), np.array([-np.sin(angle), np.cos(angle)])
    move = out * v[0] + along * (v[1] + whirl * e * c)
    force = physics.formula("cage_land_film")(
        OIL, pitch / 2 + 0.28 * ball, 3e-3, c, *(out * e * c), *move, speed
    )
    return np.array([np.dot(force, out), np.dot(force, along)])


@pytest.mark.parametrize("e, size, attitude", [(0.5, 0.03302, 53.68), (0.9, 1.0563, 20.83)])
def test_the_film_of_a_land_is_ocvirks(physics, e, size, attitude):
    for angle in (0.0, 1.0, 4.0):
        radial, along = film(physics, e, angle)
        assert np.hypot(radial, along) == pytest.approx(size, rel=2e-4)
        assert radial < 0 < along
        assert np.degrees(np.arctan2(along, -radial)) == pytest.approx(attitude, abs=0.01)


def test_whirl_at_half_the_speeds_takes_the_film_away(physics):
    assert film(physics, 0.6, whirl=74.954 / 2) == pytest.approx([0, 0], abs=1e-12)
    assert film(physics, 0.6, whirl=74.954)[1] == pytest.approx(-film(physics, 0.6)[1], rel=1e-9)


MOTIONS = [(0.0, 0.0), (3e-3, 0.0), (-3e-3, 1e-3), (2e-3, -4e-3), (0.0, 2e-2)]


@pytest.mark.parametrize("v", MOTIONS)
@pytest.mark.parametrize("speed", [0.0, 74.954, -20.0])
def test_a_mirrored_land_has_the_mirrored_film(physics, v, speed):
    for e in (1e-3, 0.5, 0.95):
        found = film(physics, e, speed=speed, v=v)
        mirrored = film(physics, e, speed=-speed, v=(v[0], -v[1]))
        assert mirrored * [1, -1] == pytest.approx(found, rel=1e-9, abs=1e-15)


@pytest.mark.parametrize("v", MOTIONS)
@pytest.mark.parametrize("speed", [0.0, 74.954, -20.0])
def test_the_film_of_a_land_is_the_sum_of_its_line_loads(physics, v, speed):
    """The load acts where the gap closes, as seen from axes that rotate at half the sum of the
    speeds."""
    ball, pitch, _, _ = BEARINGS["6205"]
    radius, width, c = pitch / 2 + 0.28 * ball, 3e-3, 0.2e-3
    for e in (0.0, 0.5, 0.9):
        angle = (np.arange(200000) + 0.5) * 2 * np.pi / 200000
        closing = v[0] * np.cos(angle) + (v[1] - speed / 2 * e * c) * np.sin(angle)
        load = OIL * width**3 * np.maximum(closing, 0) / (c * (1 - e * np.cos(angle))) ** 3
        wanted = -radius * 2 * np.pi * np.mean([load * np.cos(angle), load * np.sin(angle)], axis=1)
        found = film(physics, e, speed=speed, v=v)
        assert found == pytest.approx(wanted, rel=1e-6, abs=1e-6 * np.hypot(*wanted) + 1e-12)


def test_a_film_resists_every_motion_without_entrainment(physics):
    for e in (1e-9, 0.3, 0.8, 1.4):
        for v in ((1e-3, 0.0), (-1e-3, 0.0), (0.0, 1e-3), (2e-3, -1e-3)):
            assert np.dot(film(physics, e, speed=0.0, v=v), v) < 0


def test_a_centred_cage_is_damped_alike_in_every_direction(physics):
    ball, pitch, _, _ = BEARINGS["6205"]
    r, c = pitch / 2 + 0.28 * ball, 0.2e-3
    for v in ((1e-3, 0.0), (0.0, 1e-3), (-6e-4, 8e-4)):
        force = physics.formula("cage_land_film")(OIL, r, 3e-3, c, 0.0, 0.0, *v, 80.0)
        k = np.pi * OIL * r * 3e-3**3 / (2 * c**3)
        assert np.array(force) == pytest.approx(-k * np.array(v), rel=1e-9)


def test_a_disc_churns_as_in_the_tables():
    law = laws.cage_churning
    for name, couple in (("6205", 0.170e-3), ("MFPT", 0.055e-3)):
        ball, pitch, cage, _ = BEARINGS[name]
        found = law(0.1, 870.0, OIL, pitch / 2, ball / 2, cage)
        assert found == pytest.approx(couple, rel=0.02)
        assert law(0.1, 870.0, OIL, pitch / 2, ball / 2, -cage) == -found
    assert law(0.1, 870.0, OIL, 0.02, 0.0, 0.0) == 0
    # turbulent flow: the drag coefficient falls with the fifth root of the Reynolds number
    fast = law(1.0, 870.0, 1e-4, 0.05, 0.0, np.array([400.0, 800.0]))
    assert fast[1] / fast[0] == pytest.approx(2**1.8, rel=1e-12)


PITCH, BALL, PLAY = 19.52e-3, 3.97e-3, 0.1e-3
CAGE = dict(
    pockets=9,
    spherical=0,
    pitch=PITCH,
    phase=0.3,
    along=PLAY,
    across=PLAY,
    stiffness=3e8,
    mass=0.01,
    friction=0.1,
    creep=1e-2,
    shear=2e-7,
    film=0.0,
    guide=2,
    radius=21.7e-3,
    clearance=0.15e-3,
    width=1.5e-3,
    viscosity=OIL,
    land_stiffness=3e8,
    wall=0.0,
    angle=0.7,
    ball_radius=BALL,
    ball_mass=2e-3,
)


def scene(pocket=3, push=(0.0, 0.0, 0.0), seed=0, tilt=0.0, **changes):
    """Return a cage, a ring and a ball, all in motion. The ball is displaced from the centre of a
    pocket by `push` (m, along circle, axis and radius)."""
    draw = np.random.default_rng(seed)
    lean = Rotation.from_rotvec([tilt * 0.6, -tilt * 0.8, 0.0])
    azimuth = CAGE["angle"] + CAGE["phase"] + 2 * np.pi * pocket / CAGE["pockets"]
    p = lean.apply([np.cos(azimuth), np.sin(azimuth), 0.0])
    e = lean.apply([0.0, 0.0, 1.0])
    x = draw.normal(size=3) * 1e-4
    at = x + p * (PITCH + push[2]) + np.cross(e, p) * push[0] + e * push[1]
    moving = {
        name: draw.normal(size=3) * size
        for name, size in dict(
            v=1e-2, w=80, ball_v=1e-2, ball_w=400, ring_v=1e-2, ring_w=50
        ).items()
    }
    ring = dict(ring_x=x + draw.normal(size=3) * 5e-5, ring_e=e)
    return CAGE | moving | ring | dict(x=x, e=e, ball_x=at) | changes


PUSHES = [(1.2, 0, 0), (-1.1, 0, 3), (0.8, 0.9, 0), (0, -1.3, -2), (-0.9, 0.7, 1)]


@pytest.mark.parametrize("spherical", [0, 1])
@pytest.mark.parametrize("push", PUSHES)
@pytest.mark.parametrize("tilt", [0.0, 0.02])
@pytest.mark.parametrize("wall, film", [(0.0, 0.0), (1e6, 0.0), (0.0, 2.8e-3)])
def test_a_pocket_keeps_angular_momentum_and_power(physics, push, tilt, spherical, wall, film):
    for seed in range(5):
        s = scene(4, np.array(push) * PLAY, seed, tilt, spherical=spherical, wall=wall, film=film)
        c = physics.call("cage_pocket", s)
        assert c.pocket == 4 and c.overlap > 0
        dry = physics.call("cage_pocket", s | dict(film=0.0))
        assert (np.linalg.norm(c.force - dry.force) > 0) == (film > 0)
        about_cage = np.cross(s["ball_x"] - s["x"], c.force) + c.ball_torque + c.cage_moment
        assert about_cage == pytest.approx([0, 0, 0], abs=1e-13 * (1 + np.linalg.norm(c.force)))
        # of the power that both bodies supply, F d(overlap)/dt is stored in a spring, and the
        # remainder is dissipated
        power = (
            np.dot(c.force, s["ball_v"] - s["v"])
            + np.dot(c.ball_torque, s["ball_w"])
            + np.dot(c.cage_moment, s["w"])
        )
        dv = s["ball_v"] - s["v"] - np.cross(s["w"], s["ball_x"] - s["x"])
        rate = -np.dot(dv, c.normal)
        stored = (wall * c.overlap if wall else s["stiffness"] * c.overlap**1.5) * rate
        assert power + c.loss + stored == pytest.approx(0, abs=1e-9 * abs(power) + 1e-15)


@pytest.mark.parametrize("along, across", [(PLAY, PLAY), (2 * PLAY, PLAY), (PLAY, 3 * PLAY)])
@pytest.mark.parametrize("spherical", [0, 1])
@pytest.mark.parametrize("wall", [0.0, 1e6])
def test_the_force_of_a_pocket_is_the_slope_of_its_energy(physics, along, across, spherical, wall):
    draw = np.random.default_rng(3)
    hits = 0
    for _ in range(40):
        push = draw.uniform(-1, 1, 3) * np.array([along, across, PLAY]) * 1.4
        still = {name: np.zeros(3) for name in ("v", "w", "ball_v", "ball_w")}
        rest = still | dict(friction=0.0, along=along, across=across, spherical=spherical)
        rest["wall"] = wall
        c = physics.call("cage_pocket", scene(2, push, tilt=0.01, **rest))
        hits += c.overlap > 0
        s, step = scene(2, push, tilt=0.01, **rest), 1e-9

        def energy(k, way, s=s):
            return physics.call(
                "cage_pocket", s | dict(ball_x=s["ball_x"] + way * np.eye(3)[k])
            ).energy

        slope = [(energy(k, -step) - energy(k, step)) / (2 * step) for k in range(3)]
        assert c.force == pytest.approx(slope, abs=1e-4 * (1e-3 + np.linalg.norm(c.force)))
    assert 10 < hits < 40


def test_a_wall_is_a_spring_with_a_damper_that_grows(physics):
    """The force is k x + 2 sqrt(k m) min(1, x/x_1) dx/dt, where x_1 is a fiftieth of half the
    clearance."""
    still = {name: np.zeros(3) for name in ("v", "w", "ball_w")}
    k, mass = 1e6, 2e-3 * 0.01 / (2e-3 + 0.01)
    for overlap, v in ((0.5e-6, 1e-2), (1e-6, -1e-3), (5e-6, 1e-2), (1e-6, -1.0)):
        s = scene(0, (PLAY + overlap, 0, 0), shear=0.0, friction=0.0, wall=k, **still)
        at_rest = physics.call("cage_pocket", s | dict(ball_v=np.zeros(3)))
        s["ball_v"] = -v * np.array(at_rest.normal)
        c = physics.call("cage_pocket", s)
        damper = 2 * np.sqrt(k * mass) * min(1.0, overlap / (0.02 * PLAY))
        assert c.overlap == pytest.approx(overlap, rel=1e-6)
        assert c.push == pytest.approx(max(k * overlap + damper * v, 0.0), rel=1e-6)


def test_friction_brakes_a_spinning_ball_with_its_coefficient(physics):
    still = {name: np.zeros(3) for name in ("v", "w", "ball_v")}
    s = scene(0, (1.5 * PLAY, 0, 0), shear=0.0, ball_w=np.array([0, 0, 400.0]), **still)
    c = physics.call("cage_pocket", s)
    along = c.force - np.dot(c.force, c.normal) * c.normal
    assert np.linalg.norm(along) == pytest.approx(0.1 * c.push, rel=1e-4)
    # friction acts opposite to the motion of the ball's surface
    assert np.dot(along, np.cross([0, 0, 1], -c.normal)) < 0
    assert c.ball_torque[2] == pytest.approx(-0.1 * c.push * BALL, rel=1e-4)


def test_a_ball_in_its_play_feels_oil_alone(physics):
    s = scene(1, (0.6 * PLAY, -0.5 * PLAY, PLAY))
    c = physics.call("cage_pocket", s)
    assert c.overlap < 0 and not c.force.any() and c.push == 0
    spin = s["ball_w"] - s["w"]
    assert c.loss == pytest.approx(-np.dot(c.ball_torque, spin)) and c.loss > 0
    none = physics.call("cage_pocket", s | dict(shear=0.0))
    assert not none.ball_torque.any() and none.loss == 0


@pytest.mark.parametrize("guide", [1, 2])
@pytest.mark.parametrize("off", [0.02, 0.4, 0.97, 1.2])
def test_a_land_keeps_power_and_its_slopes_are_those_of_its_force(physics, guide, off):
    for seed in range(4):
        s = scene(seed=seed, guide=guide, friction=0.0)
        way = np.array([0.6, -0.8, 0.0])
        s["ring_x"] = s["x"] - way * off * CAGE["clearance"] + np.array([0, 0, 1e-4])
        land = physics.call("cage_land", s)
        assert land.share == pytest.approx(off, abs=1e-9)
        d = s["x"] - s["ring_x"]
        power = np.dot(land.force, s["v"] - s["ring_v"] - np.cross(s["ring_w"], d)) + np.dot(
            land.moment, s["w"] - s["ring_w"]
        )
        out = np.dot(s["v"] - s["ring_v"] - np.cross(s["ring_w"], d), way)
        stored = CAGE["land_stiffness"] * max(0, off - 1) ** 1.5 * CAGE["clearance"] ** 1.5 * out
        assert power + land.loss + stored == pytest.approx(0, abs=1e-8 * abs(power) + 1e-12)
        assert (land.push > 0) <= (off > 1)
        for k, (name, step) in enumerate([("x", 1e-10), ("v", 1e-7)]):
            found = np.empty((2, 2))
            for axis in range(2):
                move = np.zeros(3)
                move[axis] = step
                # the ring does not spin here, so displacing it does not change any velocity
                still = s | dict(ring_w=np.zeros(3), w=s["w"] + s["ring_w"])
                ends = [
                    physics.call("cage_land", still | {name: still[name] + sign * move}).force[:2]
                    for sign in (-1, 1)
                ]
                found[:, axis] = (ends[0] - ends[1]) / (2 * step)
                slopes_still = physics.call("cage_land", still)
            slopes = np.reshape(slopes_still.moved if k else slopes_still.displaced, (2, 2))
            assert found == pytest.approx(slopes, rel=2e-3, abs=2e-3 * np.abs(slopes).max() + 1e-9)


def test_a_dry_land_rubs_where_it_touches(physics):
    """The drag acts on the far side of an inner land. The moments about one point cancel by
    construction, because the cage receives a force at its centre and a couple."""
    for guide, sign in ((2, 1), (1, -1)):
        zero = {n: np.zeros(3) for n in ("v", "ring_v", "ring_w")}
        s = scene(guide=guide, viscosity=0.0, w=np.array([0, 0, 80.0]), **zero)
        s["ring_x"] = s["x"] - np.array([1.05, 0, 0]) * CAGE["clearance"]
        land = physics.call("cage_land", s)
        assert land.force[0] == pytest.approx(-land.push)
        assert land.force[1] == pytest.approx(-sign * 0.1 * land.push, rel=1e-4)
        assert land.moment[2] == pytest.approx(
            -0.1 * land.push * (CAGE["radius"] - sign * 1.05 * CAGE["clearance"]), rel=1e-4
        )
        assert land.loss == pytest.approx(
            0.1 * land.push * 80 * (CAGE["radius"] - sign * 1.05 * CAGE["clearance"]), rel=1e-4
        )


def test_the_pocket_of_a_ball_is_the_nearest(physics):
    for pocket in range(9):
        for turns in (0.0, 7 * np.pi, -311.0):
            s = scene(pocket)
            azimuth = CAGE["angle"] + CAGE["phase"] + 2 * np.pi * pocket / 9
            s["angle"] = CAGE["angle"] + turns
            off = azimuth + turns + 0.2  # less than half the pocket spacing, 0.35 rad
            s["ball_x"] = s["x"] + PITCH * np.array([np.cos(off), np.sin(off), 0])
            assert physics.call("cage_pocket", s).pocket == pocket
