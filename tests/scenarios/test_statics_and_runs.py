# SPDX-License-Identifier: GPL-2.0-or-later
"""Statics and settled runs with the same settings give the same equilibrium in random scenes.

In statics, the balls are at the azimuths of the run's last sample and orbit at the cage speed of
the run. Friction, which statics neglects, hinders balls that move across their grooves as they
orbit: in a 7205B under a radial load of 1 kN, a thrust of 500 N and a moment of 2 N m, it changes
loads by 4 % of the largest load. If rings tilt, friction is therefore reduced to a hundredth of its
value.
"""

import numpy as np
import pytest
import raceway
import xarray
from host import ROOT, succeed
from raceway import inputs
from raceway.theory import contact_friction, friction_torque, static
from raceway.theory.contact_law import FilmInGap
from raceway.theory.lubrication import lubricate, turning

BEARINGS = ("6208", "6306", "7205B", "7010AC")
FLUID = inputs.fluid(ROOT / "inputs/lubricants/vg46")


def scenes(seed=29):
    """Yield scenes for each bearing, with and without thrust; every second scene also has a
    moment."""
    draw = np.random.default_rng(seed)
    for thrust in (0.0, 1.0):
        for k, name in enumerate(BEARINGS):
            load, rpm = round(draw.uniform(500, 2000)), round(draw.uniform(300, 3000))
            moment = (0.0, round(draw.uniform(1, 10), 2)) if (k + thrust) % 2 else None
            axial = round(thrust * load * draw.uniform(0.5, 1.0))
            models = ("paper", "full")[draw.integers(2)]
            yield name, load, axial, moment, rpm, "paper" if moment else models


def little_friction(folder, models, moment):
    """Return `models`, or the paper's models with little friction if there is a `moment`."""
    if not moment:
        return models
    own = folder / "slippery"
    own.write_text("friction stribeck 0.0012 0.0005\n")
    return own


@pytest.mark.parametrize(("name", "load", "axial", "moment", "rpm", "models"), list(scenes()))
def test_loads_and_place(tmp_path, name, load, axial, moment, rpm, models):
    """The loads of all balls and the force on the ring agree within 1 % of the largest load, and
    the displacement of the ring agrees within 1 %."""
    words = dict(zip(("moment_x", "moment_y"), moment or ()))
    words |= dict(bearing=name, load=load, axial=axial, rpm=rpm, models=models, lubricant="vg46")
    words |= dict(load_azimuth=0, settle=30, passes=1, samples=20, overwrite="yes")
    words["models"] = little_friction(tmp_path, models, moment)
    succeed("inputs/in.6208", out=tmp_path / "run", **words)
    with xarray.open_dataset(tmp_path / "run/record.nc") as data:
        last = data.isel(time=-1, ring=0, bearing=0).load()
    path = ROOT / "inputs/bearings" / name
    rest = static.equilibrium(
        inputs.bearing(path),
        load,
        axial,
        moment=moment,
        held=inputs.held(path, axial) | ({} if moment else static.STRAIGHT),
        phase=np.arctan2(last["ball_y"], last["ball_x"]).to_numpy(),
        orbital_speed=float(last["bearing_cage_speed"]),
        finite_shift=True,
        film=FilmInGap(FLUID, rpm * np.pi / 30) if models == "full" else None,
    )
    found = last["load"].fillna(0).transpose("raceway", "ball").to_numpy()
    for side, contacts in zip(found, (rest.inner, rest.outer)):
        np.testing.assert_allclose(side, contacts.load, rtol=0, atol=0.01 * contacts.load.max())
    force = [float(last[f"ring_f{axis}"]) for axis in "xyz"]
    np.testing.assert_allclose(force, rest.force, rtol=0, atol=0.01 * np.hypot(load, axial))
    seat = inputs.held(path, 0.0)["z"]  # this is the origin of z in a run
    place = [float(last["ring_x"]), float(last["ring_z"]) + seat]
    np.testing.assert_allclose(place, rest.shift[[0, 2]], rtol=0.01, atol=1e-7)


def test_a_run_whose_ring_is_held_along_its_axis(tmp_path):
    """The summary states the force that holds the ring of a 7205B along its axis. If this force is
    applied as a load in the run, the ring need not be held."""
    words = dict(bearing="7205B", load=1000, rpm=3000, lubricant="vg46", settle=5, passes=1)

    def warnings(axial):
        succeed("inputs/in.6208", out=tmp_path / str(axial), axial=axial, samples=20, **words)
        found = raceway.open(tmp_path / str(axial)).summary()
        held = [one for one in found["warnings"] if "along its axis" in one]
        return held, round(-found["force_z_N"])

    (warning,), force = warnings(0)
    assert f" {force} N, and no load balances it" in warning
    assert warnings(force) == ([], pytest.approx(force, rel=0.01))


@pytest.mark.parametrize(
    ("name", "load", "axial", "rpm"),
    [
        ("6208", 4304, 4087, 376),
        ("6210", 1671, 1067, 2800),
        ("7205B", 0.1, 300, 8000),
        ("7205B", 870, 1740, 1500),
        ("7208B", 1065, 2130, 1000),
    ],
)
def test_torque(tmp_path, name, load, axial, rpm):
    """The friction torque of settled runs with the models `full` agrees within 1 %. This includes
    spin, and the starvation of a bearing whose file states diameters but no series. A chain has no
    losses that statics would have to include."""
    words = dict(bearing=name, load=load, axial=axial, rpm=rpm, models="full", lubricant="vg46")
    words |= dict(settle=60, passes=1, samples=20, cage="chain")
    succeed("inputs/in.6208", out=tmp_path, **words)
    with xarray.open_dataset(tmp_path / "record.nc") as data:
        run = -float(data["ring_torque"].isel(ring=0).mean())
    lost = losses(name, load, axial, rpm)
    assert abs(run) == pytest.approx(lost.power / (rpm * np.pi / 30), rel=0.01)


def losses(name, load, axial, rpm, temperature=40.0):
    oil = ROOT / "inputs/lubricants/vg46"
    fluid = inputs.fluid(oil, temperature)
    path, ring = ROOT / "inputs/bearings" / name, rpm * np.pi / 30
    body, film = inputs.bearing(path), FilmInGap(fluid, ring)
    rest, orbit = turning(body, ring, load, axial, finite_shift=True, film=film)
    films = lubricate(body, rest, inputs.oil(oil, temperature), ring, factor=film.factor)
    surfaces = contact_friction.surfaces(body, inputs.size(path), fluid, ring)
    return friction_torque.losses(body, rest, films, fluid, ring, orbit, surfaces=surfaces)


def test_balls_that_slide_under_their_gyroscopic_moment(tmp_path):
    """In a 7208B in hot oil, the balls slide across their grooves and use 0.9 of the available
    friction. This dissipates 13 times as much power as differential slip and spin. The loads from
    statics are 5 % higher, because the balance of forces does not include friction, and the orbital
    speed is 3 % lower."""
    scene = dict(axial=1100, rpm=10000)
    words = dict(bearing="7208B", load=0.1, models="full", lubricant="vg46", temperature=107)
    succeed("inputs/in.6208", out=tmp_path, settle=60, passes=1, samples=20, **words, **scene)
    with xarray.open_dataset(tmp_path / "record.nc") as data:
        slip, spin = (float(data[f"bearing_{part}_power"].mean()) for part in ("friction", "spin"))
    lost = losses("7208B", 0.1, **scene, temperature=107.0)
    assert lost.parts["slip"] == pytest.approx(slip, rel=0.1)
    assert lost.parts["spin"] == pytest.approx(spin, rel=0.05)
