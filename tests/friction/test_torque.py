# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of the friction torque of a 6208 with the models `full`, part by part against statics, and
as a whole against SKF's formula. No constant has been fitted."""

import numpy as np
import pytest
import raceway
from host import ROOT, succeed
from raceway.theory.operating_point import figures


@pytest.mark.parametrize("rpm", [477.5, 1910, 9549])
def test_torque(tmp_path, rpm):
    """At 5 kN and 0.04 Pa s, the friction torque is within 35 % of the value from SKF's formula."""
    succeed("inputs/in.6208", out=tmp_path, models="full", rpm=rpm, passes=2)
    run = raceway.open(tmp_path).summary()
    point = {"load": 5000.0, "rpm": rpm, "models": "full"}
    still = [
        figures("6208", "mineral", ROOT / "inputs", phase=phase, **point)["losses_W"]
        for phase in np.arange(4) * np.pi / 18
    ]
    assert run["friction_torque_N_m"] == pytest.approx(run["torque_skf_N_m"], rel=0.35)
    for part in ("rolling", "slip", "hysteresis", "drag"):
        over_a_pass = np.mean([one[part] for one in still])
        assert run["losses_W"][part] == pytest.approx(over_a_pass, rel=0.02), part


def test_torque_is_steady(tmp_path):
    """At 9549 rpm, the torque depends neither on the time at which it is measured nor on the
    tolerance. Means over two ball passes scatter by half a per cent."""
    torques = []
    for settle, tolerance in ((1, 1e-9), (40, 1e-9), (1, 1e-10)):
        succeed(
            "inputs/in.6208",
            out=tmp_path,
            overwrite="yes",
            models="full",
            rpm=9549,
            settle=settle,
            passes=2,
            tolerance=tolerance,
        )
        torques.append(raceway.open(tmp_path).summary()["friction_torque_N_m"])
    early, late, finer = torques
    assert early == pytest.approx(late, rel=7e-3)
    assert finer == pytest.approx(early, rel=1e-4)
