# SPDX-License-Identifier: GPL-2.0-or-later
"""With the real program, `raceway check` repeats a run with finer settings and adds the errors to
the results for the run."""

import json

import pytest
from host import ROOT, succeed
from raceway.cli import main
from raceway.report.of_run import repeat
from raceway.runs.summary import summary
from raceway.runs.tables import RunTables
from raceway.sweeps.check import WANDERING, variables

COARSE = {
    **{"passes": 1, "samples": 20, "settle": 1, "tolerance": 1e-7, "load": 2000},
    "flaw_outer": "notch -1.5708 1.0e-3 full 1.0e-5 5.0e-5",  # the flaw is stored with the run
    **{"flaw_ball": "wave 2 1.0e-8 0", "flawed_ball": "2 4"},
}


@pytest.fixture(scope="module")
def checked(tmp_path_factory):
    """Return the folder of a run with a coarse tolerance, and the output of `raceway check`."""
    folder = tmp_path_factory.mktemp("check") / "run"
    succeed("inputs/in.6208", out=folder, **COARSE)
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(ROOT)
        assert main(["check", str(folder)]) == 0
    return folder


def test_errors_are_those_of_the_run(checked, tmp_path):
    """Each error equals, to the last digit, the difference from a second run started by hand."""
    figures = summary(RunTables(checked))
    errors = figures["numerical_errors"]
    assert {"q_max_N", "h_min_m", "capacitance_F", "cage_speed_rad_s"} <= set(errors)
    assert "wall_s" not in errors and "load_N" not in errors
    differences = dict.fromkeys(errors, 0.0)
    for name, words in (
        ("fine", {"tolerance": 1e-8}),
        ("many", {"samples": 40, "within": 1}),
        ("settled", {"settle": 101}),
    ):
        succeed("inputs/in.6208", out=tmp_path / name, **{**COARSE, "within": 1, **words})
        tables = RunTables(tmp_path / name)
        other = summary(tables)
        for key in differences:
            differences[key] += abs(other[key] - figures[key])
    # `other` has settled for the longest time
    for key, wander in WANDERING.items():
        assert tables.settings[wander] > 0
        if key in differences:
            differences[key] += tables.settings[wander] * other[key]
    assert "cage_speed_rad_s" in WANDERING
    for key, error in errors.items():
        assert error == pytest.approx(differences[key], rel=1e-9, abs=1e-30), key
    # the error of a coarse run is small but not zero
    assert 0 < errors["q_max_N"] < 0.1 * figures["q_max_N"]


def test_summary_shows_them(checked, capsys):
    assert main(["summary", str(checked)]) == 0
    said = capsys.readouterr().out
    (line,) = (one for one in said.splitlines() if one.lstrip().startswith("largest contact load"))
    assert "±" in line
    assert main(["summary", str(checked), "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["numerical_errors"]["q_max_N"] > 0


def test_of_another_run_they_are_not_shown(checked, tmp_path):
    again = tmp_path / "run"
    succeed("inputs/in.6208", out=again, **COARSE)
    (again / "check.json").write_text((checked / "check.json").read_text())
    assert "numerical_errors" not in summary(RunTables(again))


def test_verlet_takes_half_the_step(tmp_path, monkeypatch):
    monkeypatch.chdir(ROOT)
    words = {"integrator": "verlet", "passes": 1, "samples": 20, "rpm": 9549, "settle": 1}
    succeed("inputs/in.6208", out=tmp_path, **words)
    assert main(["check", str(tmp_path)]) == 0
    steps = [
        RunTables(where).settings["step_s"]
        for where in (tmp_path, tmp_path / "check" / "integration")
    ]
    assert steps[1] == pytest.approx(steps[0] / 2, rel=0.02)  # whole steps between samples


@pytest.mark.parametrize(
    "own",
    [
        {"ball_poisson": 0.1},
        {"ball_density": 3200, "rpm": 10000},
        {"inner_mass": 20, "rpm": 10000},
        {"surroundings": "flooded", "inner_shoulder_diameter": 0.06},
        {"viscosity": 0.1},
        {"bearing": 7208, "axial": 2000},  # the clearance follows from the contact angle
    ],
    ids=str,
)
def test_data_of_ones_own(tmp_path, monkeypatch, own):
    """Bearing and oil data are passed on to the repeated runs. The means of the main deck are
    accurate to 1e-3 by default; if these data were not passed on, the means would change by between
    one and twenty per cent."""
    monkeypatch.chdir(ROOT)
    succeed("inputs/in.6208", out=tmp_path, passes=1, **own)
    before = summary(RunTables(tmp_path))
    assert main(["check", str(tmp_path)]) == 0
    errors = json.loads((tmp_path / "check.json").read_text())["errors"]
    for key in ("force_y_N", "q_max_N", "capacitance_F"):
        if key in errors:  # a run with a heavy ring does not settle
            error = errors[key]["integration"] + errors[key]["sampling"]
            assert error < 1e-3 * abs(before[key]), key
    repeated = repeat(variables(RunTables(tmp_path)))
    assert all(f"-var {name} {value}" in repeated for name, value in own.items())


def test_mistakes(checked, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(ROOT)
    assert main(["check", str(checked), "--program", "nowhere/liggghts"]) == 1
    assert "there is no program 'nowhere/liggghts'" in capsys.readouterr().err
    assert main(["check", str(checked), "--deck", "inputs/in.nowhere"]) == 1
    assert "--deck inputs/in.nowhere: there is no such file" in capsys.readouterr().err
    own = tmp_path / "own"
    succeed("inputs/in.6208", out=own, ball_young=200e9, **COARSE)
    for name, value in (("ball_young", "190e9"), ("ball_poisson", "0.2"), ("load", "100")):
        assert main(["check", str(own), "--var", name, value]) == 1
        assert "give --var for data that were given to the run" in capsys.readouterr().err
    assert main(["check", str(own), "--var", "ball_young", "200e9"]) == 0
    (own / "check.json").write_text("[]")
    assert main(["summary", str(own)]) == 1
    assert "check.json is not a result of raceway check" in capsys.readouterr().err
