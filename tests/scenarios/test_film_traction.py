# SPDX-License-Identifier: GPL-2.0-or-later
"""The sliding losses of runs with the models `full` and `eyring` agree with statics."""

import numpy as np
import pytest
import raceway
from host import ROOT, succeed
from raceway.theory import skidding, steady_heat

OIL = {"rpm": 9549, "lubricant": "vg46", "temperature": 94.5}
# options that omit the parts of the model that prevent balls from rolling freely
PUSHED = {"without": "drag+rolling+rolling_hysteresis", "cage": "no"}


def of_statics(models, rotation=skidding.rotation):
    """Return (mean, half the range) of the slip loss in W over the positions of the balls."""
    scene = steady_heat.Case("6208", "vg46", load=5000.0, rpm=9549.0, models=models).scene()
    passing = []
    for phase in np.arange(4) * np.pi / 18:
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(skidding, "rotation", rotation)
            placed = [(1.0, scene.rest(94.5, 0.0, phase))]
            passing.append(scene.figures(placed)["losses_W"]["slip"])
    return np.mean(passing), np.ptp(passing) / 2


@pytest.fixture(scope="module")
def found(tmp_path_factory):
    """Return {models: slip loss of the run in W}; in runs with `free` in the name, only traction
    drives the balls."""
    result = {}
    for models in ("full", "eyring"):
        for name, words in ((models, {}), (f"free {models}", PUSHED)):
            folder = tmp_path_factory.mktemp("run")
            succeed("inputs/in.6208", out=folder, models=models, **OIL, **words)
            result[name] = raceway.open(folder).summary()["losses_W"]["slip"]
    return result


@pytest.mark.parametrize("models", ["full", "eyring"])
def test_sliding_is_that_of_statics(found, models):
    """At 9549 rpm without drag, rolling resistance and cage, the sliding loss of a run lies within
    the range of statics over the positions of the balls; with all parts it agrees within 5 %."""
    statics, places = of_statics(models, lambda slowing, rate, time: 1.0)
    within = places if models == "eyring" else 1e-2 * statics
    assert found[f"free {models}"] == pytest.approx(statics, rel=0, abs=within)
    assert found[models] == pytest.approx(of_statics(models)[0], rel=0.05)


def test_coulomb_slides_more(found):
    assert found["full"] > 1.8 * found["eyring"]


def test_dry_and_oil_without_the_numbers(tmp_path):
    """For dry contacts, `eyring` is equivalent to `full`. If an oil has no Eyring stress, the
    default value is used."""
    short = {"passes": 1, "samples": 20, "rpm": 9549}
    succeed("inputs/in.dry", out=tmp_path / "dry", models="eyring", **short)
    oil = (ROOT / "inputs/lubricants/vg46").read_text()
    less = tmp_path / "less"
    less.write_text("\n".join(line for line in oil.splitlines() if "eyring_stress" not in line))
    succeed("inputs/in.6208", out=tmp_path / "x", models="eyring", lubricant=less, **short)
    assert raceway.open(tmp_path / "x").settings["assumed_data"] == "eyring_stress=5.0e6"
