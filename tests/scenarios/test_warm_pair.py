# SPDX-License-Identifier: GPL-2.0-or-later
"""docs/decks/in.warm_pair: depending on its cooling, a preloaded pair of 7205Bs warms up or seizes.
The balance of heat and expansion of one bearing with a held inner ring predicts which."""

import numpy as np
import pytest
from host import ROOT, run, succeed
from raceway import inputs, steady_heat
from raceway.errors import NoEquilibrium
from raceway.theory.static import STRAIGHT

SPREAD, RPM, COOLING, SHAFT = 20e-6, 18000.0, 3.0, 5.0
PARTS = ("inner", "balls", "outer")


def rest(shaft):
    """Return the steady results of one bearing of the pair, with its outer ring displaced by the
    spread."""
    path, oil = ROOT / "inputs/bearings/7205B", ROOT / "inputs/lubricants/vg32"
    held = STRAIGHT | {"z": inputs.held(path, 0.0, 0.0)["z"] + SPREAD}
    scene = steady_heat.Scene(
        inputs.bearing(path), None, inputs.lubricant(oil), inputs.oil(oil).roughness, 0.0, 0.0,
        RPM, inputs.ball_density(path), held=held, size=inputs.size(path),
    )  # fmt: skip
    nodes = steady_heat.Nodes(shaft=shaft, housing=COOLING)
    return scene, steady_heat.three_nodes(scene, nodes, 20.0, 0.0)


def jumps(folder):
    """Return the columns of the table of fix bearing/heat, by name."""
    file = folder / "heat.txt"
    names = file.read_text().split("\n", 1)[0].removeprefix("#").split()
    return dict(zip(names, np.loadtxt(file, ndmin=2).T))


def energy(table, shaft):
    """Return (heat from the losses, heat removed and stored) in J, from temperatures and losses in
    the rows alone."""
    step = np.diff(table["thermal_time"])

    def mean(values):
        return (values[1:] + values[:-1]) / 2

    made = (step * mean(table["power"])).sum()
    carried = step * (
        COOLING * mean(table["temperature_outer"] - 20)
        + shaft * mean(table["temperature_inner"] - 20)
    )
    return made, carried.sum() + table["stored"][-1]


def test_a_cooled_pair_is_steady(tmp_path):
    """Temperatures agree within 1.2 K with the balance in statics. The losses of a run are 1 %
    higher, because its balls orbit faster under their gyroscopic moment, and 2 % of 50 K is 1 K."""
    succeed("docs/decks/in.warm_pair", out=tmp_path)
    table = jumps(tmp_path)
    _, found = rest(SHAFT)
    for part in PARTS:
        end = table[f"temperature_{part}"][-1]
        assert end == pytest.approx(found[f"temperature_{part}_C"], abs=1.2), part
    assert table["power"][-1] == pytest.approx(found["power_loss_W"], rel=0.02)
    assert table["clearance"][-1] == pytest.approx(found["clearance_warm_m"], abs=0.6e-6)
    made, spent = energy(table, SHAFT)
    assert made == pytest.approx(table["booked"][-1], rel=1e-6)
    assert made == pytest.approx(spent, rel=1e-3)
    assert table["booked"][-1] == pytest.approx(
        table["carried"][-1] + table["stored"][-1], rel=1e-9
    )


def test_without_cooling_of_the_shaft_it_seizes(tmp_path):
    """Statics has no steady state below 200 C either. The inner rings become hotter than the outer
    rings, so the clearance falls and the losses rise, whereas hotter oil alone would reduce the
    losses."""
    with pytest.raises(NoEquilibrium, match="no steady temperature up to 200 C"):
        rest(0.0)
    done = run("docs/decks/in.warm_pair", out=tmp_path, shaft_cooling=0)
    assert done.code != 0
    assert "it seizes. Losses grow with temperature" in done.error
    table = jumps(tmp_path)
    assert table["gain"][-1] > 1 and table["clearance"][-1] < -10e-6
    late = table["temperature_oil"] > 150
    assert np.polyfit(table["temperature_oil"][late], table["power"][late], 1)[0] > 0
    made, spent = energy(table, 0.0)
    assert made == pytest.approx(spent, rel=1e-3)
