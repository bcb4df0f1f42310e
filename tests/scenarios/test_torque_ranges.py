# SPDX-License-Identifier: GPL-2.0-or-later
"""The friction torque of settled runs under combined loads and moments is within the range that
statics states, in bearings with few and with many balls and contact angles of 15 to 40 degrees.

The scenes are extremes of random scenes, such as those that `tests/bench/torque_range.py` draws
(docs/static)."""

import json

import numpy as np
import pytest
from host import succeed
from raceway.theory import validity
from raceway.theory.cage_drag import CageRing
from torque_scenes import Scene, mean_torque, run_torque

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
# the cage is pushed sideways and wedges between balls that would have enough room otherwise
WEDGED = {
    "slow, light and hot": (25, 10, 39.2, 117.6, 0.053, 500, 80),
    "five balls": (15, 5, 122.82, 122.82, 0.3177, 1500, 100),
    "fourteen balls": (15, 14, 302.46, 100.82, 0.1987, 500, 60),
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
    every = {"pockets": POCKETS | WEDGED, "gyroscopic": GYROSCOPIC}
    every |= {"unloaded": UNLOADED, "": NONE}
    for kind, known in every.items():
        for name, scene in known.items():
            yield pytest.param(kind, scene, id=f"{kind or 'none'}: {name}")


@pytest.mark.parametrize(("kind", "scene"), list(scenes()))
def test_runs_are_in_the_range(tmp_path, kind, scene):
    restrained = scene in POCKETS.values()
    scene = Scene(*scene)
    succeed("inputs/in.6208", **scene.variables(tmp_path))
    torque = run_torque(tmp_path)
    found = scene.statics(tmp_path, CageRing())
    if restrained:  # without the losses of balls that the cage restrains, statics is worse
        loose = scene.statics(tmp_path, CageRing(play=1e-2))
        own, free = (abs(np.log(torque / mean_torque(one))) for one in (found, loose))
        assert own < free
    ends = [one["ranges"]["friction_torque_N_m"] for one in found]
    assert min(one["low"] for one in ends) <= torque <= max(one["high"] for one in ends)
    texts = json.dumps([one["warnings"] for one in found])
    assert ("times that of statics" in texts) == bool(kind)
    assert not kind or validity.TORQUE[kind].why in texts


@pytest.mark.parametrize("scene", POCKETS.values(), ids=POCKETS)
def test_pockets_that_do_not_rub(tmp_path, scene):
    """Without friction in the pockets, the power at the cage is that of its oil alone, and the slip
    of the balls that the cage restrains remains."""
    rough, smooth, loose = (
        Scene(*scene).statics(tmp_path, cage)[0]["losses_W"]
        for cage in (CageRing(), CageRing(without=frozenset(["friction"])), CageRing(play=1e-2))
    )
    assert rough["slip"] == smooth["slip"] > loose["slip"]
    assert rough["cage"] > smooth["cage"]
