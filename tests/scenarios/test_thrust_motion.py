# SPDX-License-Identifier: GPL-2.0-or-later
"""Under pure thrust, statics with friction and settled runs give the same motion of the balls, for
balls that friction holds and for balls that skid under their gyroscopic moment. The inner ring of
these runs is held in its plane."""

import numpy as np
import pytest
import xarray
from host import ROOT, succeed
from raceway import inputs
from raceway.theory import contact_friction, friction_torque, sliding, thrust_motion, validity
from raceway.theory.bearing import INNER
from raceway.theory.cage_drag import CageRing
from raceway.theory.contact_law import FilmInGap
from raceway.theory.lubrication import turning
from raceway.theory.operating_point import figures

INPUTS = ROOT / "inputs"


def moving(
    name, axial, rpm, temperature, models="full", cage=None, spin_law="closed", clearance=0.0
):
    path, oil, ring = INPUTS / "bearings" / name, INPUTS / "lubricants/vg46", rpm * np.pi / 30
    body, fluid = inputs.bearing(path), inputs.fluid(oil, temperature)
    film, density = FilmInGap(fluid, ring), inputs.ball_density(path)
    rest, _ = turning(body, ring, 0.0, axial, ball_density=density, film=film, clearance=clearance)
    assert thrust_motion.applies(body, rest)
    return thrust_motion.find(
        body,
        rest,
        inputs.oil(oil, temperature),
        fluid,
        film,
        contact_friction.surfaces(body, inputs.size(path), fluid, ring, models),
        density=density,
        cage=cage,
        spin_law=spin_law,
        clearance=clearance,
    )


@pytest.mark.parametrize("cage", [None, CageRing(), CageRing(land=(31e-3, 0.2e-3, 4e-3))])
@pytest.mark.parametrize("models", ["full", "eyring"])
@pytest.mark.parametrize("spin_law", friction_torque.SPIN_LAWS)
@pytest.mark.parametrize(
    ("name", "axial", "rpm", "temperature"),
    [
        ("7208B", 2130, 10000, 107),
        ("7208B", 426, -10000, 107),
        ("7205B", 20, 15000, 80),
        ("6208", -100, 10000, 60),
        ("6306", 7, 25000, 26),
    ],
)
def test_energy(name, axial, rpm, temperature, models, spin_law, cage):
    """Forces and moments of all balls and of the ring balance, and the power of the torque equals
    the sum of the losses, although both follow from different products of forces and speeds."""
    found = moving(name, axial, rpm, temperature, models, cage, spin_law)
    load, radius = (
        abs(axial) / len(found.state.azimuth),
        inputs.bearing(INPUTS / "bearings" / name).ball_radius,
    )
    assert np.all(np.abs(found.residual) < 1e-8 * load * np.array([1, 1, 1, 1, *3 * [radius]]))
    assert found.torque * abs(rpm) * np.pi / 30 == pytest.approx(found.losses.power, rel=1e-6)
    assert np.sign(found.orbit) == np.sign(rpm) == -np.sign(found.rotation[2])


def test_every_thrust_has_a_motion():
    """Between balls that skid and balls that friction holds there is a range of thrusts, 107 to 109
    N, in which either motion ends."""
    for axial in np.linspace(96, 114, 10):
        found = moving("7205B", axial, 8000, 70)
        assert np.all(np.abs(found.residual[:4]) < 1e-8 * axial)


def test_balance_of_a_skidding_ball():
    """In a 7208B under 426 N the balls slide across their grooves. Coulomb's law, summed over the
    points of both contact ellipses with vectors in three dimensions, gives forces and moments that
    balance the loads, the drag, the rolling resistance and the inertia of a ball in all six
    directions. The program treats a contact as flat: it neglects the square of the surface's slope,
    whose mean over the Hertz pressure is (a/R)^2/5."""
    found = moving("7208B", 426, 10000, 107, spin_law="slices")
    body = inputs.bearing(INPUTS / "bearings/7208B")
    radius, mass = body.ball_radius, 4 / 3 * np.pi * body.ball_radius**3 * 7800.0
    u, t, e = np.eye(3)
    turn, rho, orbit = found.rotation, found.place[0], found.orbit
    grid = (np.arange(80) + 0.5) / 40 - 1
    x, z = (one.ravel()[:, None] for one in np.meshgrid(grid, grid))
    pressure = np.sqrt(np.maximum(1 - x**2 - z**2, 0.0))
    force = mass * orbit**2 * rho * u - found.losses.drag[0] / (orbit * rho) * t
    moment = -0.4 * mass * radius**2 * orbit * np.array([-turn[1], turn[0], 0.0])
    rubbed = 0.0
    for k, (side, ring) in enumerate(
        zip((found.state.inner, found.state.outer), (10000 * np.pi / 30, 0.0))
    ):
        angle = side.angle[0] + np.pi * (k == INNER)
        normal = np.cos(angle) * u + np.sin(angle) * e
        across = np.cross(t, normal)
        depth = (z * side.a[0]) ** 2 / (2 * sliding.deformed_radius(body.groove(k), radius))
        arm = (radius - depth) * normal + x * side.b[0] * t + z * side.a[0] * across
        slide = orbit * rho * t + np.cross(turn, arm) - np.cross(ring * e, rho * u + arm)
        slide -= (slide @ normal)[:, None] * normal
        limit = found.losses.friction[k, 0] * side.load[0]
        friction = -limit * pressure / pressure.sum() * slide
        friction /= np.linalg.norm(slide, axis=1, keepdims=True)
        force += friction.sum(0) - side.load[0] * normal
        rolls = (turn - ring * e) @ across
        resisted = found.losses.rolling[k, 0] + found.losses.hysteresis[k, 0]
        moment += np.cross(arm, friction).sum(0) - resisted / rolls * across
        rubbed += limit
    flat = (max(found.state.inner.a[0], found.state.outer.a[0]) / radius) ** 2 / 5
    assert np.all(np.abs([*force, *moment / radius]) < flat * rubbed)
    assert abs(turn[1]) * radius > 0.1  # m/s, sliding across


def settled(folder, **words):
    """Return the record of a settled run under pure thrust."""
    succeed("tests/scenarios/in.thrust", out=folder, **words)
    with xarray.open_dataset(folder / "record.nc") as data:
        return data.load()


def rotations(data):
    """Return the mean orbital speed of the balls and their mean rotation about the radial
    direction, their path and the axis."""
    x, y, vx, vy, *turn = (
        data[f"ball_{one}"].values for one in ("x", "y", "vx", "vy", "omegax", "omegay", "omegaz")
    )
    rho = np.hypot(x, y)
    radial, along = (x * turn[0] + y * turn[1]) / rho, (x * turn[1] - y * turn[0]) / rho
    parts = (x * vy - y * vx) / rho**2, radial, along, turn[2]
    return np.array([one.mean() for one in parts])


MOTIONS = [
    ("7208B", 1500, 10000, 107, {}),  # friction holds the balls
    ("7208B", 1100, 10000, 107, {}),  # up to about 1000 N the balls skid
    ("7208B", 800, 10000, 107, {}),
    ("7208B", 426, 10000, 107, {}),
    ("7205B", 174, 10000, 107, {}),
    ("7208B", 426, 3000, 107, {}),  # held
    ("7208B", 426, 7000, 107, {}),
    ("7205B", 100, 9000, 107, {}),
    ("7205B", 100, 12000, 107, {}),
    ("7205B", 300, 8000, 70, {"models": "eyring"}),
    ("6208", 100, 10000, 107, {}),
    ("6208", 2000, 3000, 60, {}),
    ("6208", 300, 6000, 107, {"clearance": 30e-6}),  # larger contact angles
]


@pytest.mark.parametrize(
    ("name", "axial", "rpm", "temperature", "more", "cage"),
    [
        *((*motion, cage) for motion in MOTIONS for cage in ("chain", "ring")),
        ("7208B", 600, 10000, 107, {"spin_law": "slices"}, "chain"),
    ],
)
def test_motion_as_in_a_run(tmp_path, name, axial, rpm, temperature, more, cage):
    """Torque, orbital speed, rotation, loads and contact angles agree within 0.5 %, and the power
    of each part within 2 %. Statics leaves out the friction between balls and pockets, up to 8 % of
    the power at the cage."""
    words = dict(bearing=name, axial=axial, rpm=rpm, temperature=temperature, **more)
    run = settled(tmp_path, cage=cage, **words)
    body = CageRing() if cage == "ring" else None
    found = moving(name, axial, rpm, temperature, cage=body, **more)
    ring = rpm * np.pi / 30
    torque = -float(run["ring_torque"].isel(ring=0).mean())
    assert abs(torque) == pytest.approx(found.torque, rel=5e-3)
    motion = np.array([found.orbit, *found.rotation])
    np.testing.assert_allclose(rotations(run), motion, rtol=5e-3, atol=1e-4 * ring)
    load = run["load"].mean("time").transpose("raceway", "ball").values
    for side, contacts in zip(load, (found.state.inner, found.state.outer)):
        np.testing.assert_allclose(side, contacts.load, rtol=5e-3)
    angles = found.state.inner.angle.mean(), found.state.outer.angle.mean()
    assert float(np.abs(run["angle"]).mean()) == pytest.approx(np.mean(angles), rel=5e-3)
    for part, power in found.losses.parts.items():
        key = "friction" if part == "slip" else part
        run_power = float(run[f"bearing_{key}_power"].mean())
        within = 0.08 if part == "cage" else 0.02
        assert run_power == pytest.approx(power, rel=within, abs=2e-3 * found.losses.power)


@pytest.mark.parametrize("axial", [426, 600])
def test_cage_that_turns_off_centre(tmp_path, axial):
    """Balls that guide a cage ring leave it free to move by the play of its pockets. Under these
    thrusts and with slices, it turns off centre, so that its centrifugal load presses some pockets
    against balls. The friction there accounts for the difference from statics, which assumes a
    centred cage: without it, run and statics agree as in the test above, although the cage is
    still off centre. A cage of brass, three times as heavy, remains within the printed range."""
    words = dict(axial=axial, spin_law="slices")
    found = moving("7208B", rpm=10000, temperature=107, cage=CageRing(), **words)
    ring = 10000 * np.pi / 30

    def run(name, **cage):
        data = settled(tmp_path / name, cage="ring", **words, **cage)
        off = np.hypot(data["ring_x"], data["ring_y"]).isel(ring=-1)
        assert np.all(off > 50e-6)
        torque = -float(data["ring_torque"].isel(ring=0).mean())
        return torque / found.torque, float(data["bearing_cage_power"].mean())

    smooth, power = run("smooth", cage_friction=0)
    assert smooth == pytest.approx(1, rel=5e-3) and power == pytest.approx(
        found.losses.cage, rel=0.02
    )
    usual, power = run("usual")
    rubbed = power - found.losses.cage
    assert rubbed > 2  # W
    assert (usual - 1) * found.torque * ring == pytest.approx(rubbed, rel=0.2)
    assert usual < run("brass", cage_mass=0.08)[0] < 1 + validity.AGREES


def test_command():
    """`raceway static` reports this motion under pure thrust and under thrust with a negligible
    radial load, but not under combined loads."""
    point = dict(rpm=10000, temperature=107.0, held={"rx": 0.0, "ry": 0.0})
    wanted = moving("7208B", 426, 10000, 107)
    for load in (0.0, 0.01):
        one = figures("7208B", "vg46", INPUTS, load=load, axial=426, **point)
        assert one["friction_torque_N_m"] == pytest.approx(wanted.torque, rel=1e-6)
        assert one["orbital_speed_rad_s"] == pytest.approx(wanted.orbit, rel=1e-6)
        rotation = [one[f"ball_{name}_rad_s"] for name in ("radial", "along", "axial")]
        assert rotation == pytest.approx(wanted.rotation, rel=1e-6)
        assert any("free in its plane" in text for text in one["warnings"])
    one = figures("7208B", "vg46", INPUTS, load=200.0, axial=426, **point)
    assert "ball_radial_rad_s" not in one
