# SPDX-License-Identifier: GPL-2.0-or-later
"""Runs with the models `eyring`: their sliding against that of statics, which sums Eyring's stress
over each ellipse."""

from functools import partial

import numpy as np
import pytest
from host import ROOT, run, succeed
from raceway.runs.summary import summary
from raceway.runs.tables import RunTables
from raceway.theory import friction_torque, sliding, steady_heat, traction

OIL = {"rpm": 9549, "lubricant": "vg46", "temperature": 94.5}
# what pushes balls that would roll freely
PUSHED = {"without": "drag+rolling+rolling_hysteresis", "cage": "no"}


def one_speed(fluid, load, speed, h_c, a, b, r_x, r_d):
    """Power of free rolling in W as a run has it: one sliding speed for the whole ellipse."""
    rate = sliding.FREE_SPEED * sliding.edge_slip(speed, a, r_d, r_x) / h_c
    mu = traction.coefficient(
        fluid.viscosity,
        fluid.pressure_viscosity,
        1.5 * load / (np.pi * a * b),
        rate,
        fluid.eyring_stress,
        fluid.limiting_traction,
    )
    return sliding.free_power(load, mu, speed, a, r_d, r_x)


def of_statics(law=friction_torque._film_slip, phase=0.0):
    """Slip in W of balls that roll freely, the first one at the azimuth `phase`."""
    scene = steady_heat.Case("6208", "vg46", load=5000.0, rpm=9549.0).scene()
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(steady_heat, "turning", partial(steady_heat.turning, phase=phase))
        patch.setattr(friction_torque, "_film_slip", law)
        return scene.at(94.5, 0.0)["losses_W"]["slip"]


@pytest.fixture(scope="module")
def found(tmp_path_factory):
    """Slip of runs in W, by models; `free`: balls that nothing pushes."""
    result = {}
    runs = {"eyring": {}, "full": {}, "free": {"models": "eyring", **PUSHED}}
    for name, words in runs.items():
        folder = tmp_path_factory.mktemp(name)
        succeed("inputs/in.6208", out=folder, **{"models": name, **OIL, **words})
        result[name] = summary(RunTables(folder))["losses_W"]["slip"]
    return result


def test_sliding_is_that_of_statics(found):
    """9549 rpm: slip of a run against the quadrature of statics. They may differ by what pushes the
    balls of the run, by its one speed for the ellipse, and by the places of the balls."""
    passing = [of_statics(one_speed, phase) for phase in np.arange(4) * np.pi / 18]
    places = np.ptp(passing) / 2
    # balls that nothing pushes, with the law of the run: the places of the balls are left
    assert found["free"] == pytest.approx(np.mean(passing), rel=0, abs=places)
    statics = of_statics()
    apart = abs(found["eyring"] - found["free"]) + abs(passing[0] - statics) + places
    assert apart < 0.1 * statics
    assert found["eyring"] == pytest.approx(statics, rel=0, abs=apart)


def test_coulomb_slides_more(found):
    """`full` has Coulomb's law with 0.05 in place of Eyring's."""
    assert found["full"] > 1.8 * found["eyring"]


def test_dry_and_oil_without_the_numbers(tmp_path):
    """Dry it is `full`. An oil without an Eyring stress is refused."""
    short = {"passes": 1, "samples": 20, "rpm": 9549}
    succeed("inputs/in.dry", out=tmp_path / "dry", models="eyring", **short)
    oil = (ROOT / "inputs/lubricants/vg46").read_text()
    less = tmp_path / "less"
    less.write_text("\n".join(line for line in oil.splitlines() if "eyring_stress" not in line))
    done = run("inputs/in.6208", out=tmp_path / "x", models="eyring", lubricant=less, **short)
    assert done.code != 0 and "eyring_stress" in done.text
