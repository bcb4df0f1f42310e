# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of the variable `without`, which lists parts of the models to be omitted from a run."""

import shutil

import pytest
from host import ROOT, refuses, succeed
from raceway.errors import RunError
from raceway.runs.run import Run

SCENE = {"passes": 1, "samples": 20, "lubricant": "vg46", "load": 2000, "models": "full"}
# {part: loss in the summary that is 0 if the part is omitted}
LOSSES = {"rolling": "rolling", "rolling_hysteresis": "hysteresis", "drag": "drag"}
# {part: (words that are removed from the pair style, words that remain if the part is omitted)}
WORDS = {
    "gap": ("gap 1", "rolling_hysteresis 0.01"),
    "film_branch": ("film_damping branch", "gap 1"),
    "inlet_shear": ("inlet_shear", "gap 1"),
    "asperities": ("mixed 0.12", "mixed 0.05 0.05"),
    "differential_slip": ("heathcote", "smoothed 0.01"),
    "spin": ("spin 1", "spin 0"),
}


def commands(folder):
    return Run(folder).tables.record.attrs["pair_commands"]


@pytest.mark.parametrize("part", WORDS)
def test_words(tmp_path, part):
    gone, there = WORDS[part]
    succeed("inputs/in.6208", out=tmp_path, without=part, **SCENE)
    assert gone not in commands(tmp_path) and there in commands(tmp_path)
    assert f"without={part}" in Run(tmp_path).settings["deck_variables"]


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    folder = tmp_path_factory.mktemp("whole")
    succeed("inputs/in.6208", out=folder, **SCENE)
    return Run(folder).summary()


def test_losses_that_are_gone(tmp_path, whole):
    """The losses of the omitted parts are 0, and the slip loss changes by less than 10 %."""
    succeed("inputs/in.6208", out=tmp_path, without="+".join(LOSSES), **SCENE)
    losses = Run(tmp_path).summary()["losses_W"]
    for loss in LOSSES.values():
        assert whole["losses_W"][loss] > 1e-3 and losses[loss] == 0, loss
    assert losses["slip"] == pytest.approx(whole["losses_W"]["slip"], rel=0.1)


def test_no_cage(tmp_path, whole):
    """Without a cage, the balls still move and carry the load."""
    succeed("inputs/in.6208", out=tmp_path, cage="no", **SCENE)
    bare = Run(tmp_path)
    found = bare.summary()
    with pytest.raises(RunError, match="no cage balls"):
        bare.cage
    assert whole["losses_W"]["cage"] > 0 == found["losses_W"]["cage"]
    assert found["force_y_N"] == pytest.approx(whole["force_y_N"], rel=1e-3)
    assert "cage=no" in bare.settings["deck_variables"]


def test_starvation(tmp_path, whole):
    """Two effects reduce the rolling couple: SKF's starvation factor (10000 EN, 2013), and the
    limited inlet in a groove, which leaves at least half of the couple. If `starvation` is omitted,
    the factor is 1 and the inlet is flooded."""
    succeed("inputs/in.6208", out=tmp_path / "flooded", without="starvation", **SCENE)
    succeed("inputs/in.6208", out=tmp_path / "starved", **SCENE)
    nu = 1e6 * whole["viscosity_Pa_s"] / 858  # mm2/s; vg46 at 40 C
    factor = 2.718281828 ** (-3e-8 * nu * 477.5 * 120 * (1.55 / 40) ** 0.5)
    starved, flooded = (commands(tmp_path / name) for name in ("starved", "flooded"))
    found = float(starved.split(" rolling ")[1].split()[2])
    assert found == pytest.approx(factor, rel=2e-3) and "rolling_inlet 3" in starved
    assert float(flooded.split(" rolling ")[1].split()[2]) == 1 and "rolling_inlet" not in flooded
    losses = [
        Run(tmp_path / name).summary()["losses_W"]["rolling"] for name in ("starved", "flooded")
    ]
    assert 0.5 * factor < losses[0] / losses[1] < factor


def test_mistakes(tmp_path):
    for words, says in (
        ({"without": "drag+spinn"}, "there is no part 'spinn' to leave out"),
        ({"without": "+drag"}, "there is no part '' to leave out"),
        ({"without": "spin", "models": "film"}, "there is: gap film_branch inlet_shear"),
        ({"without": "spin", "models": "paper"}, "there is no part 'spin' to leave out"),
        ({"without": "drag", "lubricant": "dry"}, "there is: rolling_hysteresis spin"),
        ({"without": "differential_slip", "spin_law": "slices"}, "spin_law slices needs the part"),
    ):
        refuses("inputs/in.6208", says, out=tmp_path / "run", **{**SCENE, **words})


def test_models_of_ones_own(tmp_path):
    """Models defined by a user have no named parts, so none can be omitted."""
    inputs = tmp_path / "inputs"
    shutil.copytree(ROOT / "inputs", inputs)
    (inputs / "models").mkdir()
    (inputs / "models" / "mine").write_text("friction constant 0.07\n")
    words = {**SCENE, "inputs": inputs, "models": "mine", "out": tmp_path / "run"}
    succeed("inputs/in.6208", **words)
    assert "friction constant 0.07" in commands(tmp_path / "run")
    says = "there is no part 'drag' to leave out"
    refuses("inputs/in.6208", says, without="drag", overwrite="yes", **words)
