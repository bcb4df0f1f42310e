# SPDX-License-Identifier: GPL-2.0-or-later
"""Means over a ball pass: they do not depend on where the balls happen to be, and the few positions
that are solved represent many."""

import numpy as np
import pytest
from host import ROOT
from raceway import electric_point, inputs
from raceway.recordings.prediction import Model
from raceway.recordings.readings import Point, Reading, Readings
from raceway.theory import cage_speed
from raceway.theory.ball_pass import over, places
from raceway.theory.electric_point import Ask
from raceway.theory.steady_heat import Case

MANY = 24
# bearing, operating point, largest error of the power loss
SCENES = {
    "load": ("6208", dict(load=3000.0, rpm=1500.0), 5e-3),
    "few balls": ("6205", dict(load=100.0, rpm=3000.0, clearance=20e-6), 1e-2),
    "one or two balls": ("6205", dict(load=32.0, rpm=327.0, clearance=30e-6), 2e-2),
    "part of the balls": ("7208", dict(load=3709.0, axial=1488.0, rpm=651.0), 5e-3),
    "all balls": ("7208", dict(load=239.0, axial=212.0, rpm=1848.0), 3e-3),
    "thrust": ("7208", dict(axial=1000.0, rpm=1000.0), 1e-9),
}


@pytest.mark.parametrize("idle", [0, 4, 6])
def test_shares_and_sides(idle):
    """Each half of the ball pass is counted once, and without symmetry every position is solved."""
    loads = np.array([3.0, *(8 - idle) * [1.0], *idle * [0.0]])
    half = over(lambda phase: phase, 9, lambda _: loads)
    whole = over(lambda phase: phase, 9, lambda _: loads, symmetric=False)
    assert sum(share for share, _ in half) == pytest.approx(1)
    assert [one for _, one in half] == [one for _, one in whole][: len(whole) // 2 + 1]
    means = [sum(share * np.cos(9 * one) for share, one in each) for each in (half, whole)]
    assert means == pytest.approx([0, 0], abs=1e-12)
    assert over(lambda phase: phase, 9, lambda _: np.full((2, 9), 5.0)) == [(1.0, 0.0)]


@pytest.mark.parametrize("name", SCENES)
def test_heat_and_capacitance_are_means(name):
    bearing, point, within = SCENES[name]
    scene = Case(bearing, "vg46", ROOT / "inputs", **point).scene()
    at = 60.0, point.get("clearance", 0.0)
    phases = places(scene.bearing.balls, MANY)
    loss = [scene.figures([(1.0, scene.rest(*at, phase))])["power_loss_W"] for phase in phases]
    found = scene.at(*at)
    assert found["power_loss_W"] == pytest.approx(np.mean(loss), rel=within)
    assert sum(found["losses_W"].values()) == pytest.approx(found["power_loss_W"])
    assert sum(found["sides"]) + found["cage"] == pytest.approx(found["power_loss_W"])

    words = dict(point, temperature=60.0, models="full")
    whole = electric_point.solve(bearing, "vg46", **words)
    each = [electric_point.solve(bearing, "vg46", phase=phase, **words) for phase in phases]
    measured = np.mean([one.total() for one in each])
    assert whole.total() == pytest.approx(measured, rel=3e-3)
    figures = electric_point.figures(whole, Ask(measured=measured, frequency=1e6))
    assert figures["capacitance_total_F"] == whole.total()
    assert figures["measured_h_c_m"] == pytest.approx(figures["h_c_m"], rel=0.03)
    assert figures["impedance_ohm"] == pytest.approx(1 / (2e6 * np.pi * whole.total()), rel=1e-6)
    least = min(electric_point.figures(one)["threshold_V"] for one in each)
    assert figures["threshold_V"] == pytest.approx(least, rel=0.01)


def test_lines_are_means():
    """The cage rolls with all balls of a ball pass, not with those of one position."""
    bearing, point, _ = SCENES["part of the balls"]
    path, oil = (ROOT / "inputs" / kind for kind in (f"bearings/{bearing}", "lubricants/vg46"))
    at = Point(point["rpm"], point["load"], point["axial"], at=60.0)
    rows = [Reading(name, 1.0, 1e-4, at) for name in ("FTF", "BSF")]
    model = Model(Readings(path, oil, "full", {"clearance": 0.0}, {}, rows))
    scene = Case(bearing, "vg46", ROOT / "inputs", **point).scene()
    body = inputs.bearing(path)
    states = [scene.rest(60.0, 0.0, phase).state for phase in places(body.balls, MANY)]
    for one, of in zip(
        model.predict({"clearance": 0.0}), (cage_speed.order, cage_speed.ball_order)
    ):
        assert one.value == pytest.approx(np.mean([of(body, state) for state in states]), rel=3e-5)
