# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of `raceway needs` with the real program: the settings that it recommends for random scenes
are compared with separate runs."""

import json
import random
import shlex

import pytest
from commands import reply
from host import ROOT, succeed
from raceway import core
from raceway.cli import main
from raceway.runs.run import Run
from raceway.sweeps import scene_parts
from raceway.sweeps.needs import Outcome, _cheapest
from raceway.sweeps.points import deck_variables
from raceway.sweeps.scene_parts import REFERENCE, choices, sets, variables

SEED = 16
SHORT = {"passes": "1", "settle": "1"}
WANTED = {"torque": 0.1, "capacitance": 0.05, "load": 0.01}
# options that are kept in the second scene in order to save time
FEW = ["asperities", "differential_slip", "drag", "inlet_shear", "record", "rolling", "samples"]
FEW += ["rolling_hysteresis", "film_branch", "spin", "damping", "relative 5e-4", "starvation"]
FEW += ["cage"]


def scene(number):
    """Return the variables of a random scene: load, speed, clearance, oil and temperature."""
    draw = random.Random(100 * SEED + number)
    return {
        **SHORT,
        "load": f"{10 ** draw.uniform(2.7, 3.9):.4g}",
        "rpm": f"{10 ** draw.uniform(2.3, 3.5):.4g}",
        "clearance": f"{(-1) ** number * draw.uniform(1e-6, 1e-5):.3g}",
        "lubricant": draw.choice(["vg32", "vg68", "pao8"]),
        "temperature": f"{draw.uniform(30, 80):.3g}",
    }


def words(variables):
    return [word for name, value in variables.items() for word in ("-var", name, value)]


@pytest.fixture(scope="module", params=[(0, []), (1, ["--keep", *FEW])], ids=["all", "few"])
def answered(request, tmp_path_factory):
    """Return (scene, output of raceway needs, folder that contains the output)."""
    number, keep = request.param
    folder = tmp_path_factory.mktemp("needs")
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(ROOT)
        own = scene(number)
        assert main(["needs", "inputs/in.6208", *words(own), *keep, "--out", str(folder)]) == 0
    return own, json.loads((folder / "needs.json").read_text()), folder


@pytest.fixture
def undrawn(monkeypatch):
    """Run from the root without drawing the picture, which takes a second and is already drawn in
    `answered`."""
    monkeypatch.chdir(ROOT)
    monkeypatch.setattr("raceway.pictures.needs.picture", lambda found, path: None)


def figures(folder):
    return scene_parts.figures(Run(folder).summary())


def test_picked_set_keeps_what_is_wanted(answered, tmp_path):
    """Two runs are started by hand: one of the full model, with finer settings than the reference
    run of the command, and one with the settings that the command recommends."""
    own, found, _ = answered
    assert found["wanted"] == WANTED
    finer = {**REFERENCE, "tolerance": "1e-11", "samples": 500}
    whole = found["scene"]
    assert whole == {"surroundings": "flooded", "cage": "ring", **own}
    succeed("inputs/in.6208", out=tmp_path / "exact", **{**whole, **finer})
    succeed("inputs/in.6208", out=tmp_path / "picked", **{**whole, **found["words"]})
    exact, picked = figures(tmp_path / "exact"), figures(tmp_path / "picked")
    for word, most in WANTED.items():
        assert abs(picked[word] / exact[word] - 1) <= most, word
        assert found["best"]["errors"][word] <= most, word
    # the processor times of these short runs decide among tolerances; the finest takes a third
    assert found["best"]["evaluations"] < 0.35
    times = found["processor_s"]  # three separate runs for each set
    assert {len(one) for one in times.values()} == {3}
    assert not set(times["reference"]) & set(times["picked"])
    assert (Run(tmp_path / "picked").settings["evaluations"]) == pytest.approx(
        found["best"]["evaluations"] * reference(answered)["evaluations"], rel=1e-9
    )


def test_warnings_of_the_reference(undrawn, tmp_path, capsys):
    """The warnings are those of the reference run, here for a 7205B under a purely radial load with
    one part that may be omitted."""
    own = words({**SHORT, "bearing": "7205B", "load": "1000", "rpm": "3000"})
    keep = sorted({one.name for one in choices({}, True)} - {"drag"})
    assert main(["needs", "inputs/in.6208", *own, "--keep", *keep, "--out", str(tmp_path)]) == 0
    (warning,) = json.loads((tmp_path / "needs.json").read_text())["warnings"]
    assert "along its axis" in warning and warning in capsys.readouterr().out


def reference(answered):
    own, _, folder = answered
    for point in folder.glob("*/summary.json"):
        asked = (point.parent / "run.yaml").read_text()
        words = (
            "tolerance=1e-10",
            "samples=400",
            ",without=none",
            "cage=ring",
            "cage_without=none",
        )
        if all(word in asked for word in (*words, "surroundings=flooded")):
            found = json.loads(point.read_text())
            if found["models"] == "full" and found["integrator"] == "implicit":
                return found
    raise AssertionError("no reference")


def test_effects_are_those_of_the_runs(answered, tmp_path):
    own, found, _ = answered
    rows = {row["names"][0]: row for row in found["single"]}
    succeed("inputs/in.6208", out=tmp_path, **found["scene"], **REFERENCE, without="gap")
    exact, without = scene_parts.figures(reference(answered)), figures(tmp_path)
    assert list(exact) == list(scene_parts.FIGURES)
    for word, value in exact.items():
        assert rows["gap"]["errors"][word] == pytest.approx(
            abs(without[word] / value - 1), rel=1e-9, abs=1e-12
        )
    # the capacitance of the ellipses alone is far from the total, but motion and films do not
    # depend on the difference
    errors = rows["surroundings"]["errors"]
    assert errors["capacitance"] > 0.1
    assert {value for word, value in errors.items() if word != "capacitance"} == {0.0}
    assert rows["models paper"]["errors"]["torque"] is None  # this model has no friction torque


def test_goes_on_without_running_again(answered, capsys, undrawn):
    own, found, folder = answered
    before = {path: path.stat().st_mtime_ns for path in folder.glob("*/run.yaml")}
    assert len(before) > 5 and (folder / "needs.png").stat().st_size > 20000
    capsys.readouterr()
    keep = [] if len(found["single"]) > len(FEW) else ["--keep", *FEW]
    assert main(["needs", "inputs/in.6208", *words(own), *keep, "--out", str(folder)]) == 0
    assert {path: path.stat().st_mtime_ns for path in folder.glob("*/run.yaml")} == before
    said = capsys.readouterr().out
    assert shlex.split(said.strip().splitlines()[-1]) == words({**found["scene"], **found["words"]})


def test_wants_that_forbid_everything(answered, undrawn):
    """If no part may be omitted, the reference is chosen. Friction of the cage has no effect if its
    films keep all balls off the walls; it may then be omitted."""
    own, _, folder = answered
    tight = ["--want", "torque=1e-9", "capacitance=1e-9", "--keep", *FEW]
    assert main(["needs", "inputs/in.6208", *words(own), *tight, "--out", str(folder)]) == 0
    found = json.loads((folder / "needs.json").read_text())
    without_effect = {
        row["names"][0]
        for row in found["single"]
        if all(row["errors"][word] == 0 for word in ("torque", "capacitance"))
    }
    assert set(found["best"]["names"]) <= without_effect <= {"cage friction"}
    assert {**found["words"], "cage_without": ""} == {**REFERENCE, "cage_without": ""}
    assert not {row["names"][0] for row in found["single"]} & set(FEW)


def test_mistakes(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(ROOT)
    for more, says in (
        (["--want", "torqu=1%"], "must be FIGURE=ERROR"),
        (["--want", "torque=0%"], "the error must be above 0 and at most 100%"),
        (["-var", "tolerance", "1e-8"], "-var tolerance is set by raceway needs; leave it out"),
        (["-var", "without", "drag"], "-var without is set by raceway needs; leave it out"),
        (["-var", "load", "5 6"], "must be one word or number"),
        (["-var", "lode", "5"], "inputs/in.6208 has no variable 'lode'; did you mean load"),
        (["--keep", "drags"], "--keep drags: unknown; known:"),
        (["--program", "nowhere/x"], "there is no program 'nowhere/x'"),
        (["-var", "load", "1e9"], "the scene with every part of the model: bearing: load"),
    ):
        assert main(["needs", "inputs/in.6208", *more, "--out", str(tmp_path)]) == 1, more
        assert says in capsys.readouterr().err, more
    assert "inputs/in.many has no variable" in reply(
        capsys, ["needs", "inputs/in.many", "--out", str(tmp_path)], code=1
    )


def test_sets():
    """A set contains at most one part from each group, and only parts that its models have."""
    known = choices({}, True)
    every = sets([one for one in known if one.name not in ("cage", "surroundings", "spin")])
    names = [{choice.name for choice in picked} for picked in every]
    assert len({frozenset(one) for one in names}) == len(names)
    assert {"gap", "drag", "tolerance 1e-8", "samples 40"} in names
    for one in names:
        assert len(one & {"tolerance 1e-9", "tolerance 1e-8", "damping"}) < 2
        assert not ("models paper" in one and one & {"gap", "drag", "inlet_shear"})
        assert not ("models film" in one and "drag" in one)
    assert {"models film", "inlet_shear"} in names
    picked = tuple(one for one in known if one.name in ("gap", "drag", "samples 40"))
    assert variables(picked) == {**REFERENCE, "samples": "40", "without": "gap+drag"}
    assert all("film" not in choice.name for choice in choices({}, False))
    # in a scene with these settings, there is nothing to choose
    chosen = {"cage": "no", "surroundings": "none", "load": "5000", "settle": "auto"}
    gone = {one.name for one in known} - {one.name for one in choices(chosen, True)}
    assert gone == {"cage", "surroundings"}
    assert scene_parts.whole_scene(chosen, True, {"cage": "auto"}) == chosen


def test_parts_of_a_cage_ring_are_choices():
    """Parts of a one-piece cage are choices; parts of a land are choices only if a land guides the
    cage."""

    def parts(**scene):
        deck = {"cage": "yes", "cage_guide": "balls"}
        scene = scene_parts.whole_scene(scene, True, deck)
        return {one.name for one in choices(scene, True, deck)}

    ring = {"cage chain", "cage friction", "cage shear", "cage film", "cage churning"}
    assert parts(cage="ring") - parts() == ring
    assert parts(cage="ring", cage_guide="outer") - parts() == ring | {"cage land"}
    assert parts(cage="auto") - parts() == ring
    assert parts(cage="auto", pocket_play="1e-4") == parts()  # data of a chain
    picked = [one for one in choices({"cage": "ring"}, True) if one.name in ring - {"cage chain"}]
    left = variables(picked)["cage_without"]
    assert left == "friction+shear+film+churning"
    assert "without" not in variables(picked)


@pytest.mark.parametrize("cage", ["ring", "chain", "auto"])
@pytest.mark.parametrize("oil", ["mineral", "dry"])
def test_each_choice_changes_only_what_it_names(cage, oil):
    """The deck's cage depends on models and integrator if it is `auto`; choices of those keep the
    cage of the reference, and parts of a ring are omitted only from a ring."""
    deck, wet = deck_variables(ROOT / "inputs/in.6208"), oil != "dry"
    scene = scene_parts.whole_scene({"cage": cage, "lubricant": oil}, wet, deck)
    known = choices(scene, wet, deck)
    words = "" if wet else "dry"

    def chosen(picked):
        every = {**deck, **scene, **variables(picked)}
        if every["cage"] != "auto":
            return every["cage"]
        return core.usual_cage(every["models"], every["integrator"], words, "")

    usual = chosen(())
    assert usual == cage if cage != "auto" else usual == ("ring" if wet else "chain")
    for one in known:
        assert chosen((one,)) == dict(one.settings).get("cage", usual), one.name
    cages = set()
    for picked in sets([one for one in known if "tolerance" not in one.group]):
        parts = "cage_without" in variables(picked)
        assert chosen(picked) == "ring" or not parts, picked
        cages.add((chosen(picked), parts))
    assert (("ring", True) in cages) == (usual == "ring")


def test_evaluations_decide_where_times_overlap():
    """Processor times decide if all of one set are shorter than all of the other."""
    few, many = (Outcome((), {}, {}, 1.0, evaluations, "") for evaluations in (0.2, 0.8))
    last = {"many": many, "few": few}
    for times, name in (([3.0, 9.0, 4.0], "few"), ([6.0, 9.0, 7.0], "many")):
        assert _cheapest(last, {"few": times, "many": [3.5, 4.0, 5.0]})[0] == name
