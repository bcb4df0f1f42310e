# SPDX-License-Identifier: GPL-2.0-or-later
"""The friction torque of settled runs under combined loads and moments is within the range that
statics states, in bearings with few and with many balls and contact angles of 15 to 40 degrees.

The bounds of `validity.TORQUE` were measured in 168 random scenes (docs/static); the scenes here
include the extremes of each kind."""

import json

import numpy as np
import pytest
import xarray
from host import ROOT, succeed
from raceway.theory import validity
from raceway.theory.ball_pass import places
from raceway.theory.cage_drag import CageRing
from raceway.theory.operating_point import figures

BEARING = """variable balls index {balls}
variable ball_diameter index 8.731e-3
variable pitch_diameter index 65e-3
variable inner_conformity index 0.52
variable outer_conformity index 0.53
variable contact_angle index {angle}
variable bore_diameter index 50e-3
variable outside_diameter index 80e-3
variable bearing_width index 16e-3
"""
# angle, balls, radial and axial load, moment, rpm, temperature
NONE = {
    "moment, hot oil": (15, 16, 165, 165, 0.08, 500, 100),
    "few balls": (25, 4, 50, 50, 0.0, 3000, 40),
    "combined 1:1": (25, 8, 772, 772, 0.0, 8000, 40),
    "combined 1:3": (40, 12, 279, 838, 0.0, 8000, 60),
}
POCKETS = {
    "light moment": (15, 4, 273, 273, 0.34, 500, 100),
    "high load": (25, 16, 2349, 2349, 2.66, 500, 100),
    "few balls": (25, 4, 401, 401, 0.76, 3000, 60),
    "six balls": (25, 6, 333, 333, 0.88, 3000, 40),
    "high speed": (25, 4, 423, 423, 1.26, 12000, 40),
}
GYROSCOPIC = {
    "1:3": (40, 16, 285, 855, 0.0, 12000, 100),
    "1:1": (25, 6, 174, 174, 0.0, 8000, 100),
}
UNLOADED = {
    # at a contact angle of 40 degrees, an unloaded ball climbs over its shoulder in some runs
    "two of four balls": (30, 4, 790, 263, 0.0, 8000, 100),
    "slow": (40, 4, 149, 50, 0.0, 1500, 40),
    "fast": (25, 6, 1185, 395, 0.0, 12000, 60),
}


def scenes():
    every = {"pockets": POCKETS, "gyroscopic": GYROSCOPIC, "unloaded": UNLOADED, "": NONE}
    for kind, known in every.items():
        for name, scene in known.items():
            yield pytest.param(kind, scene, id=f"{kind or 'none'}: {name}")


def data_file(folder, angle, balls):
    path = folder / "bearing"
    path.write_text(BEARING.format(angle=angle, balls=balls))
    return path


def statics(path, balls, load, axial, moment, rpm, temperature, cage):
    """Return the results of statics at four `places` of the balls."""
    return [
        figures(
            str(path),
            "vg46",
            ROOT / "inputs",
            load=load,
            axial=axial,
            moment=(0.0, moment),
            held={} if moment else {"rx": 0.0, "ry": 0.0},
            rpm=rpm,
            temperature=temperature,
            phase=phase,
            exact_circle=True,
            cage=cage,
        )
        for phase in places(balls, 4)
    ]


def mean_torque(found):
    return np.mean([one["friction_torque_N_m"] for one in found])


@pytest.mark.parametrize(("kind", "scene"), list(scenes()))
def test_runs_are_in_the_range(tmp_path, kind, scene):
    angle, balls, load, axial, moment, rpm, temperature = scene
    path = data_file(tmp_path, angle, balls)
    words = dict(bearing=path, lubricant="vg46", temperature=temperature, models="full")
    words |= dict(load=load, axial=axial, moment_y=moment, rpm=rpm, load_azimuth=0)
    out = tmp_path / "run"
    succeed("inputs/in.6208", out=out, settle="auto", passes=2 * balls, samples=40, **words)
    with xarray.open_dataset(out / "record.nc") as data:
        torque = -float(data["ring_torque"].isel(ring=0, time=slice(1, None)).mean())
    point = load, axial, moment, rpm, temperature
    found = statics(path, balls, *point, CageRing())
    if kind == "pockets":  # without the losses of balls that the cage restrains, statics is worse
        loose = statics(path, balls, *point, CageRing(play=1e-2))
        restrained, free = (abs(np.log(torque / mean_torque(one))) for one in (found, loose))
        assert restrained < free
    ends = [one["ranges"]["friction_torque_N_m"] for one in found]
    assert min(one["low"] for one in ends) <= torque <= max(one["high"] for one in ends)
    texts = json.dumps([one["warnings"] for one in found])
    assert ("times that of statics" in texts) == bool(kind)
    assert not kind or validity.TORQUE[kind].why in texts


@pytest.mark.parametrize("scene", POCKETS.values(), ids=POCKETS)
def test_pockets_that_do_not_rub(tmp_path, scene):
    """Without friction in the pockets, the power at the cage is that of its oil alone, and the slip
    of the balls that the cage restrains remains."""
    angle, balls, *point = scene
    path = data_file(tmp_path, angle, balls)
    rough, smooth, loose = (
        statics(path, balls, *point, cage)[0]["losses_W"]
        for cage in (CageRing(), CageRing(without=frozenset(["friction"])), CageRing(play=1e-2))
    )
    assert rough["slip"] == smooth["slip"] > loose["slip"]
    assert rough["cage"] > smooth["cage"]
