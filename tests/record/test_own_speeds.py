# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of frequencies, ball passes and speeds that are computed from the motion of balls and rings
in a run with angular contact, rotation of either ring in either direction, or a changing speed."""

import numpy as np
import pytest
import raceway
import scenes
from host import deck_file, succeed
from raceway import losses, spectrum
from raceway.pictures import polar
from raceway.pictures.overview import torque_by_part
from raceway.runs.summary import summary

ANGULAR = dict(bearing="7205B", load=0.1, axial=300, rpm=8000, models="full", lubricant="vg46")
SWINGS = [  # changes to in.spall, in which the spin of the inner ring changes its direction
    (scenes.SPEED, "150\nvariable swing equal 150*cos(100*time)"),
    ("spin speed ${speed}", "spin speed v_swing"),
    ("run 2000", "run 1178"),
]
SCENES = ("angular", "ramp", "reversed", "outer", "both")


@pytest.fixture(scope="module", params=SCENES)
def run(request, tmp_path_factory):
    folder = tmp_path_factory.mktemp(request.param) / "run"
    if request.param == "angular":
        succeed("inputs/in.6208", out=folder, passes=6, samples=40, record="all", **ANGULAR)
    else:
        scenes.run(request.param, folder)
    return raceway.open(folder)


def angles(run):
    """Return (cage, inner, outer), the angles (time,) in rad through which the balls, on average,
    and the rings have rotated."""
    x, y = (run.balls[name].transpose("time", "ball").to_numpy() for name in "xy")
    cage = np.unwrap(np.arctan2(y, x), axis=0).mean(1)
    data = run.tables.record.read(["ring_angle"])["ring_angle"]
    sides = run.tables.record.fixed("ring_raceway")
    rings = [data[:, sides == k][:, 0] if k in sides else 0 * cage for k in (0, 1)]
    return [one - one[0] for one in (cage, *rings)]


def test_ball_passes_are_angles_of_the_cage(run):
    cage, _, _ = angles(run)
    passes = run.balls.sizes["ball"] * np.abs(cage) / (2 * np.pi)
    # the coordinate integrates speeds by the trapezoidal rule
    np.testing.assert_allclose(run.balls["passes"], passes, rtol=0, atol=1e-3 * passes[-1])


def test_lines_are_those_of_its_balls_and_rings(run):
    """FTF, BPFO, BPFI and the shaft line agree with the angles, and BSF with the spins of the balls
    relative to the cage, within 0.1 %."""
    (cage, inner, outer), balls = angles(run), run.balls.sizes["ball"]
    seconds = float(run.balls["time"][-1] - run.balls["time"][0])
    turned = [one[-1] / (2 * np.pi * seconds) for one in (cage, inner, outer)]
    spins = np.stack([run.balls[f"omega{k}"].transpose("time", "ball") for k in "xyz"])
    spins[2] -= (np.gradient(cage) / np.gradient(run.balls["time"].to_numpy()))[:, None]
    wanted = {
        "FTF": turned[0],
        "BPFO": balls * (turned[0] - turned[2]),
        "BPFI": balls * (turned[1] - turned[0]),
        "shaft": turned[1],
        "BSF": np.linalg.norm(spins, axis=0).mean() / (2 * np.pi),
    }
    found = spectrum.of_run(run, "vy")
    lines = {one.name: one for one in spectrum.lines(run, found, harmonics=1)}
    unit = abs(turned[1] - turned[2]) if "order" in found.dims else 1.0
    for name, hertz in wanted.items():
        if name == "shaft" and abs(hertz) < 1e-9:
            assert name not in lines
        else:
            assert lines[name].by_cage * unit == pytest.approx(abs(hertz), rel=1e-3), name


def test_rotation_of_balls_that_are_not_recorded(tmp_path):
    """A thrust causes a contact angle in a radial bearing. A record without contacts and balls, as
    in data sets, contains only the cage speed."""
    case = dict(axial=1000, load=300, clearance=30e-6, models="full", settle="auto")
    found = []
    for kind in ("all", "summary"):
        succeed("inputs/in.6208", out=tmp_path / kind, record=kind, passes=2, samples=40, **case)
        found.append(raceway.open(tmp_path / kind))
    whole, short = found
    (_, own), (_, told) = (spectrum.places(one, own=False)["BSF", 1] for one in found)
    assert np.isnan(short.motion.angle) and np.degrees(whole.motion.angle) > 10
    # BSF changes by a third of the change in cage speed, and the slip of the cage is below 1e-3
    assert told == pytest.approx(own, rel=3e-4)
    assert spectrum.contact_angle(short) == pytest.approx(whole.motion.angle, abs=np.radians(0.5))


def test_speed_at_the_largest_load(run):
    """The summary states the speed at the largest load and the range of speeds, also for a ramp."""
    figures = summary(run.tables)
    data = run.tables.record.read(["ring_spin"])["ring_spin"]
    sides = list(run.tables.record.fixed("ring_raceway"))
    speed = data[:, sides.index(0)] - (data[:, sides.index(1)] if 1 in sides else 0)
    rpm = np.abs(speed) * 30 / np.pi
    want = rpm[1:].min(), rpm[1:].max()  # the first sample precedes the measurement
    assert (figures["rpm_least"], figures["rpm_most"]) == pytest.approx(want, rel=1e-6)
    top = int(run.bearing["load_inner"].to_numpy().argmax())
    assert figures["rpm_top"] == pytest.approx(rpm[top], rel=1e-6)


def test_a_shaft_that_changes_its_direction(tmp_path):
    """The speed of 150 cos(100 t) rad/s is measured over 3/4 of a period. Means over it are those
    of the magnitude of the speed."""
    succeed(deck_file(tmp_path, scenes.changed("in.spall", SWINGS)), out=tmp_path / "run")
    run = raceway.open(tmp_path / "run")
    figures, kept = run.summary(), slice(1, None)
    speed = np.abs(run.rings["spin"].to_numpy())[kept]
    assert abs(float(run.rings["spin"].mean())) < 0.6 * speed.mean()
    assert figures["rpm"] == pytest.approx(speed.mean() * 30 / np.pi, rel=0.01)
    torque = figures["power_loss_W"] / speed.mean()
    assert figures["friction_torque_N_m"] == pytest.approx(torque, rel=1e-9)
    assert np.mean(losses.opposing_moment(run.tables)[kept] * speed) > 0.5 * figures["power_loss_W"]
    assert figures["passes"] == pytest.approx(float(run.rings["passes"][-1]), rel=0.01)


def test_the_torque_in_a_picture_is_that_at_its_time(run):
    """The power of all components is the torque times the speed at that time."""
    speed = np.abs(run.shaft_speed())
    names = [name for name in losses.losses(run).data_vars if name.endswith("_power")]
    power = sum(run.bearing[name].to_pandas().interpolate(limit_direction="both") for name in names)
    shown = sum(torque_by_part(run.tables).values())
    np.testing.assert_allclose(shown * speed, power, rtol=1e-9)


def test_pictures_show_statics_only_for_one_operating_point(run):
    """Statics has no changing speeds, turning outer rings and flaws, and its dots are those of
    radial bearings."""
    assert polar.theory(run.tables) == {}
