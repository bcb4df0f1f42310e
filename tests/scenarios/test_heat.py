# SPDX-License-Identifier: GPL-2.0-or-later
"""fix bearing/heat: the steady state agrees with `raceway heat`, heat and work are balanced, oil
and clearance follow the temperatures, and the cooling determines whether a preloaded bearing
seizes."""

import numpy as np
import pytest
import raceway
from host import refuses, succeed
from raceway import cage_drag, heat, heat_scene, steady_heat
from raceway.runs.summary_table import table

# the run settles until the energy stored in balls and cage drifts by less than the tolerances below
POINT = dict(lubricant="vg46", load=5000, rpm=1910, overwrite="yes", settled=1e-4, passes=10,
             models="full", settle="auto")  # fmt: skip
PARTS = ("inner", "balls", "outer")


@pytest.fixture(scope="module")
def warm(tmp_path_factory):
    """Return a run of the 6208 that starts cold and reaches its steady state."""
    folder = tmp_path_factory.mktemp("warm")
    succeed("inputs/in.6208", heat="yes", out=folder, **POINT)
    return raceway.open(folder)


def test_steady_state_is_that_of_raceway_heat(warm):
    case = dict(load=5000.0, rpm=1910.0, nodes=heat_scene.Nodes(), cage=cage_drag.CageRing())
    found = steady_heat.figures("6208", "vg46", **case)
    said = warm.summary()
    for part in PARTS:
        assert said[f"temperature_{part}_C"] == pytest.approx(
            found[f"temperature_{part}_C"], abs=0.1
        )
    assert said["temperature_oil_C"] == pytest.approx(found["temperature_C"], abs=0.1)
    assert said["clearance_warm_m"] == pytest.approx(found["clearance_warm_m"], abs=0.2e-6)
    assert said["viscosity_Pa_s"] == pytest.approx(found["viscosity_Pa_s"], rel=5e-3)
    assert [line.split()[0] for line in table(said).splitlines() if "°C  (" in line] == ["inner"]


def test_oil_that_flows(tmp_path):
    """The steady state agrees with `raceway heat` at the same oil flow. The oil carries away its
    heat capacity rate times its temperature rise; the remaining heat leaves through the housing. At
    this speed, the losses of the run are 0.6 % lower than those of statics, which changes the
    temperatures by 0.2 K."""
    oil = dict(oil_flow=0.5e-3 / 60, oil_inlet=45)
    words = POINT | dict(load=1000, rpm=9549, passes=1)
    succeed("inputs/in.6208", heat="yes", out=tmp_path, **oil, **words)
    ring = cage_drag.CageRing()
    case = dict(load=1000.0, rpm=9549.0, nodes=heat_scene.Nodes(), cage=ring, **oil)
    found, warm = steady_heat.figures("6208", "vg46", **case), raceway.open(tmp_path)
    said = warm.summary()
    for part in (*PARTS, "outlet"):
        key = f"temperature_{part}_C"
        assert said[key] == pytest.approx(found[key], abs=0.25)
    cooling, flow = heat.cooling(40.0, 80.0, 18.0), oil["oil_flow"] * 862.9 * 1950
    removed = cooling * (found["temperature_outer_C"] - 20) + found["oil_carried_W"]
    assert found["oil_carried_W"] == pytest.approx(flow * (found["temperature_outlet_C"] - 45))
    assert found["power_loss_W"] == pytest.approx(removed, rel=1e-3)
    end = warm.heat.isel(thermal_time=-1)
    carried = cooling * (end["temperature_outer"] - 20) + flow * (end["temperature_outlet"] - 45)
    assert float(end["power"]) == pytest.approx(float(carried), abs=0.05 * (cooling + flow))
    assert float(end["heat_oil"]) == pytest.approx(said["losses_W"]["drag"], rel=5e-3)
    assert float(end["booked"]) == pytest.approx(float(end["carried"] + end["stored"]), rel=1e-9)


def test_heat_balances(warm):
    """The heat from the losses is either stored or removed; in the steady state all of it is
    removed."""
    jumps = warm.heat
    booked, rest = jumps["booked"], jumps["carried"] + jumps["stored"]
    assert booked.to_numpy() == pytest.approx(rest.to_numpy(), rel=1e-9, abs=1e-9)
    made = np.diff(jumps["thermal_time"]) * (jumps["power"][1:] + jumps["power"][:-1].values) / 2
    assert float(made.sum()) == pytest.approx(float(booked[-1]), rel=1e-6)
    end = jumps.isel(thermal_time=-1)
    cooling = heat.cooling(40.0, 80.0, 18.0)
    carried = cooling * (float(end["temperature_outer"]) - 20.0)
    assert float(end["power"]) == pytest.approx(carried, abs=0.05 * cooling + 1e-3 * carried)


def test_work_of_the_drive_is_the_heat(warm, tmp_path):
    """Over the measured passes, the heat equals the torque of the inner ring times its speed, minus
    the increase in the kinetic energy of the balls, which the cage accelerates and slows. The
    iterations end when the torque at an instant equals the torque that moved the balls; with the
    default settings, these two torques differ by up to 1.3e-3."""
    succeed("inputs/in.6208", heat="yes", out=tmp_path, tolerance=1e-10, **POINT)
    fine = raceway.open(tmp_path)
    rings, balls, said = fine.rings, fine.balls, fine.summary()
    work = abs(float((rings["torque"] * rings["spin"]).mean()))
    mass, radius = fine.settings["ball_mass_kg"], fine.geometry.ball_radius
    moving = sum(
        0.5 * mass * balls[f"v{k}"] ** 2 + 0.2 * mass * radius**2 * balls[f"omega{k}"] ** 2
        for k in "xyz"
    ).sum("ball")
    gained = float(moving[-1] - moving[0]) / float(balls["time"][-1] - balls["time"][0])
    assert work - gained == pytest.approx(said["power_loss_W"], rel=2e-4)
    said = warm.summary()
    last = warm.heat["power"][-8:].to_numpy()  # the values for single ball passes scatter
    error = 3 * last.std(ddof=1) / np.sqrt(len(last)) + 1.3e-3 * said["power_loss_W"]
    assert last.mean() == pytest.approx(said["power_loss_W"], abs=error)


def test_the_contacts_run_at_these_temperatures(warm, tmp_path):
    """A run at the same oil temperature and with the same clearance has the same torque and
    films."""
    said = warm.summary()
    cold = {**POINT, "temperature": f"{said['temperature_oil_C']:.9g}"}
    succeed("inputs/in.6208", clearance=f"{said['clearance_warm_m']:.9g}", out=tmp_path, **cold)
    other = raceway.open(tmp_path).summary()
    for key in ("friction_torque_N_m", "h_min_m", "ring_shift_m", "capacitance_F"):
        assert said[key] == pytest.approx(other[key], rel=2e-3), key
    assert said["viscosity_Pa_s"] == pytest.approx(other["viscosity_Pa_s"], rel=1e-6)
    assert said["load_parameter"] == pytest.approx(other["load_parameter"], abs=2e-3)


def test_jumps_against_small_ones(tmp_path):
    """After a minute, temperatures that jump by up to 2 K agree within 0.1 K with those that jump
    by up to 0.25 K."""
    ends = []
    for change in (2, 0.25):
        words = dict(heat="yes", warm_time=60, warm_change=change, record="summary")
        succeed("inputs/in.6208", out=tmp_path, **words, **POINT)
        ends.append(raceway.open(tmp_path).heat.isel(thermal_time=-1))
        assert float(ends[-1]["thermal_time"]) == pytest.approx(60.0)
    for part in PARTS:
        one, other = (float(end[f"temperature_{part}"]) for end in ends)
        assert one == pytest.approx(other, abs=0.1)
    assert float(ends[0]["run_time"]) < 0.6


PRELOAD = dict(
    lubricant="dry",
    load=200,
    rpm=20000,
    clearance=-60e-6,
    cooling=20,
    passes=1,
    record="summary",
    models="full",
    settle="auto",
)


def test_preloaded_bearing_seizes_by_its_cooling(tmp_path):
    """If the outer ring around a hot inner ring is cooled, the bearing seizes; if the shaft is
    cooled, it does not."""
    words = dict(heat="yes", overwrite="yes", **PRELOAD)
    says = "it seizes. Losses grow with temperature"
    refuses("inputs/in.6208", says, out=tmp_path / "hot", **words)
    succeed("inputs/in.6208", out=tmp_path / "cold", shaft_cooling=50, **words)
    said = raceway.open(tmp_path / "cold").summary()
    assert said["heat_gain"] < 1 and said["temperature_inner_C"] < 40
    assert said["heat_booked_J"] == pytest.approx(
        said["heat_carried_J"] + said["heat_stored_J"], rel=1e-9
    )


@pytest.mark.parametrize(
    ("words", "says"),
    [
        ({"lubricant": "mineral"}, "has no data over temperature: take vg46"),
        ({"bearing": "harris209"}, "which determines the heat capacities of its rings"),
        ({"housing_capacity": 100}, "'housing_capacity' needs 'seat'"),
        ({"oil_inlet": 40}, "'oil_inlet' needs 'oil_flow'"),
        ({"oil_flow": 1e-5, "lubricant": "dry"}, "'oil_flow' needs oil, but bearing b is dry"),
        ({"load": 0.5, "rpm": 20000, "clearance": 2e-5}, "no ball of bearing b touched its inner"),
    ],
)
def test_errors(tmp_path, words, says):
    refuses("inputs/in.6208", says, out=tmp_path, heat="yes", **{**POINT, **words})
