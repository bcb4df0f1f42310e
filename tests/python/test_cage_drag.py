# SPDX-License-Identifier: GPL-2.0-or-later
"""The power losses of a cage ring in statics agree with the results of two independent programs,
and individual parts can be omitted."""

import math
from dataclasses import replace

import pytest
from commands import answer
from host import ROOT
from raceway import inputs
from raceway.sweeps import heat_runs
from raceway.theory import cage_drag, kinematics
from raceway.theory.lubricant import Fluid
from raceway.theory.operating_point import figures
from raceway.theory.steady_heat import Case

# 6205 at 1797 rpm with 0.04 Pa s; play 0.2 mm, 10 % oil around the cage
SPEED, ORBIT = 1797 * math.pi / 30, 74.954
NOTHING = [math.nan] * len(Fluid._fields)
FLUID = Fluid(*NOTHING)._replace(viscosity=0.04, density=870.0)
ALL = frozenset({"shear", "land", "churning"})
POWERS = {"shear": 0.387, "land": 0.218, "churning": 0.170e-3 * ORBIT}  # W


@pytest.fixture
def bearing():
    return inputs.bearing(ROOT / "inputs/bearings/6205")


def cage(bearing, *parts, inner=False):
    land = bearing.pitch_radius + (-0.28 if inner else 0.28) * bearing.ball_diameter
    return cage_drag.CageRing(2e-4, 1.0, (land, 2e-4, 3e-3), inner, ALL - set(parts))


def power(bearing, of, angle=0.0):
    orbit = float(kinematics.frequencies(bearing, angle, SPEED).cage)
    return cage_drag.power(bearing, of, FLUID, 0.1, SPEED, orbit, angle)


@pytest.mark.parametrize("part", POWERS)
def test_parts(bearing, part):
    """The reference values are given to three digits."""
    assert power(bearing, cage(bearing, part)) == pytest.approx(POWERS[part], rel=5e-3)


def test_land_of_the_inner_ring(bearing):
    """The cage rotates more slowly than the inner ring, and 0.250 W are dissipated at the land."""
    assert power(bearing, cage(bearing, "land", inner=True)) == pytest.approx(0.250, rel=5e-3)


def test_sum_and_nothing(bearing):
    parts = [power(bearing, cage(bearing, part)) for part in ALL]
    assert power(bearing, cage(bearing, *ALL)) == pytest.approx(sum(parts), rel=1e-12)
    assert power(bearing, cage(bearing)) == 0


def test_shear_at_a_contact_angle(bearing):
    """The ball's spin has a component about the axis of the pocket, for which the resistance is
    twice as large."""
    angle = 0.5
    flat, tilted = (power(bearing, cage(bearing, "shear"), a) for a in (0.0, angle))
    spins = [kinematics.frequencies(bearing, a, SPEED).spin for a in (0.0, angle)]
    share = (spins[1] / spins[0]) ** 2 * (1 + math.sin(angle) ** 2)
    assert tilted / flat == pytest.approx(share, rel=1e-12)


def test_torque_of_statics_has_the_cage():
    point = dict(load=5000.0, rpm=1910.0, temperature=40.0)
    ring = {"cage": cage_drag.CageRing()}
    whole, bare = (figures("6208", "vg46", **point, **more) for more in (ring, {}))
    lost = whole["losses_W"].pop("cage")
    assert whole["losses_W"] == bare["losses_W"]
    more = (whole["friction_torque_N_m"] - bare["friction_torque_N_m"]) * 1910 * math.pi / 30
    assert lost == pytest.approx(more, rel=1e-9) and lost > 0.1


def test_cage_of_the_commands(capsys, monkeypatch):
    """In the commands static and heat, a ring, the default, causes larger losses than a chain of
    balls, and the losses decrease as the play increases."""
    monkeypatch.chdir(ROOT)
    words = ["--load", "1000", "--rpm", "9549", "--lubricant", "vg32"]

    def found(command, *more):
        return answer(capsys, [command, *words, *more])

    cages = ["--cage", "chain"], ["--cage", "ring"], []
    losses = [found("static", *more)["losses_W"].get("cage", 0) for more in cages]
    wide = found("static", "--cage-play", "4e-4")
    one = figures("6208", "vg32", load=1000.0, rpm=9549.0, cage=cage_drag.CageRing(play=4e-4))
    assert losses[0] == 0 < wide["losses_W"]["cage"] < losses[1] == losses[2]
    assert wide["losses_W"]["cage"] == one["losses_W"]["cage"]
    hot = [found("heat", *more)["temperature_C"] for more in cages]
    assert hot[0] < hot[1] == hot[2]
    # as in the main deck, the default is a ring only with the models full
    assert "cage" not in found("static", "--models", "eyring")["losses_W"]


def test_runs_of_heat_have_the_same_cage(bearing):
    """The variables of the deck state the width of each land, whereas a `CageRing` has the total
    width of both lands."""
    case = Case("6205", "vg46", rpm=1800.0, cage=cage(bearing, "land", "churning", inner=True))
    found = heat_runs._variables(case, 40.0, 0.0, {})
    assert {name: found[name] for name in found if name.startswith("cage")} == {
        "cage": "ring",
        "cage_play": "0.0002",
        "cage_filled": "1",
        "cage_guide": "inner",
        "cage_land": f"{case.cage.land[0]:.10g}",
        "cage_clearance": "0.0002",
        "cage_width": "0.0015",
        "cage_without": "shear",
    }
    assert heat_runs._variables(replace(case, cage=None), 40.0, 0.0, {})["cage"] == "chain"
