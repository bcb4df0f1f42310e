# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of `raceway heat --runs` with the real program: the heat balance, runs that are already
finished, failures and messages."""

import json

import pytest
from commands import reply
from raceway.cli import main
from raceway.sweeps import heat_runs
from raceway.theory import heat_scene, steady_heat
from raceway.theory.cage_drag import CageRing

POINT = ["heat", "--load", "5000", "--rpm", "9549", "--lubricant", "vg46"]


pytestmark = pytest.mark.usefixtures("in_the_tree")


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("heat")


def heat(capsys, folder, *more):
    code = main([*POINT, "--program", "build/liggghts", "--out", str(folder), "--json", *more])
    told = capsys.readouterr()
    return code, told.out and json.loads(told.out), told.err


def test_balance_with_the_friction_of_runs(capsys, folder):
    code, found, said = heat(capsys, folder, "--runs", "2")
    case = steady_heat.Case("6208", "vg46", load=5000.0, rpm=9549.0, cage=CageRing())
    scene, conductance = case.scene(), found["conductance_W_K"]
    # a second run follows if friction in the first run changes the temperature by at least CLOSE
    first = round(case.steady(scene)["temperature_C"], 2)
    ran = json.loads(next(folder.glob(f"*temperature={first:.2f}*/summary.json")).read_text())
    scene.share = ran["power_loss_W"] / scene.at(first, 0.0)["power_loss_W"]
    moved = abs(case.steady(scene)["temperature_C"] - first)
    scene.share = 1.0
    assert code == 0 and found["runs"] == (1 if moved < heat_runs.CLOSE else 2)
    assert len(said.splitlines()) == found["runs"]
    # the result uses the friction from statics, scaled by the ratio found in the last run
    there = found["run_temperature_C"]
    of_statics = scene.at(there, 0.0)["power_loss_W"]
    assert found["run_over_statics"] == pytest.approx(found["run_power_W"] / of_statics, rel=1e-9)
    hot = found["temperature_C"]
    carried = conductance * (hot - 20)
    assert found["power_loss_W"] == pytest.approx(carried, abs=0.05)
    power = scene.at(hot, 0.0)["power_loss_W"] * found["run_over_statics"]
    assert power == pytest.approx(carried, abs=0.05)
    still = heat_scene.one_node(scene, conductance, 20.0, 0.0)
    assert hot - 20 == pytest.approx(still["temperature_C"] - 20, rel=1e-2)
    assert sum(found["losses_W"].values()) == pytest.approx(found["run_power_W"], rel=1e-9)
    runs = sorted(folder.glob("*/summary.json"))
    powers = [json.loads(path.read_text())["power_loss_W"] for path in runs]
    assert len(runs) == found["runs"] and found["run_power_W"] in powers
    settings = json.loads(runs[0].read_text())
    assert settings["models"] == "full" and settings["rpm"] == 9549
    (folder / "found.json").write_text(json.dumps(found))


def test_finished_runs_are_not_run_again(capsys, folder):
    first = json.loads((folder / "found.json").read_text())
    before = {path: path.stat().st_mtime_ns for path in folder.glob("*/*")}
    code, again, _ = heat(capsys, folder, "--runs", "2")
    assert code == 0 and again == first
    assert {path: path.stat().st_mtime_ns for path in folder.glob("*/*")} == before


def test_failures(capsys, tmp_path):
    assert "exit code 1" in reply(
        capsys, [*POINT, "--runs", "1", "--program", "false", "--out", str(tmp_path)], code=1
    )
    assert "there is no program 'no-such-program'" in reply(
        capsys, [*POINT, "--runs", "1", "--program", "no-such-program"], code=1
    )


@pytest.mark.parametrize(
    ("more", "message"),
    [
        (["--runs", "0"], "must be a whole number from 1 to 50"),
        (["--out", "x"], "--out applies to runs: give --runs"),
        (["--passes", "2"], "--passes applies to runs: give --runs"),
        (["--runs", "1", "--passes", "0"], "must lie from 1 to 1e+06 passes"),
    ],
)
def test_messages(capsys, more, message):
    assert message in reply(capsys, [*POINT, *more], code=2)
